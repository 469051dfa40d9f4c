#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/profile/mesh.h"
#include "kiosk/collection/content/coloring.h"
#include "kiosk/collection/content/gltf_credit.h"
#include "kiosk/collection/settings/reader_limits.h"

namespace onggi::content {

/// A node of the scene and what hangs below it: a run of the model's vertices and triangles.
struct GltfPart {
  int node = 0;       ///< Its index in the file.
  std::string name;   ///< Its own, else its mesh's; may be empty.
  bool mesh = false;  ///< It carries a surface itself.
  std::size_t first_position = 0, positions = 0, first_triangle = 0, triangles = 0;
  std::size_t own_positions = 0, own_triangles = 0;  ///< Of the node alone: the first of those.
};

/// What a glTF file holds that Onggi uses: one mesh of all nodes in world space, the file's own
/// axes.
struct GltfModel {
  TriangleMesh mesh;
  std::vector<GltfPart> parts;  ///< Every node that brings triangles, parents before children.
  std::array<float, 3> base_color{0.8f, 0.8f, 0.8f};  ///< Linear, of the largest material.
  bool colored = false;  ///< The file gives that colour; not where it is a picture.
  Coloring coloring;     ///< Of the mesh's positions, where the file has more than that colour.
  GltfCredit credit;
  std::vector<std::string> warnings;
};

/// Reads a GLB or glTF of nobody's making in particular. tinygltf behind our own file access
/// (beneath the file's folder only, regular files, size caps), JSON size, depth and number of
/// values checked first, unknown required extensions refused by name, every accessor checked.
/// Allocates in proportion to the file, and never beyond `limits`.
Result<GltfModel> read_gltf(const std::filesystem::path& file,
                            const settings::ReaderLimits& limits = {});

}  // namespace onggi::content
