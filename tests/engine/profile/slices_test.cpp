#include "engine/profile/slices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "engine/math/portable.h"

namespace onggi::extraction::slices_test {
namespace {

constexpr std::uint32_t kSectors = 60;

/// A cylinder of one ring of triangles, each as tall as it is, and a rim half of it higher.
TriangleMesh slivers() {
  TriangleMesh mesh;
  const auto put = [&mesh](double radius, double height, std::uint32_t k) {
    const double angle = 2.0 * portable::kPi * k / kSectors;
    mesh.positions.push_back({static_cast<float>(radius * portable::cos(angle)),
                              static_cast<float>(height),
                              static_cast<float>(radius * portable::sin(angle))});
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
  };
  for (const auto& [low, high] : {std::pair{0.0, 0.2}, std::pair{0.2, 0.3}})
    for (std::uint32_t k = 0; k < kSectors; ++k) {
      const std::uint32_t a = put(0.05, low, k), b = put(0.05, low, k + 1), c = put(0.06, high, k),
                          d = put(0.06, high, k + 1);
      mesh.triangles.push_back({a, c, b});
      mesh.triangles.push_back({b, c, d});
    }
  return mesh;
}

const std::vector<double> kHeights{-0.1, 0.01, 0.05, 0.1, 0.15, 0.2, 0.25, 0.29, 0.4};

bool same(std::span<const CutSegment> one, std::span<const CutSegment> other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                    [](const CutSegment& a, const CutSegment& b) {
                      return a.a.x == b.a.x && a.a.y == b.a.y && a.b.x == b.b.x && a.b.y == b.b.y &&
                             a.bulge_a == b.bulge_a && a.bulge_b == b.bulge_b;
                    });
}

TEST(Slicer, EveryOutlineIsTheOneOfItsHeightHoweverManyAreHeldAtATime) {
  const TriangleMesh mesh = slivers();
  const Slicer slicer(mesh, axis_frame({}, {0, 1, 0}));
  ASSERT_EQ(slicer.cut(0.1).size(), 2 * kSectors);
  EXPECT_TRUE(slicer.cut(0.4).empty());
  for (const std::size_t most : {std::size_t{1}, std::size_t{250}, Slicer::kMostHeld}) {
    std::size_t next = 0;
    slicer.each_cut(
        kHeights,
        [&](std::size_t i, std::span<const CutSegment> outline) {
          EXPECT_EQ(i, next++);
          EXPECT_TRUE(same(outline, slicer.cut(kHeights[i]))) << kHeights[i] << ", " << most;
        },
        most);
    EXPECT_EQ(next, kHeights.size());
  }
}

TEST(Slicer, HoldsNoMoreSegmentsThanItMay) {
  const TriangleMesh mesh = slivers();
  const Slicer slicer(mesh, axis_frame({}, {0, 1, 0}));
  const auto places = [&](std::size_t most) {
    std::set<const CutSegment*> found;
    slicer.each_cut(
        std::vector{0.05, 0.1, 0.12, 0.15},
        [&](std::size_t, std::span<const CutSegment> outline) { found.insert(outline.data()); },
        most);
    return found.size();
  };
  EXPECT_EQ(places(Slicer::kMostHeld), 4u);
  EXPECT_EQ(places(2 * 2 * kSectors), 2u) << "two outlines' room, used twice";
  EXPECT_EQ(places(1), 1u);
}

}  // namespace
}  // namespace onggi::extraction::slices_test
