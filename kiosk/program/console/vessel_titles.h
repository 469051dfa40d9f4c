#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "kiosk/ground/files/json.h"
#include "kiosk/program/console/site.h"

namespace onggi::console {

/// What the labels on the shelf call their vessels, so that the desk knows them by the names that
/// visitors read. One thread; reads a label anew when its file has changed.
class VesselTitles {
 public:
  using Titles = std::map<std::string, std::string>;  ///< By language, "ko".
  /// `site` stays with the caller.
  explicit VesselTitles(Site& site) : site_(site) {}
  /// None for a vessel that is not there, and for one without a label.
  const Titles& of(const std::string& id);
  /// {LANGUAGE: title}
  files::Json json_of(const std::string& id);
  /// True if one of its titles has `words` in it, whichever their case.
  bool has(const std::string& id, const std::string& words);

 private:
  struct Read {
    std::filesystem::file_time_type at;
    Titles titles;
  };
  Site& site_;
  std::map<std::string, Read> read_;
};

}  // namespace onggi::console
