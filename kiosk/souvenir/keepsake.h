#pragma once

#include <cstddef>
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
  /// The visit's folder: "2026-05-04_141503_" and the vessel's id. What no file name should hold
  /// becomes '_'; a name that is taken gets "_2", "_3"...
  std::string name;
  view::Image postcard;  ///< 1500 x 2100.
  Caption caption;
  std::vector<std::byte> glb;     ///< Made by content::write_glb.
  TriangleMesh pot;               ///< For the STL, metres (written in millimetres).
  std::vector<std::byte> replay;  ///< May be empty.
};

/// Where they lie. A path is empty where there was nothing to write.
struct KeepsakeFiles {
  std::filesystem::path folder;
  std::filesystem::path png, jpeg, glb, stl, replay;
};

/// Writes `<folder>/<name>/{postcard.png,postcard.jpg,pot.glb,pot.stl,visit.onggi}`, then removes
/// the oldest visits beyond `quota_mb` (MB of 10^6 bytes; never the one just written). A visit is
/// whole or absent, whenever the power goes: it is written as `<name>.partial` and renamed.
/// Nothing is ever removed but folders that save() wrote. On a Problem (exit 1) nothing
/// half-written is left. Blocks (worker thread); not two at once for the same folder.
Result<KeepsakeFiles> save(const Keepsake& keepsake, const std::filesystem::path& folder,
                           int quota_mb);

/// Removes the oldest visits of `folder` until the rest is within `quota_mb`, but never the folder
/// named `keep`, and what a power cut left of visits more than an hour ago. A visit is a folder
/// whose name begins with a date and time and that holds nothing but save()'s files; all else
/// stays.
void tidy(const std::filesystem::path& folder, int quota_mb, const std::string& keep = {});

}  // namespace onggi::souvenir
