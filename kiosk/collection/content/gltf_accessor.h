#pragma once

#include <array>
#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include "kiosk/collection/content/gltf_document.h"

namespace onggi::content {

/// Reads all numbers of a glTF file: every index, offset, stride, count and range is checked before
/// a byte is read. Decodes EXT_meshopt_compression, sparse accessors, and the small integers of
/// KHR_mesh_quantization. Keeps decoded views. The document must outlive the reader.
class GltfReader {
 public:
  GltfReader(const GltfDocument& document, const settings::ReaderLimits& limits)
      : document_(document), limits_(limits) {}

  /// VEC3 of floats or of (normalised) integers. Non-finite numbers are a Problem; numbers outside
  /// the bounds that the file declares are a warning.
  Result<std::vector<std::array<float, 3>>> vectors(int accessor, const std::string& where);
  /// VEC3 or VEC4 of COLOR_n: linear, 0..1, without its transparency.
  Result<std::vector<std::array<float, 3>>> colors(int accessor, const std::string& where);
  /// VEC2 of TEXCOORD_n.
  Result<std::vector<std::array<float, 2>>> places(int accessor, const std::string& where);
  /// SCALAR of unsigned integers.
  Result<std::vector<std::uint32_t>> indices(int accessor, const std::string& where);
  /// The bytes of a buffer view, decoded if it was compressed. Valid as long as this reader.
  Result<std::span<const unsigned char>> view(int index, const std::string& where);
  /// Warns if the numbers from `low` to `high` lie outside the declared bounds of `accessor` by
  /// more than `slack` of its extent.
  void check_bounds(int accessor, const std::array<double, 3>& low,
                    const std::array<double, 3>& high, double slack);
  /// Warnings about the file, one of each kind for all accessors.
  std::vector<std::string> warnings() const;

 private:
  template <std::size_t N>
  Result<std::vector<std::array<float, N>>> plain(int accessor, int type, bool normalized,
                                                  const std::string& where);
  Result<files::Bytes> decode_meshopt(const MeshoptView& view, const std::string& where);
  const GltfDocument& document_;
  const settings::ReaderLimits limits_;
  std::map<int, files::Bytes> decoded_;
  std::size_t decoded_bytes_ = 0;
  std::set<int> out_of_bounds_;
};

}  // namespace onggi::content
