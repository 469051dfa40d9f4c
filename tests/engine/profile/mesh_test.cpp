#include "engine/profile/mesh.h"

#include <gtest/gtest.h>

#include "engine/math/portable.h"
#include "tests/engine/profile/shapes.h"

namespace onggi::mesh_test {
namespace {

TEST(Mesh, a_turned_section_is_watertight_and_faces_outwards) {
  for (const Profile& p : {shapes::jar(), shapes::bottle(), shapes::bowl()}) {
    const TriangleMesh mesh = revolve(section_of(p), 96);
    EXPECT_EQ(shapes::open_edges(mesh), 0);
    EXPECT_GT(shapes::volume(mesh), 0.0);
    EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
  }
}

TEST(Mesh, its_volume_is_that_of_the_rings_it_is_made_of) {
  const Profile p = shapes::cylinder(0.2, 0.05, 0.04, 0.01);
  const double solid = portable::kPi * 0.05 * 0.05 * 0.2;
  const double hollow = portable::kPi * 0.04 * 0.04 * (0.2 - 0.01001);
  // A prism of 720 sides is short of the circle by (2 pi / 720)^2 / 6.
  EXPECT_NEAR(shapes::volume(revolve(section_of(p), 720)), solid - hollow, 2e-5 * solid);
}

TEST(Mesh, normals_point_the_way_their_triangles_face) {
  const TriangleMesh mesh = revolve(section_of(shapes::jar()), 64);
  for (const auto& t : mesh.triangles) {
    const Vec3 face = cross(shapes::at(mesh, t[1]) - shapes::at(mesh, t[0]),
                            shapes::at(mesh, t[2]) - shapes::at(mesh, t[0]));
    for (const std::uint32_t corner : t) {
      const auto& n = mesh.normals[corner];
      EXPECT_NEAR(length(Vec3{n[0], n[1], n[2]}), 1.0, 1e-5);
      EXPECT_GT(dot(face, {n[0], n[1], n[2]}), 0.0);
    }
  }
}

TEST(Mesh, a_corner_sharper_than_forty_degrees_keeps_two_normals) {
  const Section can{{{0, 0}, {0.05, 0}, {0.05, 0.1}, {0, 0.1}}};
  const TriangleMesh mesh = revolve(can, 8);
  EXPECT_EQ(mesh.positions.size(), 2u + 4u * 8u);  // two poles, two rings at each of two corners
  EXPECT_EQ(shapes::open_edges(mesh), 0);
}

TEST(Mesh, a_solid_body_has_a_flat_top) {
  Profile p;
  p.points = {{0, 0.03, 0}, {0.1, 0.04, 0}};
  EXPECT_EQ(section_of(p).outline.back(), (Vec2{0.0, 0.1}));
  EXPECT_EQ(shapes::open_edges(revolve(section_of(p), 12)), 0);
}

}  // namespace
}  // namespace onggi::mesh_test
