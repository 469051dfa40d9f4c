#include <gtest/gtest.h>

#include <algorithm>

#include "engine/profile/extraction.h"
#include "tests/engine/profile/mean_shapes.h"

// What stands off a vessel's circle, and what is no circle at all.

namespace onggi::handles_test {
namespace {

double worst(const Profile& wanted, const Profile& found) {
  double most = 0.0;
  for (int i = 2; i < 98; ++i) {
    const double h = wanted.height() * i / 100.0;
    most = std::max(most, std::abs(wanted.outer_at(h) - found.outer_at(h)));
  }
  return most / wanted.height();
}

TEST(Handles, a_jug_with_a_wide_handle_and_a_wide_spout_keeps_its_outline) {
  const Profile p = shapes::jar();
  for (const double tube : {0.030, 0.045, 0.052}) {
    TriangleMesh jug = revolve(section_of(p), 96);
    jug.normals.clear();
    shapes::add_handle(jug, p, 0.02, 0.29, 0.06, tube);
    TriangleMesh spout;
    shapes::add_handle(spout, p, 0.02, 0.29, 0.06, tube);
    for (auto& q : spout.positions) q[0] = -q[0], q[2] = -q[2];
    const auto found = extract_profile(shapes::joined(jug, spout), {}, "jug");
    ASSERT_TRUE(found) << tube << ": " << to_text(found.error());
    EXPECT_GT(found->masked_fraction, tube > 0.04 ? 0.25 : 0.15);
    EXPECT_LT(worst(p, found->profile), 0.01) << tube;
  }
}

TEST(Handles, a_sheared_jar_is_told_what_it_is) {
  const auto sheared = [](double by) {
    TriangleMesh mesh = revolve(section_of(shapes::jar()), 96);
    mesh.normals.clear();
    for (auto& p : mesh.positions) p[0] += static_cast<float>(by) * p[1];
    return extract_profile(mesh, {}, "jar");
  };
  for (const double by : {0.04, 0.05, 0.06, 0.08, 0.15, 0.3}) {
    const auto found = sheared(by);
    if (!found) {
      EXPECT_NE(found.error().what.find("not a body of revolution"), std::string::npos);
      continue;
    }
    bool told = false;
    for (const std::string& w : found->warnings)
      told = told || w.find("leans") != std::string::npos;
    EXPECT_TRUE(told) << by << ": " << found->masked_fraction << " masked";
  }
  TriangleMesh squeezed = revolve(section_of(shapes::jar()), 96);
  squeezed.normals.clear();
  for (auto& p : squeezed.positions) p[0] *= 0.95f;
  if (const auto found = extract_profile(squeezed, {}, "jar")) {
    bool told = false;
    for (const std::string& w : found->warnings) told = told || w.find("oval") != std::string::npos;
    EXPECT_TRUE(told);
  }
  // Neither a plain jar nor one with handles on both sides leans.
  TriangleMesh mesh = revolve(section_of(shapes::jar()), 96);
  shapes::add_handle(mesh, shapes::jar(), 0.08, 0.25, 0.05, 0.012);
  for (const auto& found : {sheared(0.0), extract_profile(mesh, {}, "jug")}) {
    ASSERT_TRUE(found);
    for (const std::string& w : found->warnings) EXPECT_EQ(w.find("leans"), std::string::npos) << w;
  }
}

}  // namespace
}  // namespace onggi::handles_test
