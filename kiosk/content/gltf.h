#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/profile/mesh.h"

namespace onggi::content {

/// What a glTF file holds that Onggi uses: one mesh of all nodes in world space, the file's own
/// axes.
struct GltfModel {
  TriangleMesh mesh;
  std::array<float, 3> base_color{0.8f, 0.8f, 0.8f};  ///< Linear, of the largest material.
  bool colored = false;   ///< The file gives that colour; not where it is an image.
  std::string copyright;  ///< asset.copyright
  std::vector<std::string> warnings;
};

/// Reads a GLB or glTF of nobody's making in particular. tinygltf behind our own file access
/// (beneath the file's folder only, regular files, size caps), JSON depth and size checked first,
/// unknown required extensions refused by name, every accessor checked. Allocates in proportion to
/// the file.
Result<GltfModel> read_gltf(const std::filesystem::path& file);

/// A GLB of one mesh with a clay material; `title`, `copyright` go into the asset. Deterministic
/// bytes.
std::vector<std::byte> write_glb(const TriangleMesh& mesh, const std::string& title,
                                 const std::string& copyright);

}  // namespace onggi::content
