#include "kiosk/collection/content/vessel.h"

#include <algorithm>
#include <chrono>

#include "engine/effects/prints.h"
#include "engine/profile/measures.h"
#include "kiosk/collection/content/catalogue.h"
#include "kiosk/collection/content/glb.h"
#include "kiosk/collection/content/pack.h"
#include "kiosk/collection/settings/visitor_text.h"
#include "tests/engine/profile/shapes.h"
#include "tests/kiosk/collection/content/temporary.h"
#include "tests/support/open_shelf.h"

namespace onggi::content::vessel_test {
namespace {

namespace fs = std::filesystem;
const fs::path kVessels = "../shared/vessels";

class VesselTest : public Temporary {
 protected:
  fs::path write_mesh(const std::string& name, const Profile& p, double scale = 1.0) {
    const auto glb = write_glb(revolve(section_of(scaled(p, scale)), 72), name, "CC0");
    return write(name, std::string(reinterpret_cast<const char*>(glb.data()), glb.size()));
  }
  static std::string words(int n) {
    std::string out;
    for (int i = 0; i < n; ++i) out += "clay ";
    return out;
  }
};

const std::string kToml =
    "true_height_mm = 305\ninstitution = \"A museum\"\naccession = \"12.3\"\n"
    "credit = \"Drawn for a test\"\nlicence = \"CC0-1.0\"\nsource = \"A book\"\n"
    "color = [1, 0.5, 0]\n[label.en]\ntitle = \"Moon jar\"\n[label.ko]\ntitle = \"달항아리\"\n";

/// Nothing is left to ask for but, where more is written behind it, the text.
const std::string kWholeToml =
    "true_height_mm = 305\ninstitution = \"A museum\"\ncredit = \"Drawn for a test\"\n"
    "licence = \"CC0-1.0\"\nsource = \"A book\"\n[label.ko]\ntitle = \"달항아리\"\n"
    "culture = \"한국\"\ndate = \"18세기\"\nmade = \"물레\"\ntext = \"굽\"\n"
    "[label.en]\ntitle = \"Moon jar\"\nculture = \"Korea\"\ndate = \"undated\"\nmade = "
    "\"Thrown.\"\n";

TEST_F(VesselTest, a_pack_brings_its_label_credit_and_true_size) {
  write_mesh("jar/vessel.glb", shapes::jar(), 100.0);  // modelled in centimetres
  write("jar/vessel.toml", kToml);
  const auto vessel = load_vessel(folder_ / "jar");
  ASSERT_TRUE(vessel) << to_text(vessel.error());
  EXPECT_EQ(vessel->id, "jar");
  EXPECT_EQ(vessel->label("ko").title, "달항아리");
  EXPECT_EQ(vessel->label("fr").title, "Moon jar");
  EXPECT_EQ(vessel->credit, "A museum, 12.3. Drawn for a test");
  EXPECT_EQ(vessel->licence, "CC0-1.0");
  EXPECT_NEAR(vessel->extracted.profile.height(), 0.305, 1e-12);
  EXPECT_NEAR(vessel->color[1], 0.2140f, 1e-3);
  float low = 1, high = -1;
  for (const auto& p : vessel->mesh.positions) {
    low = std::min(low, p[1]);
    high = std::max(high, p[1]);
  }
  EXPECT_NEAR(low, 0.0f, 1e-3);
  EXPECT_NEAR(high, 0.305f, 1e-3);
}

TEST_F(VesselTest, a_text_that_no_screen_shows_is_said_with_its_line_and_letters_and_is_cut) {
  write_mesh("jar/vessel.glb", shapes::jar());
  const auto with = [this](const std::string& line) {
    write("jar/vessel.toml", kWholeToml + "text = \"Foot.\"\n[label.fr]\n" + line);
    const PackRead read = read_pack(folder_ / "jar/vessel.toml");
    std::string all;
    for (const Problem& p : read.advice) all += to_text(p) + "\n";
    for (const Problem& p : read.problems) all += "left off: " + to_text(p) + "\n";
    return all;
  };
  std::string five_thousand = "A";
  for (int i = 0; i < 2500; ++i) five_thousand += " b";
  const std::string long_title = with("title = \"" + five_thousand + "\"\n");
  EXPECT_NE(long_title.find("vessel.toml:19:9: label.fr.title has 5001 letters, but there is room "
                            "for only 60."),
            std::string::npos)
      << long_title;
  EXPECT_EQ(long_title.find("left off"), std::string::npos);
  const auto vessel = load_vessel(folder_ / "jar");
  ASSERT_TRUE(vessel);
  EXPECT_EQ(settings::letters(vessel->label("fr").title), settings::bounds::kTitle.letters);
  for (const char* key : {"what", "culture", "date", "made", "text", "credit"}) {
    const std::string said =
        with("title = \"T\"\n" + std::string(key) + " = \"" + five_thousand + "\"\n");
    EXPECT_NE(said.find("vessel.toml:20:"), std::string::npos) << said;
    EXPECT_NE(said.find(std::string(key) + " has 5001 letters"), std::string::npos) << said;
  }
  EXPECT_NE(with("title = \"" + std::string(41, 'm') + "\"\n").find("a word of 41 letters"),
            std::string::npos);
  EXPECT_NE(with("title = \"a\\nb\\u0000c\\u001b[31m\"\n").find("label.fr.title has a line break"),
            std::string::npos);
  EXPECT_NE(with("title = \"\\u200b\\u200b\"\n").find("left off"), std::string::npos);
  EXPECT_NE(with("title = \"\\u200b\\u200b\"\n").find("nobody can see"), std::string::npos);
}

TEST_F(VesselTest, a_paddles_face_goes_by_name_and_another_word_is_only_said) {
  write_mesh("jar/vessel.glb", shapes::jar());
  const auto with = [this](const std::string& line) {
    write("jar/vessel.toml", line + kWholeToml + "text = \"Foot.\"\n");
    const auto vessel = load_vessel(folder_ / "jar");
    return vessel ? vessel->paddle : std::optional<int>(-1);
  };
  EXPECT_EQ(with(""), std::nullopt) << "the scene's paddle stays";
  EXPECT_EQ(with("paddle = \"plain\"\n"), PrintsDef::plain);
  EXPECT_EQ(with("paddle = \"cord\"\n"), PrintsDef::cord);
  EXPECT_EQ(with("paddle = \"grid\"\n"), PrintsDef::grid);
  EXPECT_TRUE(read_pack(folder_ / "jar/vessel.toml").advice.empty());
  EXPECT_EQ(with("paddle = \"stone\"\n"), std::nullopt);
  const PackRead read = read_pack(folder_ / "jar/vessel.toml");
  EXPECT_TRUE(read.problems.empty());
  ASSERT_EQ(read.advice.size(), 1u);
  EXPECT_TRUE(read.advice[0].where.ends_with("vessel.toml:1:10")) << read.advice[0].where;
  EXPECT_NE(read.advice[0].remedy.find("plain, cord, grid"), std::string::npos);
  EXPECT_EQ(with("paddle = \"cords\"\n"), std::nullopt);
  const PackRead slip = read_pack(folder_ / "jar/vessel.toml");
  ASSERT_EQ(slip.advice.size(), 1u);
  EXPECT_NE(slip.advice[0].remedy.find("Did you mean \"cord\"?"), std::string::npos);
}

TEST_F(VesselTest, a_scans_own_words_are_cut_to_what_a_label_shows) {
  Vessel vessel;
  vessel.id = "jar";
  for (int i = 0; i < 900; ++i) vessel.given.title += "jar ";
  vessel.given.culture = vessel.given.date = vessel.given.title;
  EXPECT_EQ(settings::letters(vessel.label("en").title), settings::bounds::kTitle.letters);
  EXPECT_EQ(settings::letters(vessel.label("en").culture), settings::bounds::kCulture.letters);
  EXPECT_EQ(settings::letters(vessel.label("en").date), settings::bounds::kDate.letters);
  vessel.given.title = "\u200b\u3164";
  EXPECT_EQ(vessel.label("en").title, "Jar") << "a name that can be seen";
}

TEST_F(VesselTest, a_bare_file_is_named_after_itself_and_an_absurd_size_is_made_sensible) {
  const auto big = load_vessel(write_mesh("wine_jug_02.glb", shapes::jar(), 100.0));
  ASSERT_TRUE(big);
  EXPECT_EQ(big->label("en").title, "Wine jug 02");
  EXPECT_NEAR(big->extracted.profile.height(), 0.3, 1e-3);
  EXPECT_EQ(big->size_from, SizeFrom::guess);
  ASSERT_EQ(big->extracted.warnings.size(), 1u);
  EXPECT_NE(big->extracted.warnings[0].find("cannot be metres"), std::string::npos);
  const auto plain = load_vessel(write_mesh("bowl.glb", shapes::bowl()));
  ASSERT_TRUE(plain);
  EXPECT_NEAR(plain->extracted.profile.height(), 0.075, 3e-4);
  EXPECT_EQ(plain->credit, "CC0");
}

TEST_F(VesselTest, a_broken_pack_is_named_and_the_rest_of_the_shelf_opens) {
  write_mesh("shelf/good/vessel.glb", shapes::jar());
  write("shelf/good/vessel.toml", kToml);
  write("shelf/words/vessel.toml", "licence = \"CC0\"\ncredit = \"x\"\nculur = [1, 1, 1]\n");
  write("shelf/none/vessel.toml",
        "licence = \"CC0\"\ncredit = \"x\"\ndrawing = \"profile.toml\"\n");
  write("shelf/broken.glb", "glTF but no more");
  write_mesh("shelf/loose.GLB", shapes::bowl());
  write_mesh("shelf/scan/scene.glb", shapes::bottle());
  write("shelf/scan/readme.txt", "of no interest");
  const OpenedShelf shelf = open_shelf(folder_ / "shelf");
  EXPECT_EQ(shelf.entries, 6u);
  ASSERT_EQ(shelf.vessels.size(), 3u);
  EXPECT_EQ(shelf.vessels[0].id, "good");
  EXPECT_EQ(shelf.vessels[1].id, "loose");
  EXPECT_EQ(shelf.vessels[2].id, "scan");
  EXPECT_NE(shelf.find("scan"), nullptr);
  EXPECT_EQ(shelf.find("nothing"), nullptr);
  ASSERT_EQ(shelf.problems.size(), 3u);
  EXPECT_NE(shelf.problems[0].where.find("broken.glb"), std::string::npos);
  EXPECT_NE(shelf.problems[1].remedy.find("onggi vessel make"), std::string::npos);
  EXPECT_NE(shelf.problems[2].where.find("words/vessel.toml:3:"), std::string::npos);
  EXPECT_EQ(open_shelf(folder_ / "nowhere").problems.size(), 1u);
}

TEST_F(VesselTest, a_shelf_begins_with_what_its_order_names_and_leaves_out_what_is_hidden) {
  for (const char* id : {"bowl", "cup", "jar", "jar_small", "vase"}) {
    write_mesh("shelf/" + std::string(id) + "/vessel.glb", shapes::jar());
    write("shelf/" + std::string(id) + "/vessel.toml", kToml);
  }
  // A hidden vessel is not even read.
  write("shelf/cup/vessel.glb", "glTF but no more");
  const Arrangement arrangement{{"vase", "cup", "jar_small", "nothing"}, {"cup", "nobody"}};
  const OpenedShelf shelf = open_shelf(folder_ / "shelf", arrangement);
  EXPECT_TRUE(shelf.problems.empty());
  std::vector<std::string> ids;
  for (const Vessel& vessel : shelf.vessels) ids.push_back(vessel.id);
  const std::vector<std::string> expected{"vase", "jar_small", "bowl", "jar"};
  EXPECT_EQ(ids, expected);
  const ShelfCheck check = check_shelf(folder_ / "shelf", {}, {"en"}, {}, {}, arrangement);
  EXPECT_EQ(check.ids, expected);
  EXPECT_EQ(check.hidden, std::vector<std::string>{"cup"});
}

TEST_F(VesselTest,
       an_unfinished_vessel_is_off_the_shelf_and_only_a_note_until_it_is_checked_alone) {
  write_mesh("shelf/jar/vessel.glb", shapes::jar());
  write("shelf/jar/vessel.toml", "unfinished = true\n" + kToml);
  EXPECT_EQ(open_shelf(folder_ / "shelf").entries, 0u);
  const ShelfCheck shelf = check_shelf(folder_ / "shelf");
  EXPECT_TRUE(shelf.problems.empty());
  EXPECT_EQ(shelf.hidden, std::vector<std::string>{"jar"});
  ASSERT_EQ(shelf.notes.size(), 1u);
  const ShelfCheck alone = check_shelf(folder_ / "shelf/jar");
  ASSERT_GE(alone.problems.size(), 2u);
  EXPECT_NE(shelf.notes[0].what.find(" " + std::to_string(alone.problems.size()) + " things are"),
            std::string::npos)
      << shelf.notes[0].what;
  // A change of it is noticed, because it was read.
  EXPECT_EQ(shelf.files, alone.files);

  write("shelf/jar/vessel.toml", "unfinished = true\n" + kWholeToml + "text = \"Its foot.\"\n");
  EXPECT_NE(check_shelf(folder_ / "shelf").notes[0].what.find("Nothing is missing."),
            std::string::npos);
  const ShelfCheck whole = check_shelf(folder_ / "shelf/jar");
  ASSERT_EQ(whole.problems.size(), 1u);
  EXPECT_EQ(whole.problems[0].remedy, "Remove the line unfinished = true.");
}

TEST_F(VesselTest, check_counts_what_it_saw_and_says_more_than_opening_does) {
  write_mesh("shelf/jar/vessel.glb", shapes::jar());
  write("shelf/jar/vessel.toml", kWholeToml + "text = \"Look at its foot.\"\n");
  ShelfCheck good = check_shelf(folder_ / "shelf");
  EXPECT_TRUE(good.problems.empty()) << to_text(good.problems[0]);
  EXPECT_EQ(good.ids.size(), 1u);
  const fs::path jar = folder_ / "shelf" / "jar";
  EXPECT_EQ(good.files, (std::vector<fs::path>{jar / "vessel.toml", jar / "vessel.glb"}));
  EXPECT_GE(good.keys_checked, 9);

  write("shelf/jar/vessel.toml",
        "true_diameter_mm = 500\n" + kWholeToml + "text = \"" + words(101) + "\"\n");
  EXPECT_TRUE(open_shelf(folder_ / "shelf").problems.empty());
  const ShelfCheck strict = check_shelf(folder_ / "shelf" / "jar");
  ASSERT_EQ(strict.problems.size(), 2u);
  EXPECT_NE(strict.problems[0].what.find("101 words"), std::string::npos);
  EXPECT_NE(strict.problems[0].where.find("vessel.toml:18:"), std::string::npos);
  EXPECT_NE(strict.problems[1].what.find("wide"), std::string::npos);
}

// With a thousand vessels one frame measured labels for 0.55 s.
TEST_F(VesselTest, a_shelf_that_is_too_long_for_a_frame_is_named_and_shown_as_far_as_it_may_be) {
  const auto put = [&](std::size_t n) {
    const std::string number = std::to_string(1000 + n);
    write("shelf/v" + number + ".glb", "glTF but no more");
  };
  for (std::size_t n = 0; n < kMostOnShelf; ++n) put(n);
  const auto too_long = [&] {
    std::vector<Problem> found;
    for (const Problem& problem : check_shelf(folder_ / "shelf").problems)
      if (problem.where == (folder_ / "shelf").string()) found.push_back(problem);
    return found;
  };
  EXPECT_TRUE(too_long().empty());
  put(kMostOnShelf);
  const auto found = too_long();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].what.find("501 vessels"), std::string::npos);
  EXPECT_EQ(open_shelf(folder_ / "shelf").entries, kMostOnShelf);
}

TEST_F(VesselTest, real_vessels_have_the_size_and_the_axis_that_their_list_gives) {
  if (!fs::exists(kVessels)) GTEST_SKIP() << "there is no " << kVessels;
  const OpenedShelf shelf = open_shelf(kVessels);
  // The ewer with three feet is no body of revolution, and of the tea set's ten pieces the square
  // plate is none.
  EXPECT_EQ(shelf.vessels.size(), 18u + 9u);
  ASSERT_EQ(shelf.problems.size(), 1u);
  EXPECT_NE(shelf.problems[0].where.find("ewer"), std::string::npos);
  for (const Vessel& v : shelf.vessels)
    EXPECT_EQ(v.id.find("plate_large_square"), std::string::npos) << v.id;
  struct Expected {
    const char* id;
    double height, belly;  // file units; 0: handles are in the listed size
    Vec3 axis;
  };
  const Expected list[] = {
      {"ycb_024_bowl", 0.05501, 0.1612, {0, 0, 1}},
      {"ycb_025_mug", 0.0813, 0.0932, {0, 0, 1}},
      {"ycb_065-j_cup", 0.07549, 0.1027, {0, 0, 1}},
      {"gso_bia_utensil_holder", 0.1752, 0.148, {0, 0, 1}},
      {"polyhaven_ceramic_vase_01_quant", 0.4003, 0.2036, {0, 1, 0}},
      {"polyhaven_ceramic_vase_01_meshopt", 0.4003, 0.2036, {0, 1, 0}},
      {"polyhaven_brass_pot_01_meshopt", 0.291, 0.3018, {0, 1, 0}},
      {"sketchfab_ancient_vase_ao", 0.4916, 0.3243, {0, 1, 0}},  // centimetres, by their size
      {"sketchfab_pot_vivikeram", 0.1913, 0.2348, {0, 1, 0}},    // millimetres
      {"sketchfab_vase_vinicius", 0.3, 0.3 * 2.469 / 3.885, {0, 1, 0}},
      {"sketchfab_chinese_vase_m3d", 0.8092, 0.0, {0, 1, 0}},
      {"khronos_waterbottle", 0.2604, 0.1089, {0, 1, 0}},
      {"drake_evo_bowl", 0.06126, 0.1468, {0, 1, 0}},
      {"m3_roman_pottery_01", 0.4065, 0.3365, {0, 1, 0}},
      {"m3_roman_pottery_05", 0.2259, 0.3477, {0, 1, 0}},
      {"m3_wine_jug_02", 0.4255, 0.2931, {0, 1, 0}},
      {"m3_flower_pot", 0.1996, 0.2218, {0, 1, 0}},
      {"sh3d_scopia_teapot", 0.213, 0.0, {0, 1, 0}},
  };
  for (const Expected& e : list) {
    const Vessel* v = shelf.find(e.id);
    ASSERT_NE(v, nullptr) << e.id;
    const Dimensions d = dimensions(v->extracted.profile);
    EXPECT_NEAR(d.height, e.height, 0.025 * e.height) << e.id;
    if (e.belly > 0.0) {
      EXPECT_NEAR(d.belly, e.belly, 0.02 * e.belly) << e.id;
    }
    EXPECT_GT(dot(v->extracted.axis_direction, e.axis), 0.999) << e.id;
    EXPECT_TRUE(validate(v->extracted.profile, e.id).has_value());
  }
  // Off the origin by 5.27 units in x.
  EXPECT_NEAR(shelf.find("sketchfab_ancient_vase_ao")->extracted.axis_origin.x, -5.27, 0.05);
}

}  // namespace
}  // namespace onggi::content::vessel_test
