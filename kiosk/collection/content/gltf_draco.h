#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "kiosk/collection/content/gltf_document.h"

namespace onggi::content {

/// Vertices and triangles of a primitive, decoded.
struct DecodedPrimitive {
  std::vector<std::array<float, 3>> positions, normals;
  std::vector<std::array<float, 3>> colors;  ///< Linear; empty if there are none.
  bool colors_fault = false;                 ///< There are colours, but they cannot be read.
  std::vector<std::array<float, 2>> places;  ///< Picture coordinates; empty if there are none.
  std::vector<std::uint32_t> indices;        ///< Triangles.
};

/// Decodes KHR_draco_mesh_compression with the coordinates of TEXCOORD_`set`. Problem if the
/// program was built without Draco.
Result<DecodedPrimitive> decode_draco(std::span<const unsigned char> bytes,
                                      const DracoPrimitive& primitive, int set,
                                      const std::string& where,
                                      const settings::ReaderLimits& limits);

}  // namespace onggi::content
