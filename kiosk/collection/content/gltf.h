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

/// A node of the scene with everything below it: a run of the model's vertices and triangles.
struct GltfPart {
  int node = 0;       ///< Its index in the file.
  std::string name;   ///< The node's name, else its mesh's; may be empty.
  bool mesh = false;  ///< The node itself has a surface.
  std::size_t first_position = 0, positions = 0, first_triangle = 0, triangles = 0;
  /// The share of the node alone; they come first.
  std::size_t own_positions = 0, own_triangles = 0;
};

/// The part of a glTF file that Onggi uses: one mesh of all nodes in world space, in the file's
/// axes.
struct GltfModel {
  TriangleMesh mesh;
  std::vector<GltfPart> parts;  ///< Every node with triangles, parents before children.
  std::array<float, 3> base_color{0.8f, 0.8f, 0.8f};  ///< Linear, of the largest material.
  bool colored = false;  ///< The file gives that colour and no picture for it.
  Coloring coloring;     ///< Colours of the mesh's positions, if the file has more than one colour.
  GltfCredit credit;
  std::vector<std::string> warnings;
};

/// Reads an untrusted GLB or glTF. Files are opened by our own code (beneath the file's folder
/// only, regular files, size limits). JSON size, depth and number of values are checked first,
/// unknown required extensions are refused by name, and every accessor is checked. Allocates in
/// proportion to the file, never beyond `limits`.
Result<GltfModel> read_gltf(const std::filesystem::path& file,
                            const settings::ReaderLimits& limits = {});

}  // namespace onggi::content
