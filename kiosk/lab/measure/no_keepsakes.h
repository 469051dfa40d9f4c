#pragma once

#include <filesystem>

#include "engine/base/result.h"

namespace onggi::measure {

/// A folder for keepsakes and counts that nobody wants: what a measurement does at the wheel is no
/// visit of the museum's. Gone with the object, and all that is in it.
class NoKeepsakes {
 public:
  /// Problem, exit 1: there is no temporary folder to be had.
  static Result<NoKeepsakes> make();
  NoKeepsakes(NoKeepsakes&& other) noexcept;
  NoKeepsakes& operator=(NoKeepsakes&&) = delete;
  ~NoKeepsakes();
  const std::filesystem::path& path() const { return path_; }

 private:
  explicit NoKeepsakes(std::filesystem::path path) : path_(std::move(path)) {}
  std::filesystem::path path_;
};

}  // namespace onggi::measure
