#include "kiosk/exhibit/composition/pot_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "kiosk/collection/content/glb.h"

namespace onggi::exhibit {

std::vector<std::byte> pot_model(const TriangleMesh& mesh, const std::vector<view::SkinPoint>& skin,
                                 const std::string& surface, const std::string& title,
                                 const std::string& copyright) {
  // 1. The factor, rounded as written.
  std::array<float, 3> factor{1e-4f, 1e-4f, 1e-4f};
  for (const view::SkinPoint& point : skin)
    for (std::size_t k = 0; k < 3; ++k) factor[k] = std::max(factor[k], point.color[k]);
  for (float& most : factor) most = std::min(std::ceil(most * 1e4f) / 1e4f, 1.0f);
  std::vector<std::array<float, 3>> colors;
  colors.reserve(skin.size());
  for (const view::SkinPoint& point : skin)
    colors.push_back(
        {point.color[0] / factor[0], point.color[1] / factor[1], point.color[2] / factor[2]});

  // 2. Group triangles of equal roughness.
  struct Coat {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    double roughness = 0;
  };
  std::map<int, Coat> coats;
  for (const auto& triangle : mesh.triangles) {
    float rough = 0;
    for (const std::uint32_t corner : triangle) rough += skin[corner].roughness / 3.0f;
    Coat& coat = coats[static_cast<int>(std::lround(rough / kRoughnessStep))];
    coat.triangles.push_back(triangle);
    coat.roughness += static_cast<double>(rough);
  }
  TriangleMesh sorted = mesh;
  sorted.triangles.clear();
  std::vector<content::GlbPart> parts;
  for (const auto& [level, coat] : coats) {
    const auto mean =
        static_cast<float>(coat.roughness / static_cast<double>(coat.triangles.size()));
    const std::string name = parts.empty() ? surface : surface + " " + std::to_string(level);
    parts.push_back({sorted.triangles.size(), {name, factor, mean}});
    sorted.triangles.insert(sorted.triangles.end(), coat.triangles.begin(), coat.triangles.end());
  }
  return content::write_glb(sorted, title, copyright, parts, colors, 2);
}

}  // namespace onggi::exhibit
