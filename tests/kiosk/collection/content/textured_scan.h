#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "engine/profile/mesh.h"
#include "tests/engine/profile/mean_shapes.h"

namespace onggi::content::testing {

/// A jar of 0.3 m as a GLB whose surface has a picture, or colours at its corners.
struct TexturedScan {
  std::string picture{};  ///< Its bytes; "" none.
  std::string mime = "image/png";
  std::string texture = "\"source\":0";  ///< What the texture says of it.
  std::string image{};   ///< What the image says, in place of its bytes in the file.
  std::string factor{};  ///< "[1,0.5,0.25,1]"
  std::string sampler{}, use{}, required{};  ///< Further JSON of each.
  bool turned_over = false;  ///< v from the foot up, as OpenGL has it and glTF does not.
  int sectors = 48;
  std::vector<std::array<std::uint8_t, 4>> colors{};  ///< COLOR_0, normalised.

  TriangleMesh mesh() const { return revolve(section_of(resampled(shapes::jar(), 60)), sectors); }

  /// Round the axis u, from the rim (0) to the foot (1) v.
  std::vector<std::array<float, 2>> places() const {
    std::vector<std::array<float, 2>> out;
    for (const auto& p : mesh().positions) {
      const float v = 1.0f - p[1] / 0.30f;
      out.push_back({std::atan2(p[2], p[0]) / 6.2831853f + 0.5f, turned_over ? 1.0f - v : v});
    }
    return out;
  }

  std::string glb() const {
    const TriangleMesh m = mesh();
    std::string bin, views, accessors;
    int count = 0;
    const auto view = [&](const void* from, std::size_t size) {
      while (bin.size() % 4 != 0) bin += '\0';
      views += std::string(count++ == 0 ? "" : ",") +
               "{\"buffer\":0,\"byteOffset\":" + std::to_string(bin.size()) +
               ",\"byteLength\":" + std::to_string(size) + "}";
      bin.append(static_cast<const char*>(from), size);
    };
    const auto accessor = [&](int type, const std::string& kind, std::size_t elements,
                              const std::string& more = "") {
      accessors += std::string(accessors.empty() ? "" : ",") +
                   "{\"bufferView\":" + std::to_string(count - 1) +
                   ",\"componentType\":" + std::to_string(type) + ",\"type\":\"" + kind +
                   "\",\"count\":" + std::to_string(elements) + more + "}";
    };
    view(m.positions.data(), 12 * m.positions.size());
    accessor(5126, "VEC3", m.positions.size());
    view(m.triangles.data(), 12 * m.triangles.size());
    accessor(5125, "SCALAR", 3 * m.triangles.size());
    const auto where = places();
    view(where.data(), 8 * where.size());
    accessor(5126, "VEC2", where.size());
    std::string attributes = "\"POSITION\":0,\"TEXCOORD_0\":2";
    if (!colors.empty()) {
      view(colors.data(), 4 * colors.size());
      accessor(5121, "VEC4", colors.size(), ",\"normalized\":true");
      attributes += ",\"COLOR_0\":3";
    }
    std::string look = factor.empty() ? "" : "\"baseColorFactor\":" + factor;
    std::string pictures;
    if (!picture.empty() || !image.empty()) {
      look +=
          std::string(look.empty() ? "" : ",") + "\"baseColorTexture\":{\"index\":0" + use + "}";
      if (!picture.empty()) view(picture.data(), picture.size());
      pictures = ",\"samplers\":[{" + sampler + "}],\"textures\":[{\"sampler\":0," + texture +
                 "}],\"images\":[{" +
                 (image.empty() ? "\"name\":\"coat\",\"mimeType\":\"" + mime +
                                      "\",\"bufferView\":" + std::to_string(count - 1)
                                : image) +
                 "}]";
    }
    while (bin.size() % 4 != 0) bin += '\0';
    std::string json =
        "{\"asset\":{\"version\":\"2.0\"}" +
        (required.empty() ? "" : ",\"extensionsRequired\":[\"" + required + "\"]") +
        ",\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],\"meshes\":[{"
        "\"primitives\":[{\"attributes\":{" +
        attributes +
        "},\"indices\":1,\"material\":0}]}],\"materials\":[{\"pbrMetallicRoughness\":{" + look +
        "}}],\"accessors\":[" + accessors + "],\"bufferViews\":[" + views +
        "],\"buffers\":[{\"byteLength\":" + std::to_string(bin.size()) + "}]" + pictures + "}";
    while (json.size() % 4 != 0) json += ' ';
    const auto word = [](std::size_t v) {
      std::string out;
      for (int i = 0; i < 4; ++i) out += static_cast<char>(v >> 8 * i);
      return out;
    };
    return "glTF" + word(2) + word(28 + json.size() + bin.size()) + word(json.size()) + "JSON" +
           json + word(bin.size()) + std::string("BIN\0", 4) + bin;
  }
};

}  // namespace onggi::content::testing
