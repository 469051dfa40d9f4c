#pragma once

#include <cstdint>

#include "tests/engine/profile/poses.h"

// Vessels made to be misread: what museums' scans have and a plain jar has not.

namespace onggi::shapes {

/// Height and largest radius of the closed vessels below, metres.
inline constexpr double kTall = 0.14, kWide = 0.08;

/// `mesh` with `more` beside it, unconnected.
inline TriangleMesh joined(TriangleMesh mesh, const TriangleMesh& more) {
  const auto base = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.normals.clear();
  mesh.positions.insert(mesh.positions.end(), more.positions.begin(), more.positions.end());
  for (const auto& t : more.triangles)
    mesh.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  return mesh;
}

inline Profile pot_body() {
  return vessel(
      kTall, [](double t) { return kWide * (0.62 + 1.2 * t * (1.0 - t) + 0.08 * t); }, 0.005, 0.01);
}

/// A pot under its lid, closed all round as a scanner sees it: a knob on top, and below a foot
/// hollow by `hollow` of the height.
inline TriangleMesh lidded_pot(double hollow) {
  Section s;
  const double foot = 0.62 * kWide;
  s.outline = {{0, hollow * kTall}, {0.86 * foot, hollow * kTall}, {0.88 * foot, 0}};
  for (const ProfilePoint& p : resampled(pot_body(), 40).points)
    s.outline.push_back({p.outer, p.height});
  s.outline.push_back({0.5 * kWide, kTall + 0.012});
  s.outline.push_back({0.16 * kWide, kTall + 0.016});
  s.outline.push_back({0.20 * kWide, kTall + 0.030});
  s.outline.push_back({0.10 * kWide, kTall + 0.036});
  s.outline.push_back({0, kTall + 0.036});
  return revolve(s, 96);
}

/// The same with a handle to one side and a spout to the other.
inline TriangleMesh teapot(double hollow) {
  TriangleMesh mesh = lidded_pot(hollow);
  add_handle(mesh, pot_body(), 0.03, 0.12, 0.045, 0.008);
  TriangleMesh spout;
  add_handle(spout, pot_body(), 0.05, 0.11, 0.05, 0.010);
  for (auto& p : spout.positions) p[0] = -p[0], p[2] = -p[2];
  return joined(std::move(mesh), spout);
}

/// A straight cup whose mouth is closed by a flat disc, its foot hollow by `hollow` of its height.
inline TriangleMesh covered_cup(double hollow) {
  Section s;
  s.outline = {{0, hollow * 0.09}, {0.030, hollow * 0.09}, {0.033, 0},    {0.036, 0},
               {0.040, 0.03},      {0.042, 0.06},          {0.043, 0.09}, {0, 0.09}};
  return revolve(s, 96);
}

/// A bowl on a hollow stem: below as deep as above, and narrower.
inline TriangleMesh footed_bowl() {
  Section s;
  s.outline = {{0, 0.075},     {0.018, 0.070}, {0.045, 0},     {0.050, 0},
               {0.024, 0.070}, {0.030, 0.085}, {0.085, 0.110}, {0.100, 0.140},
               {0.095, 0.140}, {0.080, 0.114}, {0.020, 0.092}, {0, 0.090}};
  return revolve(s, 96);
}

/// A tube, open at both ends.
inline TriangleMesh tube(double height, double outer, double inner) {
  TriangleMesh mesh;
  constexpr std::uint32_t kRound = 96;
  const double corners[4][2] = {{outer, 0}, {outer, height}, {inner, height}, {inner, 0}};
  for (const auto& c : corners)
    for (std::uint32_t k = 0; k < kRound; ++k) {
      const double a = 2 * portable::kPi * k / kRound;
      mesh.positions.push_back({static_cast<float>(c[0] * portable::cos(a)),
                                static_cast<float>(c[1]),
                                static_cast<float>(c[0] * portable::sin(a))});
    }
  for (std::uint32_t ring = 0; ring < 4; ++ring)
    for (std::uint32_t k = 0; k < kRound; ++k) {
      const std::uint32_t a = ring * kRound + k, b = ring * kRound + (k + 1) % kRound;
      const std::uint32_t up = (ring + 1) % 4 * kRound;
      const std::uint32_t c = up + k, d = up + (k + 1) % kRound;
      mesh.triangles.push_back({a, c, b});
      mesh.triangles.push_back({b, c, d});
    }
  return mesh;
}

/// A pot of 0.2 m whose rim is folded outwards and down: air between skirt and wall from 0.15 m to
/// 0.185 m. Inside it runs straight from 0.088 m at 0.012 m to 0.094 m at the rim.
inline TriangleMesh skirted_pot() {
  Section s;
  s.outline = {{0, 0},         {0.090, 0},     {0.100, 0.185}, {0.108, 0.185}, {0.108, 0.150},
               {0.113, 0.150}, {0.113, 0.200}, {0.094, 0.200}, {0.088, 0.012}, {0, 0.012}};
  return revolve(s, 96);
}

/// A crock of 0.2 m with a collar round its neck that holds water, open upwards from 0.165 m to its
/// rim at 0.190 m. Its inside is a cylinder of 0.09 m.
inline TriangleMesh moated_crock() {
  Section s;
  s.outline = {{0, 0},         {0.095, 0},     {0.100, 0.150}, {0.120, 0.155},
               {0.120, 0.190}, {0.115, 0.190}, {0.115, 0.165}, {0.097, 0.165},
               {0.097, 0.200}, {0.090, 0.200}, {0.090, 0.012}, {0, 0.012}};
  return revolve(s, 96);
}

/// lidded_pot() with the hollow inside that a modeller made and no eye sees: walls 5 mm thick, the
/// floor at 0.02 m, the lid's underside at kTall.
inline TriangleMesh hollow_lidded_pot() {
  Section inside;
  inside.outline = {{0, 0.02}};
  for (const ProfilePoint& p : resampled(pot_body(), 40).points)
    if (p.height >= 0.02) inside.outline.push_back({p.outer - 0.005, p.height});
  inside.outline.push_back({0, kTall});
  TriangleMesh air = revolve(inside, 96);
  for (auto& t : air.triangles) std::swap(t[1], t[2]);
  return joined(lidded_pot(0.05), air);
}

/// A bowl of 0.09 m outer radius on a solid stem; its floor lies at 0.11 m of 0.18 m.
inline TriangleMesh goblet() {
  Section s;
  s.outline = {{0, 0},         {0.045, 0},     {0.045, 0.005}, {0.010, 0.020}, {0.010, 0.100},
               {0.060, 0.115}, {0.085, 0.140}, {0.090, 0.180}, {0.086, 0.180}, {0.080, 0.144},
               {0.055, 0.120}, {0.020, 0.110}, {0, 0.110}};
  return revolve(s, 96);
}

/// `count` loose triangles with corners anywhere in a cube of a metre.
inline TriangleMesh soup(std::uint32_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> anywhere(-0.5f, 0.5f);
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < 3 * count; ++i)
    mesh.positions.push_back({anywhere(random), anywhere(random), anywhere(random)});
  for (std::uint32_t i = 0; i < count; ++i) mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  return mesh;
}

/// On its head: y down.
inline TriangleMesh overturned(const TriangleMesh& mesh) {
  return moved(mesh, {{1, 0, 0}, {0, -1, 0}, {0, 0, -1}, {}});
}

/// As drawing boards have it: z up.
inline TriangleMesh z_up(const TriangleMesh& mesh) {
  return moved(mesh, {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {}});
}

}  // namespace onggi::shapes
