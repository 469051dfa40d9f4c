#include "kiosk/picture/render/coil_mesh.h"

#include <cmath>
#include <cstddef>
#include <glm/gtc/constants.hpp>

namespace onggi::render {
namespace {

constexpr std::uint32_t kSides = 14;  // of the tube
constexpr int kCap = 4;               // rings of a round end

/// One tube of a coil, ring by ring.
class Tube {
 public:
  Tube(CoilMesh& mesh, const CoilOnRim& coil)
      : mesh_(mesh),
        radius_(0.5f * static_cast<float>(coil.diameter)),
        height_(static_cast<float>(coil.height)) {}

  /// The tube at `angle` about the axis, its middle `centre` from there.
  void add(float angle, float centre) { ring(angle, centre, 0.0f, 1.0f, 0.0f); }
  /// Its end, before the first ring (`side` -1) or after the last (1).
  void end(float angle, float centre, float side, bool flat) {
    if (flat) {
      ring(angle, centre, 0.0f, side < 0 ? 0.0f : 1.0f, side * glm::half_pi<float>());
      ring(angle, centre, 0.0f, side < 0 ? 1.0f : 0.0f, side * glm::half_pi<float>());
      return;
    }
    for (int k = 1; k <= kCap; ++k) {
      const float n = static_cast<float>(side < 0 ? kCap + 1 - k : k) / kCap;
      const float lean = n * glm::half_pi<float>();
      ring(angle, centre, side * std::sin(lean), std::cos(lean), side * lean);
    }
  }

 private:
  /// `ahead` and `wide`: of the tube's radius. `lean`: of the normals along the tube, rad.
  void ring(float angle, float centre, float ahead, float wide, float lean) {
    const glm::vec3 out(std::cos(angle), 0, std::sin(angle)), up(0, 1, 0);
    const glm::vec3 along(-out.z, 0, out.x);
    const glm::vec3 middle = centre * out + height_ * up + ahead * radius_ * along;
    const auto first = static_cast<std::uint32_t>(mesh_.corners.size());
    for (std::uint32_t k = 0; k < kSides; ++k) {
      const float round = 2 * glm::pi<float>() * static_cast<float>(k) / kSides;
      const glm::vec3 way = std::cos(round) * out + std::sin(round) * up;
      mesh_.corners.push_back(
          {middle + wide * radius_ * way, std::cos(lean) * way + std::sin(lean) * along});
    }
    if (begun_) {
      for (std::uint32_t k = 0; k < kSides; ++k) {
        const std::uint32_t a = first - kSides + k, b = first - kSides + (k + 1) % kSides;
        mesh_.indices.insert(mesh_.indices.end(), {a, b, b + kSides, a, b + kSides, a + kSides});
      }
    }
    begun_ = true;
  }

  CoilMesh& mesh_;
  float radius_, height_;
  bool begun_ = false;
};

}  // namespace

void make_coil(CoilMesh& mesh, const CoilOnRim& coil, double turned, Opening opening) {
  mesh.corners.clear();
  mesh.indices.clear();
  const std::size_t n = coil.centre.size();
  const auto angle = [&](std::size_t place) {
    return static_cast<float>(turned) +
           2 * glm::pi<float>() * (static_cast<float>(place) + 0.5f) / static_cast<float>(n);
  };
  const auto cut = [&](std::size_t place) {
    const float beyond = std::remainder(angle(place % n) - opening.from, 2 * glm::pi<float>());
    return (beyond < 0 ? beyond + 2 * glm::pi<float>() : beyond) < opening.angle;
  };
  const auto lies = [&](std::size_t place) {
    return coil.centre[place % n] != 0.0f && !cut(place);
  };
  std::size_t gap = 0;  // a place where nothing lies, to begin after
  while (gap < n && lies(gap)) ++gap;
  if (gap == n) {
    if (n == 0) return;
    Tube ring(mesh, coil);
    for (std::size_t k = 0; k <= n; ++k) ring.add(angle(k), coil.centre[k % n]);
    return;
  }
  for (std::size_t k = gap + 1; k < gap + n; ++k) {
    if (!lies(k)) continue;
    Tube tube(mesh, coil);
    tube.end(angle(k), coil.centre[k % n], -1, cut(k + n - 1));
    for (; k < gap + n && lies(k); ++k) tube.add(angle(k), coil.centre[k % n]);
    tube.end(angle(k - 1), coil.centre[(k - 1) % n], 1, cut(k));
  }
}

}  // namespace onggi::render
