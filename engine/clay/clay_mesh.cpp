#include "engine/clay/clay_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "engine/clay/lip.h"
#include "engine/clay/ray.h"
#include "engine/math/portable.h"

namespace onggi {

namespace {

constexpr int kLipRings = 12;

using Position = std::array<float, 3>;

Vec3 as_vec(const Position& p) { return {p[0], p[1], p[2]}; }

/// Rings of equal vertex count, from foot to rim to floor, joined by triangles that face out of the
/// clay.
class Face {
 public:
  Face(TriangleMesh& mesh, const ClayView& clay, std::span<const int> sectors)
      : mesh_(mesh), clay_(clay), sectors_(sectors) {
    first_ = static_cast<std::uint32_t>(mesh.positions.size());
  }

  /// A ring at `height` with a row's radii; radii empty: all vertices on the axis.
  void ring(double height, std::span<const float> radii) {
    ring([&](std::size_t i) { return Vec2{radii.empty() ? 0.0 : double{radii[i]}, height}; });
  }

  /// A ring whose vertex in sector i is at `place(i)`: distance from the axis, and height.
  template <class Place>
  requires std::is_invocable_r_v<Vec2, Place, std::size_t>
  void ring(Place place) {
    for (const int sector : sectors_) {
      const Vec2 at = place(static_cast<std::size_t>(sector));
      const auto r = static_cast<float>(at.x);
      const clay::Ray ray = clay::ray_of(sector, clay_.sectors());
      mesh_.positions.push_back({r * ray.cos, static_cast<float>(at.y), r * ray.sin});
    }
    if (++rings_ < 2) return;
    const auto n = static_cast<std::uint32_t>(sectors_.size());
    const std::uint32_t here = first_ + (rings_ - 1) * n, before = here - n;
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t next = (k + 1) % n;
      add(before + k, here + k, before + next);
      add(before + next, here + k, here + next);
    }
  }

  /// Area-weighted vertex normals of this face alone.
  void finish() {
    std::vector<Vec3> sums(mesh_.positions.size() - first_);
    for (std::size_t t = first_triangle_; t < mesh_.triangles.size(); ++t) {
      const auto& [a, b, c] = mesh_.triangles[t];
      const Vec3 pa = as_vec(mesh_.positions[a]);
      const Vec3 area = cross(as_vec(mesh_.positions[b]) - pa, as_vec(mesh_.positions[c]) - pa);
      for (const std::uint32_t v : {a, b, c}) sums[v - first_] += area;
    }
    for (const Vec3& sum : sums) {
      const double size = length(sum);
      const Vec3 n = size > 0 ? sum * (1 / size) : Vec3{0, 1, 0};
      mesh_.normals.push_back(
          {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)});
    }
  }

 private:
  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const auto& p = mesh_.positions;
    if (p[a] == p[b] || p[b] == p[c] || p[c] == p[a]) return;  // A ring on the axis has no width.
    mesh_.triangles.push_back({a, b, c});
  }

  TriangleMesh& mesh_;
  const ClayView& clay_;
  std::span<const int> sectors_;
  std::uint32_t first_, rings_ = 0;
  std::size_t first_triangle_ = mesh_.triangles.size();
};

/// Which of `n` sectors are taken, `most` at most: whole steps round the axis where a divisor of
/// `n` is near. Else (367 sectors divide into nothing) each as near to an even share as there is.
std::vector<int> taken_of(int n, int most) {
  const int least = std::max(1, (n + most - 1) / most);
  int step = least;
  while (n % step != 0 && step < 2 * least) ++step;
  const int count = n % step == 0 ? n / step : most;
  std::vector<int> taken;
  for (int k = 0; k < count; ++k) taken.push_back(static_cast<int>(std::int64_t{k} * n / count));
  return taken;
}

}  // namespace

ClayMesh faced_mesh_of(const ClayView& clay, int most_rows, int most_sectors) {
  ClayMesh faced;
  TriangleMesh& mesh = faced.mesh;
  const std::vector<int> sectors = taken_of(clay.sectors(), std::max(3, most_sectors));
  const int row_step = std::max(1, (clay.rows() + most_rows - 1) / std::max(2, most_rows));
  const int last = clay.rows() - 1;
  const int floor_row = std::min(clay.floor_rows(), last);
  const double top = clay.rim_height();
  const double floor = clay.floor_rows() < clay.rows() ? clay.floor_top() : top;
  const auto face = [&] { return Face(mesh, clay, sectors); };
  const auto finish = [&](Face& done, ClayFace which) {
    done.finish();
    faced.faces.resize(mesh.positions.size(), which);
  };

  Face foot = face();
  foot.ring(0, {});
  foot.ring(0, clay.outer(0));
  finish(foot, ClayFace::foot);

  // The lip is round and ends the walls' faces at its shoulders. Above the shoulder it goes
  // straight up, even on a leaning wall.
  const double below_lip = top - kLipRadius;
  const auto lip = [&](double across) {
    return [&clay, last, top, across](std::size_t i) {
      const double wall = double{clay.outer(last)[i]} - double{clay.inner(last)[i]};
      const bool open = clay.inner(last)[i] > 0.0f;
      const double shoulder = top - std::min(open ? 0.5 * wall : wall, kLipRadius);
      int j = last;
      while (j > 0 && clay.row_height(j) > shoulder) --j;
      const int next = std::min(j + 1, last);
      const double apart = clay.row_height(next) - clay.row_height(j);
      const double share =
          apart > 0 ? std::clamp((shoulder - clay.row_height(j)) / apart, 0.0, 1.0) : 0.0;
      const auto radius = [&](std::span<const float> here, std::span<const float> above) {
        return double{here[i]} + share * (double{above[i]} - double{here[i]});
      };
      const double out = radius(clay.outer(j), clay.outer(next));
      const double in = open ? std::min(radius(clay.inner(j), clay.inner(next)), out) : 0.0;
      const double rho = out + across * (in - out);
      return Vec2{rho, top - lip_drop(in, out, rho)};
    };
  };

  Face outer = face();
  outer.ring(0, clay.outer(0));
  for (int j = 0; j <= last && clay.row_height(j) < below_lip; j += row_step)
    outer.ring(clay.row_height(j), clay.outer(j));
  outer.ring(lip(0.0));
  finish(outer, ClayFace::outer);

  Face rim = face();
  for (int n = 0; n <= kLipRings; ++n)  // closest where it is round
    rim.ring(lip(0.5 - 0.5 * portable::cos(portable::kPi * n / kLipRings)));
  finish(rim, ClayFace::rim);

  Face inner = face();
  inner.ring(lip(1.0));
  for (int j = last; j >= floor_row; j -= row_step)
    if (clay.row_height(j) < below_lip) inner.ring(clay.row_height(j), clay.inner(j));
  inner.ring(floor, clay.inner(floor_row));
  finish(inner, ClayFace::inner);

  Face base = face();
  base.ring(floor, clay.inner(floor_row));
  base.ring(floor, {});
  finish(base, ClayFace::floor);
  return faced;
}

TriangleMesh mesh_of(const ClayView& clay, int most_rows, int most_sectors) {
  return faced_mesh_of(clay, most_rows, most_sectors).mesh;
}

}  // namespace onggi
