#include "kiosk/program/console/vessel_sheets.h"

#include <cstdint>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <span>

#include "engine/math/hash.h"
#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/file_stamps.h"
#include "kiosk/ground/files/read_file.h"
#include "kiosk/program/console/kept_files.h"
#include "kiosk/program/console/side_view.h"

namespace onggi::console {

namespace {

namespace fs = std::filesystem;
constexpr std::size_t kLargestSheet = 8u << 20;  // bytes

fs::path outline_file(fs::path sheet) { return sheet.replace_extension(".svg"); }

std::string text_of(const fs::path& file) {
  const auto bytes = files::read_file(file, kLargestSheet);
  return bytes ? std::string(bytes->begin(), bytes->end()) : std::string();
}

/// From what `onggi vessel inspect` tells of the vessel; "" where it tells nothing.
std::string outline_of(const std::string& told) {
  const auto vessel = nlohmann::json::parse(told, nullptr, false);
  if (!vessel.is_object() || !vessel.contains("outer")) return {};
  Section section;
  section.outline.emplace_back(Vec2{0.0, 0.0});
  for (const auto& point : vessel["outer"])
    if (point.is_array() && point.size() == 2 && point[0].is_number() && point[1].is_number())
      section.outline.emplace_back(Vec2{point[1].get<double>(), point[0].get<double>()});
  return side_view(section);
}

/// What is drawn while it is not whole.
fs::path unfinished(const fs::path& sheet) {
  return sheet.parent_path() / (sheet.stem().string() + ".new.png");
}

}  // namespace

void VesselSheets::take() {
  const auto said = drawing_.take();
  if (!said) return;
  std::error_code failed;
  if (const std::string outline = outline_of(*said); !outline.empty())
    static_cast<void>(
        files::write_durably(outline_file(wanted_), std::as_bytes(std::span(outline))));
  fs::rename(unfinished(wanted_), wanted_, failed);
  if (failed) {
    std::string& trouble = failed_[wanted_];
    trouble = nlohmann::json::parse(*said, nullptr, false).value("what", "");
    if (trouble.empty()) trouble = "It could not be drawn. Files says what is wrong.";
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
    return {{bytes->begin(), bytes->end()}, text_of(outline_file(sheet)), ""};
  if (const auto found = failed_.find(sheet); found != failed_.end())
    return {"", "", found->second};
  std::error_code failed;
  fs::create_directories(folder_, failed);
  if (!drawing_.under_way()) fs::remove(unfinished(sheet), failed);
  if (drawing_.begin({"vessel", "inspect", vessel.string(), "--json", "-", "--plot",
                      unfinished(sheet).string()}))
    wanted_ = sheet;
  return {};
}

}  // namespace onggi::console
