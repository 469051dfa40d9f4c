#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "kiosk/collection/content/gltf_document.h"

namespace onggi::content {

/// Vertices and triangles of a primitive as its codec gave them.
struct DecodedPrimitive {
  std::vector<std::array<float, 3>> positions, normals;
  std::vector<std::array<float, 3>> colors;  ///< Linear; empty where there are none.
  bool colors_fault = false;                 ///< There are some, and they cannot be read.
  std::vector<std::array<float, 2>> places;  ///< In the picture; the same.
  std::vector<std::uint32_t> indices;        ///< Triangles.
};

/// KHR_draco_mesh_compression, with the places of TEXCOORD_`set`; a Problem with a remedy where the
/// program was built without Draco.
Result<DecodedPrimitive> decode_draco(std::span<const unsigned char> bytes,
                                      const DracoPrimitive& primitive, int set,
                                      const std::string& where,
                                      const settings::ReaderLimits& limits);

}  // namespace onggi::content
