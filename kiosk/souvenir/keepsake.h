#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/profile/mesh.h"
#include "kiosk/souvenir/encode.h"
#include "kiosk/view/image.h"

namespace onggi::souvenir {

/// Everything a visitor takes home from one visit.
struct Keepsake {
  std::string name;      ///< Folder or file stem: "2026-05-04_141503_moon_jar".
  view::Image postcard;  ///< 1500 x 2100.
  Caption caption;
  std::vector<std::byte> glb;     ///< Made by content::write_glb.
  TriangleMesh pot;               ///< For the STL, metres (written in millimetres).
  std::vector<std::byte> replay;  ///< May be empty.
};

struct KeepsakeFiles {
  std::filesystem::path folder;
  std::filesystem::path png, jpeg, glb, stl, replay;
};

/// Writes `<folder>/<name>/{postcard.png,postcard.jpg,pot.glb,pot.stl,visit.onggi}`, then removes
/// the oldest visits beyond `quota_mb`. On a Problem nothing half-written is left. Blocks (worker
/// thread).
Result<KeepsakeFiles> save(const Keepsake& keepsake, const std::filesystem::path& folder,
                           int quota_mb);

/// Binary STL in millimetres, z up, as slicers expect. Deterministic bytes.
std::vector<std::byte> write_stl(const TriangleMesh& mesh, const std::string& title);

}  // namespace onggi::souvenir
