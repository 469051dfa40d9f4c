#include "kiosk/collection/content/gltf_draco.h"

#include "kiosk/collection/content/vessel_file.h"

#ifdef ONGGI_HAS_DRACO
#include <draco/compression/decode.h>
#endif

#include <algorithm>
#include <cmath>
#include <exception>

namespace onggi::content {

#ifdef ONGGI_HAS_DRACO

namespace {

/// The largest value of the integer type `type`; 1 for any other type.
float most_of(draco::DataType type) {
  switch (type) {
    case draco::DT_INT8:
      return 127.0f;
    case draco::DT_UINT8:
      return 255.0f;
    case draco::DT_INT16:
      return 32767.0f;
    case draco::DT_UINT16:
      return 65535.0f;
    case draco::DT_INT32:
      return 2147483647.0f;
    case draco::DT_UINT32:
      return 4294967295.0f;
    default:
      return 1.0f;
  }
}

/// The first N components of an attribute that has at most `most`. `shares`: integers are
/// normalised (glTF 2.0, section 3.6.2.2), which exporters write into glTF's accessor and seldom
/// into Draco.
template <std::size_t N>
bool copy_attribute(const draco::Mesh& mesh, int id, std::vector<std::array<float, N>>& out,
                    bool shares = false, int most = N) {
  const draco::PointAttribute* attribute =
      id < 0 ? nullptr : mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(id));
  if (attribute == nullptr || attribute->num_components() < static_cast<int>(N) ||
      attribute->num_components() > most)
    return false;
  const float whole = shares && !attribute->normalized() ? most_of(attribute->data_type()) : 1.0f;
  out.resize(mesh.num_points());
  for (std::uint32_t i = 0; i < mesh.num_points(); ++i) {
    const auto value = attribute->mapped_index(draco::PointIndex(i));
    if (value.value() >= attribute->size() ||
        !attribute->ConvertValue<float>(value, static_cast<std::int8_t>(N), out[i].data()))
      return false;
    for (float& v : out[i]) {
      if (!std::isfinite(v)) return false;
      if (whole > 1.0f) v = std::max(v / whole, -1.0f);
    }
  }
  return true;
}

}  // namespace

Result<DecodedPrimitive> decode_draco(std::span<const unsigned char> bytes,
                                      const DracoPrimitive& primitive, int set,
                                      const std::string& where,
                                      const settings::ReaderLimits& limits) {
  const auto damaged = [&] {
    return problem(where, "its Draco compression is damaged.",
                   "Export the vessel again, without compression if need be.");
  };
  try {
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    draco::Decoder decoder;
    auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
    if (!decoded.ok() || decoded.value() == nullptr) return damaged();
    const draco::Mesh& mesh = *decoded.value();
    if (mesh.num_points() > static_cast<std::size_t>(limits.vertices) ||
        mesh.num_faces() > static_cast<std::size_t>(limits.triangles))
      return tl::unexpected(beyond_limit(where,
                                         "its Draco compression holds " +
                                             std::to_string(mesh.num_points()) + " vertices and " +
                                             std::to_string(mesh.num_faces()) + " triangles",
                                         std::to_string(limits.vertices) + " vertices and " +
                                             std::to_string(limits.triangles) + " triangles",
                                         "vertices or triangles"));
    DecodedPrimitive out;
    if (!copy_attribute(mesh, primitive.position, out.positions)) return damaged();
    if (!copy_attribute(mesh, primitive.normal, out.normals)) out.normals.clear();
    if (!copy_attribute(mesh, primitive.color, out.colors, true, 4)) {
      out.colors.clear();
      out.colors_fault = primitive.color >= 0;
    }
    if (const auto id = primitive.places.find(set);
        id == primitive.places.end() ||
        !copy_attribute(mesh, id->second, out.places, primitive.normalized.count(set) > 0))
      out.places.clear();
    out.indices.reserve(std::size_t{3} * mesh.num_faces());
    for (std::uint32_t f = 0; f < mesh.num_faces(); ++f)
      for (const draco::PointIndex& corner : mesh.face(draco::FaceIndex(f)))
        out.indices.push_back(corner.value());
    return out;
  } catch (const std::exception&) {
    return damaged();
  }
}

#else

Result<DecodedPrimitive> decode_draco(std::span<const unsigned char>, const DracoPrimitive&, int,
                                      const std::string& where, const settings::ReaderLimits&) {
  return problem(where, "it is compressed with Draco, and this program was built without it.",
                 "Export the vessel without Draco compression, or build with libdraco-dev.");
}

#endif

}  // namespace onggi::content
