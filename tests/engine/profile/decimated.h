#pragma once

#include <array>
#include <map>
#include <queue>
#include <set>
#include <vector>

#include "engine/profile/mesh.h"

namespace onggi::shapes {

/// Corners at the same place become one; triangles without area go.
inline TriangleMesh welded(const TriangleMesh& mesh) {
  TriangleMesh out;
  std::map<std::array<float, 3>, std::uint32_t> place;
  for (auto t : mesh.triangles) {
    for (std::uint32_t& i : t) {
      const auto [found, fresh] =
          place.try_emplace(mesh.positions[i], static_cast<std::uint32_t>(out.positions.size()));
      if (fresh) out.positions.push_back(mesh.positions[i]);
      i = found->second;
    }
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) out.triangles.push_back(t);
  }
  return out;
}

/// Edge collapse by quadric errors (Garland and Heckbert 1997), as modelling tools decimate a scan.
/// `optimal` puts a collapsed edge where its quadric is least, otherwise at its better end.
class Decimator {
 public:
  Decimator(const TriangleMesh& mesh, bool optimal) : optimal_(optimal) {
    const TriangleMesh whole = welded(mesh);
    for (const auto& p : whole.positions) at_.push_back({p[0], p[1], p[2]});
    quadric_.resize(at_.size());
    around_.resize(at_.size());
    age_.assign(at_.size(), 0);
    for (const auto& t : whole.triangles) {
      const Vec3 n = cross(at_[t[1]] - at_[t[0]], at_[t[2]] - at_[t[0]]);
      const double twice = length(n);
      for (const std::uint32_t i : t) {
        around_[i].insert(triangles_.size());
        if (twice > 0.0) quadric_[i].add(n * (1.0 / twice), at_[t[0]], twice);
      }
      triangles_.push_back(t);
    }
    for (const auto& t : triangles_)
      for (std::size_t k = 0; k < 3; ++k) offer(t[k], t[(k + 1) % 3]);
  }

  TriangleMesh to(std::size_t wanted) {
    std::size_t left = triangles_.size();
    while (left > wanted && !heap_.empty()) {
      const Edge e = heap_.top();
      heap_.pop();
      if (age_[e.a] != e.age_a || age_[e.b] != e.age_b || turns_over(e)) continue;
      left -= collapse(e);
    }
    TriangleMesh out;
    for (const Vec3& p : at_)
      out.positions.push_back(
          {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      if (around_[triangles_[t][0]].count(t) != 0) out.triangles.push_back(triangles_[t]);
    return welded(out);
  }

 private:
  struct Quadric {
    std::array<double, 10> q{};  // xx xy xz xw yy yz yw zz zw ww
    void add(Vec3 n, Vec3 p, double weight) {
      const double d = -dot(n, p);
      const std::array<double, 4> v{n.x, n.y, n.z, d};
      std::size_t k = 0;
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = i; j < 4; ++j) q[k++] += weight * v[i] * v[j];
    }
    Quadric operator+(const Quadric& o) const {
      Quadric out = *this;
      for (std::size_t i = 0; i < 10; ++i) out.q[i] += o.q[i];
      return out;
    }
    double at(Vec3 p) const {
      return p.x * (q[0] * p.x + 2 * (q[1] * p.y + q[2] * p.z + q[3])) +
             p.y * (q[4] * p.y + 2 * (q[5] * p.z + q[6])) + p.z * (q[7] * p.z + 2 * q[8]) + q[9];
    }
    bool least(Vec3& p) const {
      const double c00 = q[4] * q[7] - q[5] * q[5], c01 = q[2] * q[5] - q[1] * q[7],
                   c02 = q[1] * q[5] - q[2] * q[4];
      const double det = q[0] * c00 + q[1] * c01 + q[2] * c02, sum = q[0] + q[4] + q[7];
      if (!(det > 1e-4 * sum * sum * sum / 27.0)) return false;
      const double c11 = q[0] * q[7] - q[2] * q[2], c12 = q[1] * q[2] - q[0] * q[5],
                   c22 = q[0] * q[4] - q[1] * q[1];
      p = {-(c00 * q[3] + c01 * q[6] + c02 * q[8]) / det,
           -(c01 * q[3] + c11 * q[6] + c12 * q[8]) / det,
           -(c02 * q[3] + c12 * q[6] + c22 * q[8]) / det};
      return true;
    }
  };
  struct Edge {
    double cost;
    std::uint32_t a, b;
    int age_a, age_b;
    Vec3 to;
    bool operator<(const Edge& o) const { return cost > o.cost; }
  };

  void offer(std::uint32_t a, std::uint32_t b) {
    const Quadric both = quadric_[a] + quadric_[b];
    Vec3 to = both.at(at_[a]) <= both.at(at_[b]) ? at_[a] : at_[b];
    if (optimal_) both.least(to);
    heap_.push({both.at(to), a, b, age_[a], age_[b], to});
  }
  /// Would the collapse turn a triangle round, or join two walls?
  bool turns_over(const Edge& e) const {
    std::size_t shared = 0;
    for (const auto& [corner, other] : {std::pair{e.a, e.b}, std::pair{e.b, e.a}})
      for (const std::size_t t : around_[corner]) {
        const auto& c = triangles_[t];
        if (c[0] == other || c[1] == other || c[2] == other) {
          ++shared;
          continue;
        }
        std::array<Vec3, 3> was, is;
        for (std::size_t k = 0; k < 3; ++k) is[k] = c[k] == corner ? e.to : (was[k] = at_[c[k]]);
        for (std::size_t k = 0; k < 3; ++k) was[k] = at_[c[k]];
        const Vec3 n = cross(was[1] - was[0], was[2] - was[0]),
                   m = cross(is[1] - is[0], is[2] - is[0]);
        if (dot(n, m) < 0.2 * length(n) * length(m)) return true;
      }
    return shared != 4;
  }
  std::size_t collapse(const Edge& e) {
    std::size_t gone = 0;
    at_[e.a] = e.to;
    quadric_[e.a] = quadric_[e.a] + quadric_[e.b];
    const std::set<std::size_t> moving = around_[e.b];
    for (const std::size_t t : moving) {
      auto& c = triangles_[t];
      if (c[0] == e.a || c[1] == e.a || c[2] == e.a) {
        for (const std::uint32_t i : c) around_[i].erase(t);
        ++gone;
        continue;
      }
      for (std::uint32_t& i : c)
        if (i == e.b) i = e.a;
      around_[e.a].insert(t);
    }
    around_[e.b].clear();
    ++age_[e.b];
    ++age_[e.a];
    std::set<std::uint32_t> near;
    for (const std::size_t t : around_[e.a])
      for (const std::uint32_t i : triangles_[t])
        if (i != e.a) near.insert(i);
    for (const std::uint32_t i : near) offer(e.a, i);
    return gone;
  }

  bool optimal_;
  std::vector<Vec3> at_;
  std::vector<Quadric> quadric_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<std::set<std::size_t>> around_;
  std::vector<int> age_;
  std::priority_queue<Edge> heap_;
};

}  // namespace onggi::shapes
