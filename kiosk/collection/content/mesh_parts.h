#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace onggi::content {

/// An object of a mesh file without a scene: OBJ, PLY, STL.
struct MeshPart {
  std::string name;
  std::vector<std::array<float, 3>> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<std::uint8_t, 3>> colors{};  ///< sRGB; empty, or one a position.
};

/// The answer of onggi-mesh, in this machine's byte order: "ONGP", the number of parts, and for
/// each part the sizes of its name, positions, triangles and colours, then those themselves; or
/// "ONGE" and the reason. Sizes have 32 bits. Allocates.
std::vector<std::byte> parts_bytes(const std::vector<MeshPart>& parts);
std::vector<std::byte> refusal_bytes(const std::string& why);

/// Reads that answer without trusting it: every size is checked against the bytes, and every index
/// against its positions. Problem, by `name`, for a refusal or an invalid answer. Allocates in
/// proportion to `bytes`.
Result<std::vector<MeshPart>> parts_of(std::span<const std::byte> bytes, const std::string& name);

}  // namespace onggi::content
