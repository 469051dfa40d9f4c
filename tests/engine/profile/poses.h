#pragma once

#include <random>

#include "engine/math/portable.h"
#include "engine/math/unit.h"
#include "tests/engine/profile/shapes.h"

namespace onggi::shapes {

/// A rigid motion: columns are where x, y and z go.
struct Pose {
  Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, shift;
};

inline Pose random_pose(unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const auto any = [&] { return unit(Vec3{normal(random), normal(random), normal(random)}); };
  Pose pose;
  pose.y = any();
  const Vec3 aside = any();
  pose.x = unit(aside - pose.y * dot(aside, pose.y));
  pose.z = cross(pose.x, pose.y);
  pose.shift = any() * 3.0;
  return pose;
}

/// `mesh` in `pose`, all of it times `scale`.
inline TriangleMesh moved(TriangleMesh mesh, const Pose& pose, double scale = 1.0) {
  for (auto& p : mesh.positions) {
    const Vec3 v = (pose.x * p[0] + pose.y * p[1] + pose.z * p[2] + pose.shift) * scale;
    p = {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
  }
  mesh.normals.clear();
  return mesh;
}

/// A handle: a bent tube from `low` to `high` on the wall, standing `out` beyond it.
inline void add_handle(TriangleMesh& mesh, const Profile& p, double low, double high, double out,
                       double tube) {
  constexpr std::uint32_t kAlong = 40, kRound = 16;
  const auto base = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::uint32_t i = 0; i < kAlong; ++i) {
    const double t = portable::kPi * i / (kAlong - 1);
    const double h = 0.5 * (low + high) - 0.5 * (high - low) * portable::cos(t);
    const double r = p.outer_at(h) - 0.3 * tube + out * portable::sin(t);
    for (std::uint32_t k = 0; k < kRound; ++k) {
      const double a = 2 * portable::kPi * k / kRound;
      mesh.positions.push_back({static_cast<float>(r + tube * portable::cos(a) * portable::sin(t)),
                                static_cast<float>(h - tube * portable::cos(a) * portable::cos(t)),
                                static_cast<float>(tube * portable::sin(a))});
    }
  }
  for (std::uint32_t i = 0; i + 1 < kAlong; ++i)
    for (std::uint32_t k = 0; k < kRound; ++k) {
      const std::uint32_t a = base + i * kRound + k, b = base + i * kRound + (k + 1) % kRound;
      mesh.triangles.push_back({a, b, a + kRound});
      mesh.triangles.push_back({b, b + kRound, a + kRound});
    }
}

}  // namespace onggi::shapes
