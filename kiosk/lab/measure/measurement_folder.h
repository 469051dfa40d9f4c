#pragma once

#include <filesystem>

#include "engine/base/result.h"

namespace onggi::measure {

/// A temporary folder for keepsakes and counts of a measurement, which are not visits of the
/// museum. Removed with its content when the object goes.
class MeasurementFolder {
 public:
  /// Problem, exit 1: no temporary folder can be created.
  static Result<MeasurementFolder> make();
  MeasurementFolder(MeasurementFolder&& other) noexcept;
  MeasurementFolder& operator=(MeasurementFolder&&) = delete;
  ~MeasurementFolder();
  const std::filesystem::path& path() const { return path_; }

 private:
  explicit MeasurementFolder(std::filesystem::path path) : path_(std::move(path)) {}
  std::filesystem::path path_;
};

}  // namespace onggi::measure
