#include "kiosk/picture/render/coil_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>
#include <map>
#include <utility>

namespace onggi::render::coil_mesh_test {
namespace {

constexpr std::size_t kPlaces = 128;
constexpr double kRadius = 0.0065, kCentre = 0.05, kHeight = 0.1;

/// A coil on places first..last - 1 of a rim.
CoilOnRim laid(std::size_t first, std::size_t last) {
  CoilOnRim coil{std::vector<float>(kPlaces, 0.0f), 2 * kRadius, kHeight};
  for (std::size_t n = first; n < last; ++n) coil.centre[n % kPlaces] = static_cast<float>(kCentre);
  return coil;
}
TriangleMesh drawn(const CoilOnRim& coil, double turned = 0.0, Opening opening = {}) {
  return coil_mesh(coil, turned, opening);
}
glm::vec3 vec(const std::array<float, 3>& p) { return {p[0], p[1], p[2]}; }
double angle_of(const glm::vec3& p) {
  const double a = std::atan2(double{p.z}, double{p.x});
  return a < 0 ? a + 2 * glm::pi<double>() : a;
}

/// By the divergence theorem; positive where triangles are counterclockwise from outside.
double volume_of(const TriangleMesh& mesh) {
  double volume = 0;
  for (const auto& t : mesh.triangles) {
    const auto at = [&](std::size_t k) { return glm::dvec3(vec(mesh.positions[t[k]])); };
    volume += glm::dot(at(0), glm::cross(at(1), at(2))) / 6;
  }
  return volume;
}

TEST(CoilMesh, IsAsMuchClayAsTheCoil) {
  const double section = glm::pi<double>() * kRadius * kRadius;
  // A tube of 14 sides has 3.3 % less than a round one. Round ends add a ball.
  const double round = 14 / (2 * glm::pi<double>()) * std::sin(2 * glm::pi<double>() / 14);
  const double ball = 4.0 / 3 * glm::pi<double>() * std::pow(kRadius, 3);
  const double half = section * glm::pi<double>() * kCentre * 63 / 64 + ball;
  EXPECT_NEAR(volume_of(drawn(laid(0, 64))), round * half, 0.01 * half);
  const double ring = section * 2 * glm::pi<double>() * kCentre;
  EXPECT_NEAR(volume_of(drawn(laid(0, kPlaces))), round * ring, 0.01 * ring);
}

TEST(CoilMesh, IsClosedEverywhere) {
  for (const auto& [first, last] : {std::pair{0u, 64u}, {5u, 6u}, {100u, 150u}, {0u, 128u}}) {
    for (const Opening& opening : {Opening{}, Opening{1.0f, 0.9f}}) {
      const TriangleMesh mesh = drawn(laid(first, last), 0.3, opening);
      // By place, because rings of no width and the ring's own end lie on others.
      std::map<std::pair<std::tuple<int, int, int>, std::tuple<int, int, int>>, int> ways;
      const auto place = [&](std::uint32_t corner) {
        const glm::vec3 p = 1e6f * vec(mesh.positions[corner]);
        return std::tuple(static_cast<int>(std::lround(p.x / 10)),
                          static_cast<int>(std::lround(p.y / 10)),
                          static_cast<int>(std::lround(p.z / 10)));
      };
      for (const auto& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
          const auto a = place(t[k]), b = place(t[(k + 1) % 3]);
          if (a != b) ++ways[{a, b}], --ways[{b, a}];
        }
      for (const auto& [edge, sum] : ways)
        EXPECT_EQ(sum, 0) << "an edge of one triangle, places " << first << " to " << last;
    }
  }
}

TEST(CoilMesh, ItsNormalsPointOutOfTheClay) {
  const TriangleMesh mesh = drawn(laid(10, 70), 1.0);
  int looked = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const glm::vec3 from = vec(mesh.positions[a]);
    const glm::vec3 face = glm::cross(vec(mesh.positions[b]) - from, vec(mesh.positions[c]) - from);
    if (glm::length(face) < 1e-10f) continue;
    ++looked;
    const glm::vec3 mean = vec(mesh.normals[a]) + vec(mesh.normals[b]) + vec(mesh.normals[c]);
    EXPECT_GT(glm::dot(glm::normalize(face), glm::normalize(mean)), 0.8f);
    EXPECT_NEAR(glm::length(vec(mesh.normals[a])), 1.0f, 1e-4f);
  }
  EXPECT_GT(looked, 1000);
}

TEST(CoilMesh, LiesWhereItWasLaidAndTurnsWithTheClay) {
  const double turned = 0.7;
  const TriangleMesh mesh = drawn(laid(16, 48), turned);
  const double first = turned + 2 * glm::pi<double>() * 16 / kPlaces,
               last = turned + 2 * glm::pi<double>() * 48 / kPlaces;
  const double end = kRadius / (kCentre - kRadius);  // a round end goes on, most at the inside
  ASSERT_FALSE(mesh.positions.empty());
  double least = 9, most = 0;
  for (const auto& position : mesh.positions) {
    const glm::vec3 at = vec(position);
    const double rho = std::hypot(at.x, at.z);
    EXPECT_LT(std::abs(rho - kCentre), kRadius * 1.1);
    EXPECT_LT(std::abs(double{at.y} - kHeight), kRadius * 1.001);
    least = std::min(least, angle_of(at));
    most = std::max(most, angle_of(at));
  }
  EXPECT_GT(least, first - end);
  EXPECT_LT(least, first);
  EXPECT_LT(most, last + end);
  EXPECT_GT(most, last);
}

TEST(CoilMesh, OverTheOpeningOfACutAwayPotItIsCutFlat) {
  const Opening opening{1.0f, 0.8f};
  const TriangleMesh mesh = drawn(laid(0, kPlaces), 0.0, opening);
  ASSERT_FALSE(mesh.positions.empty());
  int flat = 0;
  for (std::size_t n = 0; n < mesh.positions.size(); ++n) {
    const double a = angle_of(vec(mesh.positions[n]));
    EXPECT_FALSE(a > 1.0 && a < 1.8) << a;
    const glm::vec3 along(-std::sin(a), 0, std::cos(a));
    flat += std::abs(glm::dot(vec(mesh.normals[n]), along)) > 0.99f;
  }
  EXPECT_EQ(flat, 2 * 2 * 14) << "two faces, a ring and its middle each";
}

TEST(CoilMesh, WhereNothingLiesNothingIsDrawn) {
  EXPECT_TRUE(drawn(CoilOnRim{}).triangles.empty());
  EXPECT_TRUE(drawn(laid(0, 0)).triangles.empty());
  EXPECT_TRUE(drawn(laid(10, 20), 0.0, {0.0f, 6.3f}).triangles.empty()) << "all cut away";
}

}  // namespace
}  // namespace onggi::render::coil_mesh_test
