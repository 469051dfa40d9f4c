#include "kiosk/content/glb.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "kiosk/files/byte_writer.h"

namespace onggi::content {

namespace {

// glTF 2.0 specification, 4.4 (GLB) and 5.1 (component types).
constexpr std::uint32_t kMagic = 0x46546C67, kJson = 0x4E4F534A, kBin = 0x004E4942;
constexpr int kFloat = 5126, kUnsignedInt = 5125, kArrayBuffer = 34962, kElementBuffer = 34963;

}  // namespace

std::vector<std::byte> write_glb(const TriangleMesh& mesh, const std::string& title,
                                 const std::string& copyright, const GlbMaterial& material) {
  using nlohmann::ordered_json;
  const bool normals = mesh.normals.size() == mesh.positions.size() && !mesh.normals.empty();

  files::ByteWriter bin;
  ordered_json views = ordered_json::array();
  const auto view = [&](std::size_t from, int target) {
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
  std::size_t from = bin.size();
  if (normals) {
    for (const auto& n : mesh.normals) bin.f32s(n);
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
  files::ByteWriter json;
  json.text(document.dump(-1, ' ', false, ordered_json::error_handler_t::replace));
  json.pad(4, ' ');
  bin.pad(4, '\0');

  files::ByteWriter glb;
  glb.u32(kMagic);
  glb.u32(2);
  glb.u32(static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + bin.size()));
  glb.u32(static_cast<std::uint32_t>(json.size()));
  glb.u32(kJson);
  glb.append(json.bytes());
  glb.u32(static_cast<std::uint32_t>(bin.size()));
  glb.u32(kBin);
  glb.append(bin.bytes());
  return glb.take();
}

}  // namespace onggi::content
