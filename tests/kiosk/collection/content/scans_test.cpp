#include <gmock/gmock.h>

#include <cstring>

#include "kiosk/collection/content/catalogue.h"
#include "kiosk/collection/content/gltf.h"
#include "kiosk/collection/content/pack.h"
#include "kiosk/collection/content/pack_writer.h"
#include "tests/engine/profile/shapes.h"
#include "tests/kiosk/collection/content/scene_files.h"
#include "tests/support/open_shelf.h"

// What a museum's own files are like: several objects, metadata, wrong bounds, odd units and axes.

namespace onggi::content::scans_test {
namespace {

namespace fs = std::filesystem;

class Scans : public SceneFiles {
 protected:
  static TriangleMesh turned(const Profile& p) { return revolve(section_of(resampled(p, 60)), 48); }
  static TriangleMesh brick() {
    TriangleMesh mesh = revolve({{{0, 0}, {0.1, 0}, {0.1, 0.2}, {0, 0.2}}}, 4);
    for (auto& p : mesh.positions) p[0] *= 3.0f;
    return mesh;
  }
  fs::path write_set() {
    return write_scene("shelf/set", {{"Tall jar", turned(shapes::jar()), {0, 0, 0}},
                                     {"a brick", brick(), {2, 0, 0}},
                                     {"bowl", turned(shapes::bowl()), {0, 0, 2}},
                                     {"bowl", turned(shapes::bowl()), {0, 0, 4}}});
  }
  static std::string error_of(const Result<Vessel>& vessel) {
    return vessel ? "" : to_text(vessel.error());
  }
};

TEST_F(Scans, every_vessel_of_a_set_stands_on_the_shelf_and_what_is_none_does_not) {
  write_set();
  const OpenedShelf shelf = open_shelf(folder_ / "shelf");
  EXPECT_TRUE(shelf.problems.empty()) << to_text(shelf.problems[0]);
  ASSERT_EQ(shelf.vessels.size(), 3u);
  const Vessel* jar = shelf.find("set_Tall_jar");
  ASSERT_NE(jar, nullptr);
  EXPECT_EQ(jar->label("en").title, "Tall jar");
  EXPECT_NEAR(jar->extracted.profile.height(), 0.30, 1e-3);
  ASSERT_EQ(jar->nodes.size(), 1u);
  EXPECT_EQ(jar->nodes[0].triangles, jar->mesh.triangles.size());
  // The bowl keeps its size beside the jar, and its place is no longer that of the set.
  const Vessel* bowl = shelf.find("set_bowl");
  ASSERT_NE(bowl, nullptr);
  EXPECT_NEAR(bowl->extracted.profile.height(), 0.075, 1e-3);
  for (const auto& p : bowl->mesh.positions) EXPECT_LT(std::abs(p[2]), 0.1f);
  EXPECT_EQ(check_shelf(folder_ / "shelf").ids.size(), 3u);
}

TEST_F(Scans, a_set_stands_where_its_first_is_named_and_one_of_it_can_be_hidden) {
  write_set();
  write_scene("shelf/amphora", {{"amphora", turned(shapes::jar()), {0, 0, 0}}});
  const Arrangement arrangement{{"set_bowl"}, {"set_Tall_jar"}};
  const OpenedShelf shelf = open_shelf(folder_ / "shelf", arrangement);
  ASSERT_EQ(shelf.vessels.size(), 3u);
  EXPECT_EQ(shelf.vessels[0].id, "set_bowl");
  EXPECT_EQ(shelf.vessels[2].id, "amphora");
  EXPECT_EQ(shelf.find("set_Tall_jar"), nullptr);
  EXPECT_EQ(check_shelf(folder_ / "shelf", {}, {}, {}, {}, arrangement).hidden,
            std::vector<std::string>{"set_Tall_jar"});
}

TEST_F(Scans, of_a_set_one_is_named_or_all_are_listed) {
  const fs::path set = write_set();
  const std::string listed = error_of(load_vessel(set));
  for (const char* words : {"4 objects", "\"Tall jar\"", "\"a brick\"", "--node", "set.gltf"})
    EXPECT_NE(listed.find(words), std::string::npos) << listed;
  LoadOptions options;
  options.node = "Tall jar";
  EXPECT_EQ(error_of(load_vessel(set, options)), "");
  options.node = "3";  // by number: the first bowl
  const auto bowl = load_vessel(set, options);
  ASSERT_TRUE(bowl) << to_text(bowl.error());
  EXPECT_NEAR(bowl->extracted.profile.height(), 0.075, 1e-3);
  options.node = "a brick";
  const std::string brick = error_of(load_vessel(set, options));
  EXPECT_NE(brick.find("node \"a brick\": it is not a body of revolution"), std::string::npos)
      << brick;
  options.node = "jug";
  EXPECT_NE(error_of(load_vessel(set, options)).find("Name one of these"), std::string::npos);
}

TEST_F(Scans, a_pack_of_a_set_names_its_object) {
  write_set();
  for (const char* ending : {".gltf", ".bin"})
    fs::rename(folder_ / ("shelf/set" + std::string(ending)),
               folder_ / ("shelf/" + std::string(ending == std::string(".bin") ? "set" : "vessel") +
                          ending));
  fs::create_directory(folder_ / "shelf/jar");
  fs::rename(folder_ / "shelf/vessel.gltf", folder_ / "shelf/jar/vessel.gltf");
  fs::rename(folder_ / "shelf/set.bin", folder_ / "shelf/jar/set.bin");
  const std::string toml =
      "credit = \"x\"\nlicence = \"CC0-1.0\"\ntrue_height_mm = 450\n[label.en]\ntitle = \"Jar\"\n";
  write("shelf/jar/vessel.toml", toml);
  EXPECT_NE(error_of(load_vessel(folder_ / "shelf/jar")).find("4 objects"), std::string::npos);
  EXPECT_EQ(open_shelf(folder_ / "shelf").problems.size(), 1u);
  write("shelf/jar/vessel.toml", "node = \"Tall jar\"\n" + toml);
  const OpenedShelf shelf = open_shelf(folder_ / "shelf");
  ASSERT_EQ(shelf.vessels.size(), 1u);
  EXPECT_EQ(shelf.vessels[0].id, "jar");
  EXPECT_NEAR(shelf.vessels[0].extracted.profile.height(), 0.45, 1e-9);
}

TEST_F(Scans, pieces_that_touch_are_one_vessel) {
  const auto file =
      write_scene("jar", {{"jar", turned(shapes::jar())},
                          {"knob", turned(scaled(shapes::bowl(), 0.2)), {0, 0.29, 0}}});
  const auto vessels = load_vessels(file);
  ASSERT_TRUE(vessels) << to_text(vessels.error());
  ASSERT_EQ(vessels->size(), 1u);
  EXPECT_EQ(vessels->front().nodes.size(), 2u);
  EXPECT_EQ(vessels->front().id, "jar");
}

TEST_F(Scans, the_toml_says_which_way_is_up_and_what_a_unit_is) {
  TriangleMesh lying = turned(scaled(shapes::jar(), 1000.0));  // millimetres, z up, on its head
  for (auto& p : lying.positions) p = {p[0], p[2], -p[1]};
  write_scene("jar/vessel", {{"jar", lying}});
  const std::string toml = "credit = \"x\"\nlicence = \"CC0-1.0\"\n";
  write("jar/vessel.toml", toml + "units = \"mm\"\n");
  const auto decided = load_vessel(folder_ / "jar");
  ASSERT_TRUE(decided) << to_text(decided.error());
  EXPECT_NEAR(decided->extracted.profile.height(), 0.30, 1e-3);
  EXPECT_EQ(decided->extracted.up_from, UpFrom::opening);
  EXPECT_LT(decided->extracted.axis_direction.z, -0.999);
  write("jar/vessel.toml", toml + "units = \"mm\"\nup = \"z\"\n");
  const auto given = load_vessel(folder_ / "jar");
  ASSERT_TRUE(given);
  EXPECT_EQ(given->extracted.up_from, UpFrom::given);
  EXPECT_GT(given->extracted.axis_direction.z, 0.999);
  write("jar/vessel.toml", toml + "units = \"ell\"\nup = \"left\"\n");
  const PackRead wrong = read_pack(folder_ / "jar/vessel.toml");
  ASSERT_EQ(wrong.problems.size(), 2u);
  EXPECT_NE(wrong.problems[0].where.find("vessel.toml:3:"), std::string::npos);
}

TEST_F(Scans, whom_to_thank_is_read_from_extras_as_sketchfab_writes_them) {
  const auto file = write_scene(
      "pot", {{"pot", turned(shapes::jar())}}, "",
      R"j(,"extras":{"author":"Mina (https://sketchfab.com/mina)","title":"Onggi jar",)j"
      R"j("license":"CC-BY-SA-4.0 (http://creativecommons.org/licenses/by-sa/4.0/)",)j"
      R"j("source":"https://sketchfab.com/3d-models/onggi"})j");
  const auto vessel = load_vessel(file);
  ASSERT_TRUE(vessel) << to_text(vessel.error());
  EXPECT_EQ(vessel->credit, "“Onggi jar” by Mina (https://sketchfab.com/mina)");
  EXPECT_EQ(vessel->licence, "CC-BY-SA-4.0");
  EXPECT_EQ(vessel->source, "https://sketchfab.com/3d-models/onggi");
  EXPECT_EQ(vessel->label("en").title, "Onggi jar");
}

TEST_F(Scans, whom_to_thank_is_read_from_xmp_packets) {
  const auto file = write_scene(
      "pot", {{"pot", turned(shapes::jar())}},
      R"j(,"extensionsUsed":["KHR_xmp_json_ld"],"extensions":{"KHR_xmp_json_ld":{"packets":[)j"
      R"j({"dc:title":"another"},{"@context":{"dc":"http://purl.org/dc/elements/1.1/"},)j"
      R"j("dc:title":{"@type":"rdf:Alt","rdf:_1":{"@language":"en-US","@value":"Moon jar"}},)j"
      R"j("dc:creator":{"@list":["A. Kim","B. Lee"]},"dc:rights":"(c) A Museum 2021",)j"
      R"j("dc:description":{"@set":[{"@language":"ko","@value":"항아리"},)j"
      R"j({"@language":"en","@value":"A white jar."}]},"dc:date":"2021",)j"
      R"j("xmpRights:WebStatement":"https://creativecommons.org/publicdomain/zero/1.0/"}]}})j",
      R"j(,"copyright":"not this","extensions":{"KHR_xmp_json_ld":{"packet":1}})j");
  const auto vessel = load_vessel(file);
  ASSERT_TRUE(vessel) << to_text(vessel.error());
  EXPECT_EQ(vessel->credit, "“Moon jar” by A. Kim, B. Lee. (c) A Museum 2021");
  EXPECT_EQ(vessel->licence, "CC0-1.0");
  EXPECT_EQ(vessel->given.description, "A white jar.");
  EXPECT_EQ(vessel->given.date, "2021");
}

TEST_F(Scans, metadata_of_the_wrong_kind_is_passed_over) {
  for (const char* asset :
       {R"j(,"extras":7,"extensions":[1])j",
        R"j(,"extras":{"author":{"a":[[[[[[[[[[[["x"]]]]]]]]]]]]}})j",
        R"j(,"extensions":{"KHR_xmp_json_ld":{"packet":9}})j", R"j(,"copyright":" \n\t ")j"}) {
    const auto vessel = load_vessel(
        write_scene("pot", {{"pot", turned(shapes::jar())}},
                    R"j(,"extensions":{"KHR_xmp_json_ld":{"packets":[null,3]}})j", asset));
    ASSERT_TRUE(vessel) << asset << ": " << to_text(vessel.error());
    EXPECT_EQ(vessel->credit, "") << asset;
  }
}

TEST_F(Scans, licences_are_known_by_name_and_by_address) {
  EXPECT_EQ(licence_named_in("CC-BY-4.0 (http://creativecommons.org/licenses/by/4.0/)"),
            "CC-BY-4.0");
  EXPECT_EQ(licence_named_in("https://creativecommons.org/licenses/by-nc-sa/3.0/"),
            "CC-BY-NC-SA-3.0");
  EXPECT_EQ(licence_named_in("(c) 2017, UX3D. CC BY 4.0"), "CC-BY-4.0");
  EXPECT_EQ(licence_named_in("Public. CC0"), "CC0-1.0");
  EXPECT_EQ(licence_named_in("All rights reserved"), "");
}

TEST_F(Scans, numbers_outside_their_declared_bounds_are_used_and_said) {
  const auto read = [&](const std::string& bounds) {
    return read_gltf(write_scene("pot", {{"pot", turned(shapes::jar())}}, "", "", bounds));
  };
  const auto right = read(R"j(,"min":[-0.2,0,-0.2],"max":[0.2,0.3,0.2])j");
  ASSERT_TRUE(right);
  EXPECT_TRUE(right->warnings.empty()) << right->warnings[0];
  const auto wrong = read(R"j(,"min":[-0.1,0,-0.2],"max":[0.2,0.3,0.2])j");
  ASSERT_TRUE(wrong);
  ASSERT_EQ(wrong->warnings.size(), 1u);
  EXPECT_NE(wrong->warnings[0].find("outside the bounds"), std::string::npos);
  const auto odd = read(R"j(,"min":[0],"max":"x")j");
  ASSERT_TRUE(odd);
  EXPECT_EQ(odd->warnings.size(), 1u);
}

TEST_F(Scans, limits_are_settings_and_hold) {
  const fs::path file = write_scene("pot", {{"pot", turned(shapes::jar())}});
  const auto refused = [&](auto&& tighten) {
    settings::ReaderLimits limits;
    tighten(limits);
    const auto model = read_gltf(file, limits);
    return model ? std::string("(read)") : to_text(model.error());
  };
  EXPECT_EQ(refused([](auto&) {}), "(read)");
  EXPECT_NE(refused([](auto& l) { l.file_mb = 0; }).find("the limit is"), std::string::npos);
  EXPECT_NE(refused([](auto& l) { l.json_mb = 0; }).find("JSON"), std::string::npos);
  EXPECT_NE(refused([](auto& l) { l.json_depth = 3; }).find("nested"), std::string::npos);
  EXPECT_NE(refused([](auto& l) { l.json_values = 20; }).find("values"), std::string::npos);
  EXPECT_NE(refused([](auto& l) { l.vertices = 100; }).find("claims"), std::string::npos);
  EXPECT_NE(refused([](auto& l) { l.triangles = 100; }).find("claims"), std::string::npos);
  // Each names its limit as the exhibit's file does, so that a curator can raise it.
  const auto says = [](const std::string& words, const std::string& limit, const std::string& key) {
    EXPECT_THAT(words, ::testing::AllOf(::testing::HasSubstr("the limit is " + limit),
                                        ::testing::HasSubstr("or raise " + key +
                                                             " in the exhibit's [reader].")));
  };
  says(refused([](auto& l) { l.file_mb = 0; }), "0 MiB.", "file_mb");
  says(refused([](auto& l) { l.json_mb = 0; }), "0 MiB.", "json_mb");
  says(refused([](auto& l) { l.json_depth = 3; }), "3.", "json_depth");
  says(refused([](auto& l) { l.json_values = 20; }), "20.", "json_values");
  says(refused([](auto& l) { l.vertices = 100; }), "100.", "vertices");
  says(refused([](auto& l) { l.triangles = 100; }), "300.", "triangles");
  write_set();
  LoadOptions options;
  options.limits.vessels_in_a_file = 3;
  const auto vessels = load_vessels(folder_ / "shelf/set.gltf", options);
  ASSERT_FALSE(vessels);
  EXPECT_NE(vessels.error().what.find("4 objects"), std::string::npos);
  says(to_text(vessels.error()), "3.", "vessels_in_a_file");
}

TEST_F(Scans, a_mesh_shown_by_many_nodes_is_counted_each_time) {
  // 300 corners that are all the same point cost time at every node, and leave nothing to count.
  TriangleMesh nothing;
  nothing.positions.push_back({0, 0, 0});
  nothing.triangles.assign(100, {0, 0, 0});
  std::vector<Object> many{{"a", nothing}};
  const fs::path file = write_scene("pot", many);
  std::string text = files::test::content(file);
  std::string nodes = "\"nodes\":[{\"children\":[1";
  for (int i = 2; i < 200; ++i) nodes += "," + std::to_string(i);
  nodes += "]}";
  for (int i = 1; i < 200; ++i) nodes += ",{\"mesh\":0}";
  const auto from = text.find("\"nodes\":[{\"children\"");
  text.replace(from, text.find("\"meshes\"") - from, nodes + "],");
  settings::ReaderLimits limits;
  limits.triangles = 10000;
  const auto model = read_gltf(write("pot.gltf", text), limits);
  ASSERT_FALSE(model);
  EXPECT_THAT(
      to_text(model.error()),
      ::testing::AllOf(
          ::testing::HasSubstr("more vertices"), ::testing::HasSubstr("10000 triangles"),
          ::testing::HasSubstr("or raise vertices or triangles in the exhibit's [reader].")));
}

TEST_F(Scans, an_imported_pack_is_whole_but_for_what_no_file_can_tell) {
  const auto file =
      write_scene("pot", {{"pot", turned(shapes::jar())}}, "",
                  R"j(,"extras":{"author":"A \"quoted\" \\ name","title":"Jar","license":"CC0"})j");
  const auto vessel = load_vessel(file);
  ASSERT_TRUE(vessel);
  const PackRead read = read_pack(write("jar/vessel.toml", pack_toml(*vessel)));
  for (const Problem& p : read.problems) ADD_FAILURE() << to_text(p);
  for (const Problem& p : read.advice)
    for (const char* told : {"licence", "credit", "title"})
      EXPECT_EQ(p.what.find(told), std::string::npos) << to_text(p);
  EXPECT_EQ(read.pack.credit, "“Jar” by A \"quoted\" \\ name");
  EXPECT_EQ(read.pack.licence, "CC0-1.0");
  EXPECT_EQ(read.pack.labels.at("en").title, "Jar");
  const auto bare = load_vessel(write_scene("bare", {{"pot", turned(shapes::jar())}}));
  ASSERT_TRUE(bare);
  const PackRead unknown = read_pack(write("bare/vessel.toml", pack_toml(*bare)));
  EXPECT_TRUE(unknown.problems.empty());
  bool asked = false;
  for (const Problem& p : unknown.advice)
    asked = asked || p.what.find("licence") != std::string::npos;
  EXPECT_TRUE(asked);
}

}  // namespace
}  // namespace onggi::content::scans_test
