#include "kiosk/collection/content/mesh_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "tests/engine/profile/mean_shapes.h"
#include "tests/kiosk/collection/content/temporary.h"
#include "tests/support/open_shelf.h"

// OBJ, PLY and STL, as scanners and modelling tools write them: no unit, and z as often up as y.

namespace onggi::content::mesh_file_test {
namespace {

namespace fs = std::filesystem;

class MeshFiles : public Temporary {
 protected:
  void SetUp() override {
    if (!fs::exists(fs::read_symlink("/proc/self/exe").parent_path() / "onggi-mesh"))
      GTEST_SKIP() << "built without Assimp: such files are refused by name";
  }
  /// A jar in millimetres.
  static TriangleMesh jar() {
    return revolve(section_of(resampled(scaled(shapes::jar(), 1000.0), 60)), 48);
  }
  /// It also names a file of the machine, which is none of its business.
  static std::string obj(const TriangleMesh& mesh, const std::string& name, std::size_t base = 0) {
    std::string out = "mtllib ../../../../../../etc/passwd\no " + name + "\n";
    char line[96];
    for (const auto& p : mesh.positions) {
      std::snprintf(line, sizeof line, "v %.7g %.7g %.7g\n", static_cast<double>(p[0]),
                    static_cast<double>(p[1]), static_cast<double>(p[2]));
      out += line;
    }
    for (const auto& t : mesh.triangles)
      out += "f " + std::to_string(base + t[0] + 1) + " " + std::to_string(base + t[1] + 1) + " " +
             std::to_string(base + t[2] + 1) + "\n";
    return out;
  }
  static std::string stl(const TriangleMesh& mesh) {
    std::string out(80, ' ');
    const auto put = [&out](const void* from, std::size_t size) {
      out.append(static_cast<const char*>(from), size);
    };
    const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
    put(&count, 4);
    for (const auto& t : mesh.triangles) {
      const float nothing[3] = {0, 0, 0};
      put(nothing, 12);
      for (const std::uint32_t i : t) put(mesh.positions[i].data(), 12);
      out.append(2, '\0');
    }
    return out;
  }
  static std::string ply(const TriangleMesh& mesh) {
    std::string out = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                      std::to_string(mesh.positions.size()) +
                      "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                      std::to_string(mesh.triangles.size()) +
                      "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const auto& p : mesh.positions) out.append(reinterpret_cast<const char*>(p.data()), 12);
    for (const auto& t : mesh.triangles) {
      out += '\3';
      out.append(reinterpret_cast<const char*>(t.data()), 12);
    }
    return out;
  }
};

TEST_F(MeshFiles, a_ply_has_the_colours_of_its_corners_as_a_display_shows_them) {
  const TriangleMesh mesh = jar();
  std::string text = "ply\nformat ascii 1.0\nelement vertex " +
                     std::to_string(mesh.positions.size()) +
                     "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n"
                     "property uchar green\nproperty uchar blue\nelement face " +
                     std::to_string(mesh.triangles.size()) +
                     "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const auto& p : mesh.positions)
    text += std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) +
            (p[1] > 150.0f ? " 20 40 200\n" : " 190 30 25\n");
  for (const auto& t : mesh.triangles)
    text += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) +
            "\n";
  const auto vessel = load_vessel(write("jar.ply", text));
  ASSERT_TRUE(vessel) << to_text(vessel.error());
  ASSERT_EQ(vessel->coloring.colors.size(), vessel->mesh.positions.size());
  using Color = std::array<std::uint8_t, 3>;
  for (std::size_t i = 0; i < vessel->mesh.positions.size(); ++i) {
    const float height = vessel->mesh.positions[i][1];
    if (std::abs(height - 0.15f) < 0.001f) continue;
    ASSERT_EQ(vessel->coloring.colors[i],
              height > 0.15f ? (Color{20, 40, 200}) : (Color{190, 30, 25}));
  }
  const auto plain = load_vessel(write("plain.ply", ply(mesh)));
  ASSERT_TRUE(plain) << to_text(plain.error());
  EXPECT_TRUE(plain->coloring.empty());
}

TEST_F(MeshFiles, each_kind_gives_the_vessel_that_it_was_written_from) {
  const TriangleMesh standing = jar(), lying = shapes::z_up(jar());
  for (const auto& [file, up] : {std::pair{write("a.obj", obj(standing, "jar")), Vec3{0, 1, 0}},
                                 std::pair{write("b.STL", stl(lying)), Vec3{0, 0, 1}},
                                 std::pair{write("c.ply", ply(lying)), Vec3{0, 0, 1}}}) {
    const auto vessel = load_vessel(file);
    ASSERT_TRUE(vessel) << to_text(vessel.error());
    EXPECT_NEAR(vessel->extracted.profile.height(), 0.30, 1e-3) << file;
    EXPECT_NEAR(vessel->extracted.profile.outer_at(0.1), shapes::jar().outer_at(0.1), 1e-3);
    EXPECT_GT(dot(vessel->extracted.axis_direction, up), 0.999);
    EXPECT_EQ(vessel->extracted.profile.inner_wall, InnerWall::measured);
    EXPECT_EQ(vessel->size_from, SizeFrom::guess);
  }
  EXPECT_EQ(open_shelf(folder_).vessels.size(), 3u);
}

TEST_F(MeshFiles, objects_of_an_obj_are_a_set) {
  TriangleMesh far = jar();
  for (auto& p : far.positions) p[0] += 2000.0f;
  const auto file =
      write("set.obj", obj(jar(), "left") + obj(far, "right", jar().positions.size()));
  const auto vessels = load_vessels(file);
  ASSERT_TRUE(vessels) << to_text(vessels.error());
  ASSERT_EQ(vessels->size(), 2u);
  LoadOptions options;
  options.node = "right";
  EXPECT_TRUE(load_vessel(file, options));
}

TEST_F(MeshFiles, limits_hold_and_damage_is_refused_by_name) {
  const std::string whole = stl(jar());
  const fs::path file = write("jar.stl", whole);
  settings::ReaderLimits limits;
  limits.triangles = 1000;
  const auto many = read_mesh_file(file, limits);
  ASSERT_FALSE(many);
  EXPECT_THAT(to_text(many.error()),
              ::testing::AllOf(::testing::HasSubstr("1000 triangles"),
                               ::testing::HasSubstr(
                                   "or raise vertices or triangles in the exhibit's [reader].")));
  limits = {};
  limits.file_mb = 0;
  EXPECT_FALSE(read_mesh_file(file, limits));
  for (const auto& [name, text] :
       {std::pair{"a.stl", whole.substr(0, 4000)},
        std::pair{"b.obj", std::string("v 1 2\nf 1 2 9\n")},
        std::pair{"c.ply", ply(jar()).substr(0, 3000)}, std::pair{"d.obj", std::string()},
        std::pair{"e.stl", std::string(500, 'x')}, std::pair{"f.ply", std::string("ply\n")}}) {
    const auto refused = load_vessel(write(name, text));
    if (refused) continue;  // what is left of it may still be a vessel
    EXPECT_NE(refused.error().where.find(name), std::string::npos) << refused.error().where;
    EXPECT_FALSE(refused.error().remedy.empty());
    EXPECT_EQ(refused.error().what.find("$$"), std::string::npos) << refused.error().what;
  }
}

TEST_F(MeshFiles, one_that_takes_for_ever_is_given_up_and_told_so) {
  // Assimp compares each object's name with all before it: minutes for a file that honest ones of
  // its size take a tenth of a second for.
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int n = 0; n < 150'000; ++n) text += "o part_" + std::to_string(n) + "\nf 1 2 3\n";
  const auto read = read_mesh_file(write("endless.obj", text));
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().what.find("longer than allowed"), std::string::npos) << read.error().what;
  EXPECT_FALSE(read.error().remedy.empty());
}

}  // namespace
}  // namespace onggi::content::mesh_file_test
