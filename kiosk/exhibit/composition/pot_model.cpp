#include "kiosk/exhibit/composition/pot_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace onggi::exhibit {

namespace {

/// `mesh` with its triangles of equal roughness together, and the first of each.
struct Coated {
  TriangleMesh mesh;
  std::vector<content::GlbPart> parts;
};

Coated coated(const TriangleMesh& mesh, const std::vector<view::SkinPoint>& skin,
              const std::string& surface, const std::array<float, 3>& color) {
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
  Coated out{mesh, {}};
  out.mesh.triangles.clear();
  for (const auto& [level, coat] : coats) {
    const auto mean =
        static_cast<float>(coat.roughness / static_cast<double>(coat.triangles.size()));
    const std::string name = out.parts.empty() ? surface : surface + " " + std::to_string(level);
    out.parts.push_back({out.mesh.triangles.size(), {name, color, mean}});
    out.mesh.triangles.insert(out.mesh.triangles.end(), coat.triangles.begin(),
                              coat.triangles.end());
  }
  return out;
}

/// The direction round the pot in the surface with `normal`, `turn` of the way round. With the
/// normal and the picture's top it is right-handed on every face.
std::array<float, 4> tangent_of(const std::array<float, 3>& normal, float turn) {
  const double angle = 2.0 * std::numbers::pi * double{turn};
  const Vec3 out{double{normal[0]}, double{normal[1]}, double{normal[2]}};
  Vec3 round{-std::sin(angle), 0.0, std::cos(angle)};
  round = round - dot(out, round) * out;
  round = (1.0 / std::max(length(round), 1e-9)) * round;
  return {static_cast<float>(round.x), static_cast<float>(round.y), static_cast<float>(round.z),
          1.0f};
}

}  // namespace

std::vector<std::byte> pot_model(const TriangleMesh& mesh, const std::vector<view::SkinPoint>& skin,
                                 const std::string& surface, const std::string& title,
                                 const std::string& copyright) {
  // The factor, rounded as written.
  std::array<float, 3> factor{1e-4f, 1e-4f, 1e-4f};
  for (const view::SkinPoint& point : skin)
    for (std::size_t k = 0; k < 3; ++k) factor[k] = std::max(factor[k], point.color[k]);
  for (float& most : factor) most = std::min(std::ceil(most * 1e4f) / 1e4f, 1.0f);
  std::vector<std::array<float, 3>> colors;
  colors.reserve(skin.size());
  for (const view::SkinPoint& point : skin)
    colors.push_back(
        {point.color[0] / factor[0], point.color[1] / factor[1], point.color[2] / factor[2]});
  const Coated pot = coated(mesh, skin, surface, factor);
  return content::write_glb(pot.mesh, title, copyright, pot.parts, colors, 2);
}

std::vector<std::byte> pot_model(const TriangleMesh& mesh, const std::string& surface,
                                 const std::string& title, const std::string& copyright,
                                 content::GlbPicture picture) {
  if (!picture.normals.empty()) {
    picture.tangents.clear();
    for (std::size_t n = 0; n < mesh.normals.size(); ++n)
      picture.tangents.push_back(tangent_of(mesh.normals[n], picture.places[n][0]));
  }
  const content::GlbMaterial material{surface, {1.0f, 1.0f, 1.0f}, 1.0f};
  return content::write_glb(mesh, title, copyright, {{0, material}}, {}, 2, picture);
}

}  // namespace onggi::exhibit
