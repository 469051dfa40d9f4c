#include "kiosk/collection/content/glb.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kiosk/ground/files/byte_writer.h"
#include "kiosk/ground/files/json.h"

namespace onggi::content {

namespace {

// glTF 2.0 specification, 4.4 (GLB) and 5.1 (component types).
constexpr int kUnsignedShort = 5123, kFloat = 5126, kUnsignedInt = 5125, kArrayBuffer = 34962,
              kElementBuffer = 34963, kRepeat = 10497, kClamp = 33071;

using files::Json;

/// The textures' numbers; -1: there is none.
struct Textures {
  int color = -1, roughness = -1, normals = -1;
};

Json json_of(const GlbMaterial& material, const Textures& textures) {
  // Four digits are finer than the eye, and they are the same on every machine.
  const auto digits = [](float v) { return std::round(static_cast<double>(v) * 1e4) / 1e4; };
  Json surface = Json::object({});
  if (textures.color >= 0)
    surface["baseColorTexture"] = Json::object({{"index", textures.color}});
  else
    surface["baseColorFactor"] = Json::list(
        {digits(material.color[0]), digits(material.color[1]), digits(material.color[2]), 1.0});
  surface["metallicFactor"] = 0.0;
  if (textures.roughness >= 0) {
    surface["roughnessFactor"] = 1.0;
    surface["metallicRoughnessTexture"] = Json::object({{"index", textures.roughness}});
  } else {
    surface["roughnessFactor"] = digits(material.roughness);
  }
  Json out = Json::object({{"name", material.name}, {"pbrMetallicRoughness", surface}});
  if (textures.normals >= 0) out["normalTexture"] = Json::object({{"index", textures.normals}});
  return out;
}

}  // namespace

std::vector<std::byte> write_glb(const TriangleMesh& mesh, const std::string& title,
                                 const std::string& copyright, const GlbMaterial& material,
                                 const std::vector<std::array<float, 3>>& colors) {
  return write_glb(mesh, title, copyright, std::vector<GlbPart>{{0, material}}, colors);
}

std::vector<std::byte> write_glb(const TriangleMesh& mesh, const std::string& title,
                                 const std::string& copyright, const GlbMaterial& material,
                                 const GlbPicture& picture) {
  return write_glb(mesh, title, copyright, std::vector<GlbPart>{{0, material}}, {}, 4, picture);
}

std::vector<std::byte> write_glb(const TriangleMesh& mesh, const std::string& title,
                                 const std::string& copyright, const std::vector<GlbPart>& parts,
                                 const std::vector<std::array<float, 3>>& colors,
                                 std::size_t index_bytes, const GlbPicture& picture) {
  // The greatest index of two bytes means something else (glTF 2.0, 3.7.2.1).
  const bool brief = index_bytes == 2 && mesh.positions.size() <= 65535;
  const bool normals = mesh.normals.size() == mesh.positions.size() && !mesh.normals.empty();

  files::ByteWriter bin;
  Json views = Json::list();
  const auto view = [&](std::size_t from, int target) {
    views.push_back(Json::object({{"buffer", 0},
                                  {"byteOffset", from},
                                  {"byteLength", bin.size() - from},
                                  {"target", target}}));
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
    for (const std::uint32_t i : t) brief ? bin.u16(static_cast<std::uint16_t>(i)) : bin.u32(i);
  view(from, kElementBuffer);
  bin.pad(4, '\0');
  if (!colors.empty()) {
    from = bin.size();
    for (const auto& c : colors) {
      for (const float v : c)
        bin.u16(static_cast<std::uint16_t>(std::lround(65535.0f * std::clamp(v, 0.0f, 1.0f))));
      bin.u16(65535);  // opaque; elements are aligned to four bytes
    }
    view(from, kArrayBuffer);
  }

  const bool pictured = !picture.file.empty();
  const bool tangents = pictured && !picture.tangents.empty();
  std::vector<const std::vector<std::byte>*> files;  // in the order of their textures
  Textures textures;
  if (pictured) {
    from = bin.size();
    for (const auto& place : picture.places) bin.f32s(place);
    view(from, kArrayBuffer);
    from = bin.size();
    for (const auto& tangent : picture.tangents) bin.f32s(tangent);
    if (tangents) view(from, kArrayBuffer);
    const auto add = [&](const std::vector<std::byte>& file) {
      if (file.empty()) return -1;
      from = bin.size();
      bin.append(file);
      views.push_back(
          Json::object({{"buffer", 0}, {"byteOffset", from}, {"byteLength", file.size()}}));
      files.push_back(&file);
      return static_cast<int>(files.size()) - 1;
    };
    textures.color = add(picture.file);
    textures.roughness = add(picture.roughness);
    textures.normals = add(picture.normals);
  }

  Json accessors = Json::list({Json::object({{"bufferView", 0},
                                             {"componentType", kFloat},
                                             {"count", mesh.positions.size()},
                                             {"type", "VEC3"},
                                             {"min", Json::list_of(low)},
                                             {"max", Json::list_of(high)}})});
  Json attributes = Json::object({{"POSITION", 0}});
  if (normals) {
    accessors.push_back(Json::object({{"bufferView", 1},
                                      {"componentType", kFloat},
                                      {"count", mesh.normals.size()},
                                      {"type", "VEC3"}}));
    attributes["NORMAL"] = 1;
  }
  const auto count = [&](std::size_t part) {
    const bool last = part + 1 == parts.size();
    return (last ? mesh.triangles.size() : parts[part + 1].first) - parts[part].first;
  };
  // The first part's indices come before the colours, the others' after.
  const auto indices = [&](std::size_t part) {
    Json accessor = Json::object({{"bufferView", normals ? 2 : 1},
                                  {"componentType", brief ? kUnsignedShort : kUnsignedInt},
                                  {"count", 3 * count(part)},
                                  {"type", "SCALAR"}});
    if (part > 0) accessor["byteOffset"] = (brief ? 6 : 12) * parts[part].first;
    accessors.push_back(accessor);
  };
  indices(0);
  if (!colors.empty()) {
    accessors.push_back(Json::object({{"bufferView", normals ? 3 : 2},
                                      {"componentType", kUnsignedShort},
                                      {"normalized", true},
                                      {"count", colors.size()},
                                      {"type", "VEC4"}}));
    attributes["COLOR_0"] = normals ? 3 : 2;
  }

  const std::size_t places = (normals ? 3u : 2u) + (colors.empty() ? 0u : 1u);  // their view
  // Their accessor comes after all others.
  if (pictured) attributes["TEXCOORD_0"] = places + parts.size() - 1;
  if (tangents) attributes["TANGENT"] = places + parts.size();

  Json asset = Json::object({{"version", "2.0"}, {"generator", "Onggi"}});
  if (!copyright.empty()) asset["copyright"] = copyright;
  Json materials = Json::list(), primitives = Json::list();
  const std::size_t later = (normals ? 2u : 1u) + (colors.empty() ? 0u : 1u);
  for (std::size_t part = 0; part < parts.size(); ++part) {
    if (part > 0) indices(part);
    const std::size_t first = normals ? 2 : 1;
    primitives.push_back(Json::object({{"attributes", attributes},
                                       {"indices", part == 0 ? first : later + part},
                                       {"material", part}}));
    materials.push_back(json_of(parts[part].material, textures));
  }
  if (pictured)
    accessors.push_back(Json::object({{"bufferView", places},
                                      {"componentType", kFloat},
                                      {"count", picture.places.size()},
                                      {"type", "VEC2"}}));
  if (tangents)
    accessors.push_back(Json::object({{"bufferView", places + 1},
                                      {"componentType", kFloat},
                                      {"count", picture.tangents.size()},
                                      {"type", "VEC4"}}));
  Json document = Json::object(
      {{"asset", asset},
       {"scene", 0},
       {"scenes", Json::list({Json::object({{"name", title}, {"nodes", Json::list({0})}})})},
       {"nodes", Json::list({Json::object({{"name", title}, {"mesh", 0}})})},
       {"meshes", Json::list({Json::object({{"name", title}, {"primitives", primitives}})})},
       {"materials", materials},
       {"accessors", accessors},
       {"bufferViews", views},
       {"buffers", Json::list({Json::object({{"byteLength", bin.size()}})})}});
  if (pictured) {
    Json images = Json::list(), sampled = Json::list();
    for (std::size_t n = 0; n < files.size(); ++n) {
      const bool jpeg = files[n]->front() == std::byte{0xFF};
      images.push_back(Json::object({{"bufferView", places + (tangents ? 2u : 1u) + n},
                                     {"mimeType", jpeg ? "image/jpeg" : "image/png"}}));
      sampled.push_back(Json::object({{"sampler", 0}, {"source", n}}));
    }
    document["images"] = images;
    document["samplers"] = Json::list({Json::object({{"wrapS", kRepeat}, {"wrapT", kClamp}})});
    document["textures"] = sampled;
  }

  files::ByteWriter json;
  // Repair text that is not UTF-8 instead of refusing it: the pot matters more than its name.
  json.text(document.text(-1));
  json.pad(4, ' ');
  bin.pad(4, '\0');

  files::ByteWriter glb;
  glb.u32(kGlbMagic);
  glb.u32(2);
  glb.u32(static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + bin.size()));
  glb.u32(static_cast<std::uint32_t>(json.size()));
  glb.u32(kGlbJson);
  glb.append(json.bytes());
  glb.u32(static_cast<std::uint32_t>(bin.size()));
  glb.u32(kGlbBin);
  glb.append(bin.bytes());
  return glb.take();
}

}  // namespace onggi::content
