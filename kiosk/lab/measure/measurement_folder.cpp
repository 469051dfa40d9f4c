#include "kiosk/lab/measure/measurement_folder.h"

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>
#include <utility>

namespace onggi::measure {

namespace fs = std::filesystem;

Result<MeasurementFolder> MeasurementFolder::make() {
  std::error_code error;
  std::string name = (fs::temp_directory_path(error) / "onggi-measure-XXXXXX").string();
  if (!error && mkdtemp(name.data()) == nullptr) error.assign(errno, std::generic_category());
  if (!error) return MeasurementFolder(name);
  return problem(name, "A temporary folder cannot be created: " + error.message() + ".",
                 "Free some space there, or set TMPDIR to a writable folder.", 1);
}

MeasurementFolder::MeasurementFolder(MeasurementFolder&& other) noexcept
    : path_(std::exchange(other.path_, fs::path())) {}

MeasurementFolder::~MeasurementFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

}  // namespace onggi::measure
