#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <tuple>

#include "engine/profile/mesh.h"

namespace onggi::shapes {

/// A vessel of `n` points from a formula for the outer radius over the height's share 0..1.
inline Profile vessel(double height, const std::function<double(double)>& outer, double wall,
                      double floor, int n = 120) {
  Profile p;
  for (int i = 0; i < n; ++i) {
    const double t = static_cast<double>(i) / (n - 1);
    const double h = t * height;
    p.points.push_back({h, outer(t), h < floor ? 0.0 : std::max(0.001 * height, outer(t) - wall)});
  }
  return p;
}

inline Profile jar() {
  return vessel(
      0.30, [](double t) { return 0.06 + 0.09 * std::sin(3.0 * t) * (1.2 - t); }, 0.006, 0.012);
}
inline Profile bottle() {
  return vessel(
      0.33, [](double t) { return 0.024 + 0.05 * std::exp(-12.0 * (t - 0.35) * (t - 0.35)); },
      0.005, 0.010);
}
inline Profile bowl() {
  return vessel(
      0.075, [](double t) { return 0.028 + 0.055 * std::sqrt(t); }, 0.005, 0.008);
}
inline Profile cylinder(double height, double outer, double inner, double floor) {
  Profile p;
  p.points = {
      {0, outer, 0}, {floor, outer, 0}, {floor * 1.001, outer, inner}, {height, outer, inner}};
  return p;
}

/// Edges that have not exactly one neighbour running the other way, vertices welded by position.
inline int open_edges(const TriangleMesh& mesh) {
  std::map<std::array<float, 3>, int> weld;
  std::map<std::pair<int, int>, int> edges;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto id = [&](std::size_t corner) {
        return weld.emplace(mesh.positions[t[corner]], static_cast<int>(weld.size())).first->second;
      };
      const int a = id(k), b = id((k + 1) % 3);
      ++edges[{a, b}];
    }
  int open = 0;
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (back == edges.end() || back->second != count) ++open;
  }
  return open;
}

inline Vec3 at(const TriangleMesh& mesh, std::uint32_t i) {
  const auto& p = mesh.positions[i];
  return {p[0], p[1], p[2]};
}

/// Signed volume by the divergence theorem; positive when triangles face outwards.
inline double volume(const TriangleMesh& mesh) {
  double six = 0.0;
  for (const auto& t : mesh.triangles)
    six += dot(at(mesh, t[0]), cross(at(mesh, t[1]), at(mesh, t[2])));
  return six / 6.0;
}

}  // namespace onggi::shapes
