#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/profile/mesh.h"

namespace onggi::content {

/// glTF 2.0, section 4.4: "glTF", and the two chunks that a GLB may have.
inline constexpr std::uint32_t kGlbMagic = 0x46546C67, kGlbJson = 0x4E4F534A, kGlbBin = 0x004E4942;

/// The surface of a written GLB. Default: a red stoneware clay, unglazed.
struct GlbMaterial {
  std::string name = "clay";
  std::array<float, 3> color{0.342f, 0.162f, 0.078f};  ///< Linear, 0..1.
  float roughness = 0.9f;                              ///< 0..1
};

/// The triangles of a GLB from `first` up to the next part's.
struct GlbPart {
  std::size_t first = 0;
  GlbMaterial material;
};

/// A PNG or JPEG that colours the surface, and where each position lies in it: 0..1 from its left
/// and from its top. It goes round from left to right, and ends above and below.
struct GlbPicture {
  std::vector<std::array<float, 2>> places;
  std::vector<std::byte> file;
  /// Pictures of the same surface; empty: none. How rough it is, 0..1, in green (glTF 2.0, 3.9.2):
  /// it replaces the materials' roughness.
  std::vector<std::byte> roughness{};
  /// And where it faces (3.9.3). Needs normals and `tangents`.
  std::vector<std::byte> normals{};
  /// Of each position: the direction to the pictures' right, of unit length, and the side on which
  /// their top lies (3.7.2.1): 1 or -1. Empty: none.
  std::vector<std::array<float, 4>> tangents{};
};

/// A GLB of one mesh with one material; `title` and `copyright` go into the asset. `colors` is
/// empty or has one colour a position, linear, 0..1, written as COLOR_0. The bytes are
/// deterministic.
std::vector<std::byte> write_glb(const TriangleMesh& mesh, const std::string& title,
                                 const std::string& copyright, const GlbMaterial& material = {},
                                 const std::vector<std::array<float, 3>>& colors = {});
/// The same with a picture, whose colours replace the material's.
std::vector<std::byte> write_glb(const TriangleMesh& mesh, const std::string& title,
                                 const std::string& copyright, const GlbMaterial& material,
                                 const GlbPicture& picture);
/// The same with one material for each of `parts`; the first part begins at 0. Indices have
/// `index_bytes`, 2 or 4; they have 4 where 2 cannot name every position.
std::vector<std::byte> write_glb(const TriangleMesh& mesh, const std::string& title,
                                 const std::string& copyright, const std::vector<GlbPart>& parts,
                                 const std::vector<std::array<float, 3>>& colors = {},
                                 std::size_t index_bytes = 4, const GlbPicture& picture = {});

}  // namespace onggi::content
