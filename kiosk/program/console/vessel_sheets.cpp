#include "kiosk/program/console/vessel_sheets.h"

#include <cstdint>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "engine/math/hash.h"
#include "kiosk/ground/files/file_stamps.h"
#include "kiosk/ground/files/read_file.h"
#include "kiosk/program/console/kept_files.h"

namespace onggi::console {

namespace {

namespace fs = std::filesystem;
constexpr std::size_t kLargestSheet = 8u << 20;  // bytes

/// What is drawn while it is not whole.
fs::path unfinished(const fs::path& sheet) {
  return sheet.parent_path() / (sheet.stem().string() + ".new.png");
}

}  // namespace

void VesselSheets::take() {
  const auto said = drawing_.take();
  if (!said) return;
  std::error_code failed;
  fs::rename(unfinished(wanted_), wanted_, failed);
  if (failed) {
    failed_ = wanted_;
    trouble_ = nlohmann::json::parse(*said, nullptr, false).value("what", "");
    if (trouble_.empty()) trouble_ = "It could not be drawn. Files says what is wrong.";
  }
  keep_newest(folder_, kKept);
}

VesselSheets::Sheet VesselSheets::of(const fs::path& vessel) {
  take();
  StateHash hash;
  for (const char* file : {"vessel.toml", "vessel.glb"})
    for (const char c : files::stamp_of(vessel / file).value_or("none") + vessel.string())
      hash.add(std::uint64_t{static_cast<unsigned char>(c)});
  char name[32];
  std::snprintf(name, sizeof name, "%016llx.png", static_cast<unsigned long long>(hash.value()));
  const fs::path sheet = folder_ / name;
  if (const auto bytes = files::read_file(sheet, kLargestSheet))
    return {.png = {bytes->begin(), bytes->end()}, .trouble = ""};
  if (failed_ == sheet) return {"", trouble_};
  std::error_code failed;
  fs::create_directories(folder_, failed);
  if (drawing_.begin({"vessel", "inspect", vessel.string(), "--json", "-", "--plot",
                      unfinished(sheet).string()}))
    wanted_ = sheet;
  return {};
}

}  // namespace onggi::console
