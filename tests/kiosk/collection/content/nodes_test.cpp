#include <gtest/gtest.h>

#include "kiosk/collection/content/gltf_parts.h"
#include "kiosk/collection/content/vessel.h"
#include "tests/engine/profile/mean_shapes.h"
#include "tests/kiosk/collection/content/scene_files.h"

// Files of several objects that hang on each other: which of them is the vessel.

namespace onggi::content::nodes_test {
namespace {

namespace fs = std::filesystem;

class Nodes : public SceneFiles {
 protected:
  static TriangleMesh turned(const Profile& p) { return revolve(section_of(resampled(p, 60)), 48); }
  /// A bucket with a bail over its mouth, as wide as its wall, which hangs on it as a child.
  fs::path write_bucket() {
    const Profile p = shapes::cylinder(0.2, 0.1, 0.094, 0.01);
    TriangleMesh bail;
    constexpr std::uint32_t kAlong = 24;
    for (std::uint32_t i = 0; i < kAlong; ++i) {
      const double a = portable::kPi * i / (kAlong - 1);
      const auto x = static_cast<float>(0.11 * portable::cos(a));
      const auto y = static_cast<float>(0.19 + 0.25 * portable::sin(a));
      for (const float z : {-0.09f, 0.09f}) bail.positions.push_back({x, y, z});
    }
    for (std::uint32_t i = 0; i + 1 < kAlong; ++i) {
      bail.triangles.push_back({2 * i, 2 * i + 1, 2 * i + 2});
      bail.triangles.push_back({2 * i + 1, 2 * i + 3, 2 * i + 2});
    }
    const fs::path file = write_scene("bucket", {{"bucket", turned(p)}, {"bail", bail}});
    std::string text = files::test::content(file);
    const auto change = [&text](const std::string& from, const std::string& to) {
      ASSERT_NE(text.find(from), std::string::npos) << from;
      text.replace(text.find(from), from.size(), to);
    };
    change("\"children\":[1,2]", "\"children\":[1]");
    change("{\"name\":\"bucket\"", "{\"children\":[2],\"name\":\"bucket\"");
    return write("bucket.gltf", text);
  }
  static LoadOptions node(const std::string& name) {
    LoadOptions options;
    options.node = name;
    return options;
  }
  static std::string error_of(const Result<Vessel>& vessel) {
    return vessel ? "" : to_text(vessel.error());
  }
};

TEST_F(Nodes, a_name_means_the_node_alone_and_with_a_star_what_hangs_on_it_too) {
  const fs::path file = write_bucket();
  const auto model = read_gltf(file);
  ASSERT_TRUE(model);
  const NamedPart alone = find_part(*model, "bucket"), all = find_part(*model, "bucket/*");
  ASSERT_NE(alone.part, nullptr);
  EXPECT_EQ(alone.part, all.part);
  const TriangleMesh bucket = mesh_of(*model, *alone.part, alone.reach);
  EXPECT_EQ(mesh_of(*model, *all.part, all.reach).triangles.size(), bucket.triangles.size() + 46);
  EXPECT_EQ(bucket.triangles.size(), alone.part->own_triangles);
  EXPECT_EQ(find_part(*model, "pail").part, nullptr);
  EXPECT_EQ(find_part(*model, "pail/*").part, nullptr);

  LoadOptions options;
  options.node = "bucket";
  const auto vessel = load_vessel(file, options);
  ASSERT_TRUE(vessel) << to_text(vessel.error());
  EXPECT_NEAR(vessel->extracted.profile.height(), 0.2, 1e-3);
  EXPECT_NEAR(vessel->extracted.profile.outer_at(0.1), 0.1, 1e-3);
  EXPECT_LT(vessel->extracted.masked_fraction, 0.01);
  ASSERT_EQ(vessel->nodes.size(), 1u);
  EXPECT_EQ(vessel->nodes[0].name, "bucket");
  options.node = "0";  // the root carries nothing itself: what hangs on it is meant
  const auto meaning = [&](const std::string& name) {
    const auto refused = load_vessel(file, node(name));
    return refused ? std::string("(taken)") : refused.error().what;
  };
  EXPECT_EQ(meaning("0"), meaning("bucket/*"));
  EXPECT_NE(meaning("0"), "(taken)");
}

TEST_F(Nodes, where_all_of_a_file_is_no_vessel_its_objects_are_named) {
  // Two jars that touch: neither a set that stands apart nor one vessel.
  const auto file = write_scene("two", {{"left", turned(shapes::jar()), {0, 0, 0}},
                                        {"right", turned(shapes::jar()), {0.2, 0, 0}}});
  const std::string error = error_of(load_vessel(file));
  for (const char* words : {"2 objects", "\"left\"", "\"right\"", "--node NAME"})
    EXPECT_NE(error.find(words), std::string::npos) << error;
  EXPECT_EQ(error_of(load_vessel(file, node("right"))), "");
}

TEST_F(Nodes, of_a_set_what_hangs_on_a_vessel_is_left_out_where_it_spoils_it) {
  const Profile p = shapes::jar();
  TriangleMesh sail;  // a sheet that reaches far out on one side
  sail.positions = {{0.1f, 0.1f, 0}, {1.5f, 0.1f, 0}, {1.5f, 0.2f, 0}};
  sail.triangles = {{0, 1, 2}};
  const fs::path file = write_scene(
      "set", {{"jar", turned(p)}, {"bowl", turned(shapes::bowl()), {0, 0, 3}}, {"sail", sail}});
  std::string text = files::test::content(file);
  text.replace(text.find("[1,2,3]"), 7, "[1,2]");
  text.replace(text.find("{\"name\":\"jar\""), 13, "{\"children\":[3],\"name\":\"jar\"");
  const auto vessels = load_vessels(write("set.gltf", text));
  ASSERT_TRUE(vessels) << to_text(vessels.error());
  ASSERT_EQ(vessels->size(), 2u);
  for (const Vessel& v : *vessels)
    EXPECT_NEAR(v.extracted.profile.height(), v.node == "jar" ? p.height() : 0.075, 1e-3) << v.node;
}

}  // namespace
}  // namespace onggi::content::nodes_test
