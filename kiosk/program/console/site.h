#pragma once

#include <filesystem>
#include <string>

#include "engine/base/result.h"
#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/ground/files/file_stamps.h"

namespace onggi::console {

/// The exhibit that the page is about, read anew when its file has changed. One thread.
class Site {
 public:
  /// `folder`: the site, the one above config/exhibit.toml, or that file. Problem, exit 2: there is
  /// none.
  static Result<Site> open(const std::filesystem::path& folder);

  const std::filesystem::path& file() const { return file_; }
  /// Values that the file has wrong are the defaults.
  const settings::Exhibit& exhibit();
  /// What visitors read as its title, in its first language.
  std::string title();

 private:
  explicit Site(std::filesystem::path file) : file_(std::move(file)) {}
  std::filesystem::path file_;
  settings::Exhibit exhibit_;
  std::string stamp_;
};

}  // namespace onggi::console
