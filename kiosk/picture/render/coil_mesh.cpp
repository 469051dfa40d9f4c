#include "kiosk/picture/render/coil_mesh.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>

namespace onggi::render {
namespace {

constexpr std::uint32_t kSides = 14;  // of the tube
constexpr int kCap = 4;               // rings of a round end

/// One tube of a coil, ring by ring.
class Tube {
 public:
  Tube(TriangleMesh& mesh, const CoilOnRim& coil)
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
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    for (std::uint32_t k = 0; k < kSides; ++k) {
      const float round = 2 * glm::pi<float>() * static_cast<float>(k) / kSides;
      const glm::vec3 way = std::cos(round) * out + std::sin(round) * up;
      const glm::vec3 at = middle + wide * radius_ * way;
      const glm::vec3 normal = std::cos(lean) * way + std::sin(lean) * along;
      mesh_.positions.push_back({at.x, at.y, at.z});
      mesh_.normals.push_back({normal.x, normal.y, normal.z});
    }
    if (begun_) {
      for (std::uint32_t k = 0; k < kSides; ++k) {
        const std::uint32_t a = first - kSides + k, b = first - kSides + (k + 1) % kSides;
        mesh_.triangles.push_back({a, b, b + kSides});
        mesh_.triangles.push_back({a, b + kSides, a + kSides});
      }
    }
    begun_ = true;
  }

  TriangleMesh& mesh_;
  float radius_, height_;
  bool begun_ = false;
};

}  // namespace

float angle_of(const CoilOnRim& coil, std::size_t place, double turned) {
  return static_cast<float>(turned) + 2 * glm::pi<float>() * (static_cast<float>(place) + 0.5f) /
                                          static_cast<float>(coil.centre.size());
}

std::vector<CoilRun> runs_of(const CoilOnRim& coil, double turned, Opening opening) {
  std::vector<CoilRun> runs;
  const std::size_t n = coil.centre.size();
  const auto cut = [&](std::size_t place) {
    const float turn = 2 * glm::pi<float>();
    const float beyond = std::remainder(angle_of(coil, place % n, turned) - opening.from, turn);
    return (beyond < 0 ? beyond + turn : beyond) < opening.angle;
  };
  const auto lies = [&](std::size_t place) {
    return coil.centre[place % n] != 0.0f && !cut(place);
  };
  std::size_t gap = 0;  // a place where nothing lies, to begin after
  while (gap < n && lies(gap)) ++gap;
  if (gap == n && n > 0) return {{0, n, false, false, true}};
  for (std::size_t k = gap + 1; k < gap + n; ++k) {
    if (!lies(k)) continue;
    CoilRun run{k, k, cut(k + n - 1), false, false};
    while (k + 1 < gap + n && lies(k + 1)) ++k;
    run.last = k;
    run.flat_last = cut(k + 1);
    runs.push_back(run);
  }
  return runs;
}

TriangleMesh coil_mesh(const CoilOnRim& coil, double turned, Opening opening) {
  TriangleMesh mesh;
  const auto centre = [&](std::size_t place) { return coil.centre[place % coil.centre.size()]; };
  for (const CoilRun& run : runs_of(coil, turned, opening)) {
    Tube tube(mesh, coil);
    const float first = angle_of(coil, run.first, turned), last = angle_of(coil, run.last, turned);
    if (!run.ring) tube.end(first, centre(run.first), -1, run.flat_first);
    for (std::size_t k = run.first; k <= run.last; ++k)
      tube.add(angle_of(coil, k, turned), centre(k));
    if (!run.ring) tube.end(last, centre(run.last), 1, run.flat_last);
  }
  return mesh;
}

}  // namespace onggi::render
