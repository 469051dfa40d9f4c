#include "kiosk/collection/content/gltf_accessor.h"

#include <meshoptimizer.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "kiosk/collection/content/vessel_file.h"

namespace onggi::content {

namespace {

constexpr float kMostOfALook = 1e6f;  // larger colours and picture coordinates count as damage
constexpr std::size_t kMostFromNothing = 1u << 20;
/// meshopt's codecs spend at least two bits on each byte of sixteen vertices, and one byte on each
/// triangle or index. A claim of more bytes than this for each encoded byte cannot be true.
constexpr std::size_t kMostDense = 64;

std::size_t component_size(int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      return 0;
  }
}

template <class T>
T load(const unsigned char* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

/// glTF 2.0, section 3.11: normalised integers map to 0..1 or -1..1.
template <class Whole>
float whole_as_float(const unsigned char* at, bool normalized) {
  const float v = load<Whole>(at);
  constexpr auto kMost = static_cast<float>(std::numeric_limits<Whole>::max());
  return normalized ? std::max(v / kMost, -1.0f) : v;
}

float as_float(const unsigned char* at, int type, bool normalized) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return whole_as_float<std::int8_t>(at, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return whole_as_float<std::uint8_t>(at, normalized);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return whole_as_float<std::int16_t>(at, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return whole_as_float<std::uint16_t>(at, normalized);
    default:
      return load<float>(at);
  }
}

std::uint32_t as_index(const unsigned char* at, int type) {
  if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return load<std::uint8_t>(at);
  if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) return load<std::uint16_t>(at);
  return load<std::uint32_t>(at);
}

/// True if `count` elements of `size` bytes, `stride` apart, from `offset`, lie within `bytes`.
bool fits(std::span<const unsigned char> bytes, std::size_t offset, std::size_t stride,
          std::size_t size, std::size_t count) {
  if (count == 0) return true;
  if (size > bytes.size() || offset > bytes.size() - size) return false;
  // The caller bounds count and stride, so the product cannot wrap in 64 bits.
  return stride * (count - 1) <= bytes.size() - size - offset;
}

std::string place(const std::string& where, int accessor) {
  return where + ", accessor " + std::to_string(accessor);
}

/// Calls `make_room()` once all numbers are checked, then `store(element, pointer)` for every
/// element, sparse ones last.
template <class MakeRoom, class Store>
Result<void> each_element(GltfReader& reader, const tinygltf::Model& model, int index,
                          std::size_t components, const std::string& here, MakeRoom&& make_room,
                          Store&& store) {
  const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
  const std::size_t size = components * component_size(accessor.componentType);
  if (accessor.bufferView >= 0) {
    const auto bytes = reader.view(accessor.bufferView, here);
    if (!bytes) return tl::unexpected<Problem>(bytes.error());
    const std::size_t declared =
        model.bufferViews[static_cast<std::size_t>(accessor.bufferView)].byteStride;
    const std::size_t stride = declared == 0 ? size : declared;
    if (stride < size || stride > 4096)
      return unsound(here, "elements of " + std::to_string(size) + " bytes stand " +
                               std::to_string(stride) + " bytes apart.");
    if (!fits(*bytes, accessor.byteOffset, stride, size, accessor.count))
      return unsound(here, std::to_string(accessor.count) + " elements do not fit into the " +
                               std::to_string(bytes->size()) + " bytes of their buffer view.");
    make_room();
    for (std::size_t i = 0; i < accessor.count; ++i)
      store(i, bytes->data() + accessor.byteOffset + i * stride);
  }
  if (!accessor.sparse.isSparse) {
    if (accessor.bufferView < 0) return unsound(here, "it has no data.");
    return {};
  }

  const auto& sparse = accessor.sparse;
  const auto sparse_count = static_cast<std::size_t>(std::max(0, static_cast<int>(sparse.count)));
  const std::size_t index_size = component_size(sparse.indices.componentType);
  const auto places = reader.view(sparse.indices.bufferView, here + ", sparse indices");
  if (!places) return tl::unexpected<Problem>(places.error());
  const auto values = reader.view(sparse.values.bufferView, here + ", sparse values");
  if (!values) return tl::unexpected<Problem>(values.error());
  const auto index_offset = static_cast<std::size_t>(sparse.indices.byteOffset);
  const auto value_offset = static_cast<std::size_t>(sparse.values.byteOffset);
  if (index_size == 0 || sparse_count > accessor.count ||
      !fits(*places, index_offset, index_size, index_size, sparse_count) ||
      !fits(*values, value_offset, size, size, sparse_count))
    return unsound(here, "its sparse part does not fit into its buffer views.");
  if (accessor.bufferView < 0) make_room();  // all zero, except for the sparse part
  for (std::size_t i = 0; i < sparse_count; ++i) {
    const std::uint32_t at =
        as_index(places->data() + index_offset + i * index_size, sparse.indices.componentType);
    if (at >= accessor.count)
      return unsound(here, "its sparse part replaces element " + std::to_string(at) + " of " +
                               std::to_string(accessor.count) + ".");
    store(at, values->data() + value_offset + i * size);
  }
  return {};
}

/// Checks an accessor before any of its bytes are read.
/// `key`: of the limit `most`.
Result<void> check(const tinygltf::Model& model, int index, int type, std::size_t most,
                   const char* key, const std::string& here) {
  if (index < 0 || static_cast<std::size_t>(index) >= model.accessors.size())
    return unsound(here, "there is no such accessor.");
  const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
  if (accessor.type != type)
    return unsound(here, type == TINYGLTF_TYPE_SCALAR
                             ? "it does not hold single numbers."
                             : std::string("it does not hold vectors of ") +
                                   (type == TINYGLTF_TYPE_VEC2 ? "two." : "three."));
  if (accessor.count > most)
    return tl::unexpected(beyond_limit(here,
                                       "it claims " + std::to_string(accessor.count) + " elements",
                                       std::to_string(most), key));
  // Elements without a buffer view cost the file nothing; they are zero except for a sparse part.
  if (accessor.bufferView < 0 && accessor.count > kMostFromNothing)
    return unsound(here,
                   "it claims " + std::to_string(accessor.count) + " elements but has no data.");
  if (component_size(accessor.componentType) == 0)
    return unsound(here, "its numbers are of the unknown type " +
                             std::to_string(accessor.componentType) + ".");
  return {};
}

}  // namespace

Result<std::span<const unsigned char>> GltfReader::view(int index, const std::string& where) {
  const std::string here = where + ", buffer view " + std::to_string(index);
  const auto& views = document_.model->bufferViews;
  if (index < 0 || static_cast<std::size_t>(index) >= views.size())
    return unsound(here, "there is no such buffer view.");
  if (const auto packed = document_.meshopt.find(index); packed != document_.meshopt.end()) {
    auto found = decoded_.find(index);
    if (found == decoded_.end()) {
      auto bytes = decode_meshopt(packed->second, here);
      if (!bytes) return tl::unexpected<Problem>(bytes.error());
      found = decoded_.emplace(index, std::move(*bytes)).first;
    }
    return std::span<const unsigned char>(found->second);
  }
  const tinygltf::BufferView& view = views[static_cast<std::size_t>(index)];
  if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= document_.buffers.size())
    return unsound(here, "there is no buffer " + std::to_string(view.buffer) + ".");
  const std::span<const unsigned char> buffer =
      document_.buffers[static_cast<std::size_t>(view.buffer)];
  if (view.byteOffset > buffer.size() || view.byteLength > buffer.size() - view.byteOffset)
    return unsound(here, "it extends past the end of its buffer of " +
                             std::to_string(buffer.size()) + " bytes.");
  return buffer.subspan(view.byteOffset, view.byteLength);
}

Result<files::Bytes> GltfReader::decode_meshopt(const MeshoptView& view, const std::string& where) {
  if (view.buffer >= document_.buffers.size())
    return unsound(where, "its compressed data is in no buffer of the file.");
  const std::span<const unsigned char> buffer = document_.buffers[view.buffer];
  if (view.offset > buffer.size() || view.length > buffer.size() - view.offset)
    return unsound(where, "its compressed data extends past the end of its buffer.");
  const bool attributes = view.mode == "ATTRIBUTES";
  const bool stride_good = attributes
                               ? view.stride % 4 == 0 && view.stride > 0 && view.stride <= 256
                               : view.stride == 2 || view.stride == 4;
  const bool triangles = view.mode == "TRIANGLES";
  const auto most = static_cast<std::size_t>(3) *
                    static_cast<std::size_t>(std::max(limits_.vertices, limits_.triangles));
  if (view.count > most)
    return tl::unexpected(beyond_limit(where,
                                       "it claims " + std::to_string(view.count) + " elements",
                                       std::to_string(most), "vertices or triangles"));
  if (!stride_good || (triangles && view.count % 3 != 0) ||
      (!attributes && !triangles && view.mode != "INDICES"))
    return unsound(where, "the numbers of its meshopt compression are inconsistent.");
  const std::size_t size = view.count * view.stride;
  if (size / kMostDense > view.length)
    return unsound(where, "its meshopt compression claims to hold " + std::to_string(size) +
                              " bytes, more than it can.");
  if (size > (static_cast<std::size_t>(limits_.file_mb) << 20) - decoded_bytes_)
    return tl::unexpected(beyond_limit(where,
                                       "what is compressed by meshopt has " +
                                           std::to_string((size + decoded_bytes_) >> 20) +
                                           " MiB in all",
                                       std::to_string(limits_.file_mb) + " MiB", "file_mb"));
  decoded_bytes_ += size;
  files::Bytes out(size);
  if (out.empty()) return out;
  const unsigned char* from = buffer.data() + view.offset;
  int fault = 0;
  if (attributes)
    fault = meshopt_decodeVertexBuffer(out.data(), view.count, view.stride, from, view.length);
  else if (triangles)
    fault = meshopt_decodeIndexBuffer(out.data(), view.count, view.stride, from, view.length);
  else
    fault = meshopt_decodeIndexSequence(out.data(), view.count, view.stride, from, view.length);
  if (fault != 0) return unsound(where, "its meshopt compression is damaged.");
  if (view.filter.empty() || view.filter == "NONE") return out;
  if (view.filter == "OCTAHEDRAL" && (view.stride == 4 || view.stride == 8))
    meshopt_decodeFilterOct(out.data(), view.count, view.stride);
  else if (view.filter == "QUATERNION" && view.stride == 8)
    meshopt_decodeFilterQuat(out.data(), view.count, view.stride);
  else if (view.filter == "EXPONENTIAL" && view.stride % 4 == 0)
    meshopt_decodeFilterExp(out.data(), view.count, view.stride);
  else
    return unsound(where, "its meshopt filter does not suit its data.");
  return out;
}

Result<std::vector<std::array<float, 3>>> GltfReader::vectors(int accessor,
                                                              const std::string& where) {
  const std::string here = place(where, accessor);
  const tinygltf::Model& model = *document_.model;
  if (auto good = check(model, accessor, TINYGLTF_TYPE_VEC3,
                        static_cast<std::size_t>(limits_.vertices), "vertices", here);
      !good)
    return tl::unexpected<Problem>(good.error());
  const tinygltf::Accessor& a = model.accessors[static_cast<std::size_t>(accessor)];
  if (a.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)
    return unsound(here, "vectors cannot use 32-bit whole numbers.");
  const std::size_t size = component_size(a.componentType);
  std::vector<std::array<float, 3>> out;
  std::size_t bad = a.count;
  std::array<double, 3> low, high;
  low.fill(1e300);
  high.fill(-1e300);
  const auto read = each_element(
      *this, model, accessor, 3, here, [&] { out.resize(a.count); },
      [&](std::size_t i, const unsigned char* at) {
        for (std::size_t k = 0; k < 3; ++k) {
          out[i][k] = as_float(at + k * size, a.componentType, a.normalized);
          if (!std::isfinite(out[i][k])) bad = std::min(bad, i);
          const double stored = as_float(at + k * size, a.componentType, false);
          low[k] = std::min(low[k], stored);
          high[k] = std::max(high[k], stored);
        }
      });
  if (!read) return tl::unexpected<Problem>(read.error());
  if (bad < a.count)
    return unsound(here, "element " + std::to_string(bad) + " is not a finite number.");
  if (a.count > 0) check_bounds(accessor, low, high, 1e-4);
  return out;
}

template <std::size_t N>
Result<std::vector<std::array<float, N>>> GltfReader::plain(int accessor, int type, bool normalized,
                                                            const std::string& where) {
  const std::string here = place(where, accessor);
  const tinygltf::Model& model = *document_.model;
  if (auto good = check(model, accessor, type, static_cast<std::size_t>(limits_.vertices),
                        "vertices", here);
      !good)
    return tl::unexpected<Problem>(good.error());
  const tinygltf::Accessor& a = model.accessors[static_cast<std::size_t>(accessor)];
  if (a.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)
    return unsound(here, "vectors cannot use 32-bit whole numbers.");
  const std::size_t size = component_size(a.componentType);
  const std::size_t components = type == TINYGLTF_TYPE_VEC4 ? 4 : N;
  std::vector<std::array<float, N>> out;
  bool good = true;
  const auto read = each_element(
      *this, model, accessor, components, here, [&] { out.resize(a.count); },
      [&](std::size_t i, const unsigned char* at) {
        for (std::size_t k = 0; k < N; ++k) {
          out[i][k] = as_float(at + k * size, a.componentType, normalized || a.normalized);
          good = good && std::abs(out[i][k]) <= kMostOfALook;
        }
      });
  if (!read) return tl::unexpected<Problem>(read.error());
  if (!good) return unsound(here, "a number in it is not finite, or too large.");
  return out;
}

Result<std::vector<std::array<float, 3>>> GltfReader::colors(int accessor,
                                                             const std::string& where) {
  const auto& all = document_.model->accessors;
  const bool four = accessor >= 0 && static_cast<std::size_t>(accessor) < all.size() &&
                    all[static_cast<std::size_t>(accessor)].type == TINYGLTF_TYPE_VEC4;
  // Whole numbers are shares of the most they can be, whether the file says so or not.
  return plain<3>(accessor, four ? TINYGLTF_TYPE_VEC4 : TINYGLTF_TYPE_VEC3, true, where);
}

Result<std::vector<std::array<float, 2>>> GltfReader::places(int accessor,
                                                             const std::string& where) {
  return plain<2>(accessor, TINYGLTF_TYPE_VEC2, false, where);
}

void GltfReader::check_bounds(int accessor, const std::array<double, 3>& low,
                              const std::array<double, 3>& high, double slack) {
  const auto declared = document_.bounds.find(accessor);
  if (declared == document_.bounds.end()) return;
  double reach = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
    reach = std::max({reach, high[k] - low[k], declared->second.high[k] - declared->second.low[k]});
  for (std::size_t k = 0; k < 3; ++k) {
    if (low[k] >= declared->second.low[k] - slack * reach &&
        high[k] <= declared->second.high[k] + slack * reach)
      continue;
    out_of_bounds_.insert(accessor);
    return;
  }
}

std::vector<std::string> GltfReader::warnings() const {
  if (out_of_bounds_.empty()) return {};
  const std::size_t more = out_of_bounds_.size() - 1;
  return {"The numbers of accessor " + std::to_string(*out_of_bounds_.begin()) +
          (more > 0 ? " and " + std::to_string(more) + " more" : "") +
          " lie outside the bounds declared for them; they are used as they are."};
}

Result<std::vector<std::uint32_t>> GltfReader::indices(int accessor, const std::string& where) {
  const std::string here = place(where, accessor);
  const tinygltf::Model& model = *document_.model;
  if (auto good = check(model, accessor, TINYGLTF_TYPE_SCALAR,
                        static_cast<std::size_t>(3) * static_cast<std::size_t>(limits_.triangles),
                        "triangles", here);
      !good)
    return tl::unexpected<Problem>(good.error());
  const tinygltf::Accessor& a = model.accessors[static_cast<std::size_t>(accessor)];
  if (a.componentType != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE &&
      a.componentType != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
      a.componentType != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)
    return unsound(here, "indices must be unsigned whole numbers.");
  std::vector<std::uint32_t> out;
  const auto read = each_element(
      *this, model, accessor, 1, here, [&] { out.resize(a.count); },
      [&](std::size_t i, const unsigned char* at) { out[i] = as_index(at, a.componentType); });
  if (!read) return tl::unexpected<Problem>(read.error());
  return out;
}

}  // namespace onggi::content
