#include "kiosk/exhibit/composition/device_files.h"

#include <map>
#include <string>

#include "kiosk/ground/files/log.h"

namespace fs = std::filesystem;

namespace onggi::exhibit {

fs::path device_file(const settings::Exhibit& exhibit, device::DeviceKind kind) {
  return exhibit.file.parent_path() / "devices" / (std::string(device::info_of(kind).id) + ".toml");
}

device::DeviceRead device_of(const settings::Exhibit& exhibit, device::DeviceKind kind) {
  const fs::path file = device_file(exhibit, kind);
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return {device::default_def(kind), {}, 0};
  return device::read_device(file, device::default_def(kind));
}

device::DeviceWatch::Define defined_devices(const settings::Exhibit& exhibit) {
  std::map<device::DeviceKind, device::DeviceDef> all;
  for (const device::KindInfo& info : device::device_kinds()) {
    const device::DeviceRead read = device_of(exhibit, info.kind);
    files::log_problems(read.problems);
    all[info.kind] = read.def;
  }
  return [all](device::DeviceKind kind) { return all.at(kind); };
}

}  // namespace onggi::exhibit
