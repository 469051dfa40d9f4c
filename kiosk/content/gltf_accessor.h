#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "kiosk/content/gltf_document.h"

namespace onggi::content {

/// The one way to numbers in a glTF file: every index, offset, stride, count and range is checked
/// before a byte is read. Decodes EXT_meshopt_compression, sparse accessors, and the small integers
/// of KHR_mesh_quantization. Keeps decoded views; the document must outlive it.
class GltfReader {
 public:
  explicit GltfReader(const GltfDocument& document) : document_(document) {}

  /// VEC3 of floats or of (normalised) integers. Non-finite numbers are a Problem.
  Result<std::vector<std::array<float, 3>>> vectors(int accessor, const std::string& where);
  /// SCALAR of unsigned integers.
  Result<std::vector<std::uint32_t>> indices(int accessor, const std::string& where);
  /// The bytes of a buffer view, decoded if it was compressed. Valid as long as this reader.
  Result<std::span<const unsigned char>> view(int index, const std::string& where);

 private:
  Result<Bytes> decode_meshopt(const MeshoptView& view, const std::string& where);
  const GltfDocument& document_;
  std::map<int, Bytes> decoded_;
};

/// Vertices and triangles of a primitive as its codec gave them.
struct DecodedPrimitive {
  std::vector<std::array<float, 3>> positions, normals;
  std::vector<std::uint32_t> indices;  ///< Triangles.
};

/// KHR_draco_mesh_compression; a Problem with a remedy where the program was built without Draco.
Result<DecodedPrimitive> decode_draco(std::span<const unsigned char> bytes,
                                      const DracoPrimitive& primitive, const std::string& where);

/// No vessel needs more, and a file that claims more is refused before memory is asked for.
inline constexpr std::size_t kMostElements = std::size_t{1} << 24;

}  // namespace onggi::content
