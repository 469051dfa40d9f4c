#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "kiosk/content/gltf.h"

namespace onggi::content {

namespace {

// glTF 2.0 specification, 4.4 (GLB) and 5.1 (component types).
constexpr std::uint32_t kMagic = 0x46546C67, kJson = 0x4E4F534A, kBin = 0x004E4942;
constexpr int kFloat = 5126, kUnsignedInt = 5125, kArrayBuffer = 34962, kElementBuffer = 34963;

class Bytes {
 public:
  void u32(std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8)
      bytes_.push_back(static_cast<std::byte>((value >> shift) & 0xFFu));
  }
  void f32(float value) {
    std::uint32_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    u32(bits);
  }
  void text(const std::string& value) {
    for (const char c : value) bytes_.push_back(static_cast<std::byte>(c));
  }
  void pad(std::byte with) {
    while (bytes_.size() % 4 != 0) bytes_.push_back(with);
  }
  void append(const Bytes& other) {
    bytes_.insert(bytes_.end(), other.bytes_.begin(), other.bytes_.end());
  }
  std::uint32_t size() const { return static_cast<std::uint32_t>(bytes_.size()); }
  std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  std::vector<std::byte> bytes_;
};

}  // namespace

std::vector<std::byte> write_glb(const TriangleMesh& mesh, const std::string& title,
                                 const std::string& copyright, const GlbMaterial& material) {
  using nlohmann::ordered_json;
  const bool normals = mesh.normals.size() == mesh.positions.size() && !mesh.normals.empty();

  Bytes bin;
  ordered_json views = ordered_json::array();
  const auto view = [&](std::uint32_t from, int target) {
    views.push_back({{"buffer", 0},
                     {"byteOffset", from},
                     {"byteLength", bin.size() - from},
                     {"target", target}});
  };
  std::array<float, 3> low, high;
  low.fill(std::numeric_limits<float>::max());
  high.fill(std::numeric_limits<float>::lowest());
  for (const auto& p : mesh.positions)
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
      bin.f32(p[k]);
    }
  view(0, kArrayBuffer);
  std::uint32_t from = bin.size();
  if (normals) {
    for (const auto& n : mesh.normals)
      for (const float v : n) bin.f32(v);
    view(from, kArrayBuffer);
    from = bin.size();
  }
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t i : t) bin.u32(i);
  view(from, kElementBuffer);

  ordered_json accessors = ordered_json::array();
  accessors.push_back({{"bufferView", 0},
                       {"componentType", kFloat},
                       {"count", mesh.positions.size()},
                       {"type", "VEC3"},
                       {"min", low},
                       {"max", high}});
  ordered_json attributes = {{"POSITION", 0}};
  if (normals) {
    accessors.push_back({{"bufferView", 1},
                         {"componentType", kFloat},
                         {"count", mesh.normals.size()},
                         {"type", "VEC3"}});
    attributes["NORMAL"] = 1;
  }
  accessors.push_back({{"bufferView", normals ? 2 : 1},
                       {"componentType", kUnsignedInt},
                       {"count", 3 * mesh.triangles.size()},
                       {"type", "SCALAR"}});

  ordered_json asset = {{"version", "2.0"}, {"generator", "Onggi"}};
  if (!copyright.empty()) asset["copyright"] = copyright;
  // Four digits are more than an eye tells apart, and the same on every machine.
  const auto digits = [](float v) { return std::round(static_cast<double>(v) * 1e4) / 1e4; };
  const ordered_json surface = {
      {"name", material.name},
      {"pbrMetallicRoughness",
       {{"baseColorFactor",
         {digits(material.color[0]), digits(material.color[1]), digits(material.color[2]), 1.0}},
        {"metallicFactor", 0.0},
        {"roughnessFactor", digits(material.roughness)}}}};
  const ordered_json primitive = {
      {"attributes", attributes}, {"indices", normals ? 2 : 1}, {"material", 0}};
  const ordered_json document = {
      {"asset", asset},
      {"scene", 0},
      {"scenes", ordered_json::array({{{"name", title}, {"nodes", {0}}}})},
      {"nodes", ordered_json::array({{{"name", title}, {"mesh", 0}}})},
      {"meshes",
       ordered_json::array({{{"name", title}, {"primitives", ordered_json::array({primitive})}}})},
      {"materials", ordered_json::array({surface})},
      {"accessors", accessors},
      {"bufferViews", views},
      {"buffers", ordered_json::array({{{"byteLength", bin.size()}}})}};

  // Text that is not UTF-8 is mended rather than refused: the pot matters more than its name.
  Bytes json;
  json.text(document.dump(-1, ' ', false, ordered_json::error_handler_t::replace));
  json.pad(std::byte{' '});
  bin.pad(std::byte{0});

  Bytes glb;
  glb.u32(kMagic);
  glb.u32(2);
  glb.u32(12 + 8 + json.size() + 8 + bin.size());
  glb.u32(json.size());
  glb.u32(kJson);
  glb.append(json);
  glb.u32(bin.size());
  glb.u32(kBin);
  glb.append(bin);
  return glb.take();
}

}  // namespace onggi::content
