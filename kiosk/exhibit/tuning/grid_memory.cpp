#include "kiosk/exhibit/tuning/grid_memory.h"

#include <cstdio>
#include <span>
#include <string_view>

#include "engine/math/hash.h"
#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/read_file.h"
#include "kiosk/ground/toml/toml_text.h"

namespace onggi::tuning {
namespace {

constexpr const char* kFormat =
    "onggi grid, kind 1\nrows %d\nsectors %d\nshape_mm %lf\nworst_mm %lf\nforce_pct %lf\n"
    "tick_pct %lf\nfine_enough %d\nin_time %d\n";
constexpr std::size_t kLongestMemory = 4096;

void add(StateHash& hash, const std::string& text) {
  for (const char c : text) hash.add(std::uint64_t{static_cast<unsigned char>(c)});
}

}  // namespace

Result<std::filesystem::path> memory_of(const std::filesystem::path& folder,
                                        const std::filesystem::path& scene_file,
                                        const std::string& machine) {
  const auto text = toml::read_toml_text(scene_file);
  if (!text) return tl::unexpected(text.error());
  StateHash hash;
  add(hash, machine);
  add(hash, *text);
  char name[32];
  std::snprintf(name, sizeof name, "_%016llx.txt", static_cast<unsigned long long>(hash.value()));
  return folder / "grids" / (scene_file.stem().string() + name);
}

std::optional<TunedGrid> remembered(const std::filesystem::path& memory) {
  const auto bytes = files::read_file(memory, kLongestMemory);
  if (!bytes) return std::nullopt;
  const std::string text(bytes->begin(), bytes->end());
  TunedGrid grid;
  int fine = 0, in_time = 0;
  if (std::sscanf(text.c_str(), kFormat, &grid.rows, &grid.sectors, &grid.shape_mm, &grid.worst_mm,
                  &grid.force_pct, &grid.tick_pct, &fine, &in_time) != 8)
    return std::nullopt;
  grid.fine_enough = fine == 1;
  grid.in_time = in_time == 1;
  ClayDef clay;
  clay.rows = grid.rows;
  clay.sectors = grid.sectors;
  if (!validate(clay, "clay")) return std::nullopt;
  return grid;
}

Result<void> remember(const std::filesystem::path& memory, const TunedGrid& grid,
                      const std::string& machine) {
  char text[600];
  std::snprintf(text, sizeof text,
                "onggi grid, kind 1\nrows %d\nsectors %d\nshape_mm %.6f\nworst_mm %.6f\n"
                "force_pct %.6f\ntick_pct %.6f\nfine_enough %d\nin_time %d\nmachine %.120s\n",
                grid.rows, grid.sectors, grid.shape_mm, grid.worst_mm, grid.force_pct,
                grid.tick_pct, int{grid.fine_enough}, int{grid.in_time}, machine.c_str());
  std::error_code failed;
  std::filesystem::create_directories(memory.parent_path(), failed);
  const std::string_view words(text);
  return files::write_durably(memory, std::as_bytes(std::span(words)));
}

}  // namespace onggi::tuning
