#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "kiosk/collection/content/coloring.h"
#include "kiosk/collection/content/gltf_accessor.h"
#include "kiosk/collection/content/gltf_draco.h"

namespace tinygltf {
struct Primitive;
}

namespace onggi::content {

/// Gathers the colours of a file's primitives, in the order of their positions, and decodes the
/// named pictures. A faulty colour never makes the vessel fail: the fault is noted once a file. A
/// part without its picture is shown as clay; a faulty COLOR_0 is ignored.
class GltfColors {
 public:
  GltfColors(const GltfDocument& document, const settings::ReaderLimits& limits)
      : document_(document), limits_(limits) {}

  /// The next `count` positions belong to `primitive`. COLOR_0 and TEXCOORD_n come from `draco` if
  /// it is not nullptr, else from `reader`.
  void add(const tinygltf::Primitive& primitive, const DecodedPrimitive* draco, std::size_t count,
           GltfReader& reader);
  /// Everything that was added; empty if it is one colour. Starts a process if there are pictures.
  Coloring finish(GltfReader& reader, std::vector<std::string>& warnings);

 private:
  struct Run {
    std::size_t first = 0, count = 0;
    int material = -1;
    bool colored = false;  ///< By its vertices.
  };
  enum class Left { clay, without };  ///< How its part is then shown.
  void note(const std::string& what, const std::string& why, Left left = Left::clay);
  std::vector<int> decode(GltfReader& reader, Coloring& out);

  const GltfDocument& document_;
  const settings::ReaderLimits limits_;
  std::vector<Run> runs_;
  std::vector<std::array<float, 3>> vertex_colors_;  ///< As long as the last run that has any.
  std::vector<std::array<float, 2>> places_;         ///< The same.
  std::size_t count_ = 0, faults_ = 0, clay_ = 0;
  std::string first_fault_;
};

}  // namespace onggi::content
