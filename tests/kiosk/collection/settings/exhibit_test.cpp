#include "kiosk/collection/settings/exhibit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "kiosk/collection/settings/wifi_code.h"
#include "tests/kiosk/collection/settings/all_problems.h"
#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::settings::exhibit_test {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// A museum's own folder: exhibit/exhibit.toml, exhibit/scenes/first_touch.toml, content/vessels.
class ExhibitTest : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(museum_ / "exhibit/scenes");
    fs::create_directories(museum_ / "content/vessels");
    fs::create_directories(museum_ / "content/languages");
    std::ofstream(museum_ / "exhibit/scenes/first_touch.toml") << "";
    std::ofstream(museum_ / "content/glazes.toml") << "";
    for (const char* code : {"en", "ko"}) {
      std::ofstream(museum_ / "content/languages" / (std::string(code) + ".toml")) << "";
    }
  }
  ExhibitRead read(const std::string& text) {
    const fs::path file = museum_ / "exhibit/exhibit.toml";
    std::ofstream(file, std::ios::binary) << text;
    return read_exhibit(file, museum_ / "content/languages");
  }
  const files::test::ScratchFolder folder_;
  const fs::path museum_ = folder_.path();
};

TEST_F(ExhibitTest, a_file_without_a_setting_is_a_problem_and_its_exhibit_has_the_defaults) {
  for (const char* cut :
       {"", "# The museum's own.\n", "\n\n", "[keepsake]\n", "[screen]\n[title]\n"}) {
    const ExhibitRead empty = read(cut);
    EXPECT_THAT(all(empty.problems), HasSubstr("The exhibit file has no settings.")) << cut;
    EXPECT_THAT(all(empty.problems), HasSubstr("exhibit.toml:1:1: The exhibit")) << cut;
  }
  EXPECT_THAT(read("credit = \"us\"\n").problems, IsEmpty());
  const ExhibitRead r = read("");
  EXPECT_EQ(r.exhibit.shelf, museum_ / "content/vessels");
  EXPECT_EQ(r.exhibit.scene, museum_ / "exhibit/scenes/first_touch.toml");
  EXPECT_EQ(r.exhibit.keepsake.folder, museum_ / "keepsakes");
  EXPECT_EQ(r.exhibit.title.at("ko"), "도자기 빚기");
  EXPECT_EQ(r.exhibit.idle.warn_after, 60.0);
}

TEST_F(ExhibitTest, every_key_is_read) {
  fs::create_directories(museum_ / "jars");
  const ExhibitRead r = read(R"(
credit = "Museum of Jars"
languages = ["ko"]
shelf = "../jars/"
order = ["olla", "moon_jar"]
hidden = ["tea_bowl"]
scene = "scenes/first_touch.toml"
[title]
ko = "항아리"
[attract]
scripts = ["follow", "collapse"]
[idle]
warn_after = 30
countdown = 20.5
result_after = 90
[keepsake]
folder = "/var/lib/onggi/keepsakes"
quota_mb = 10
days = 30
gallery = false
turning = false
[store]
count = false
months = 12
[screen]
viewing_distance_mm = 800
diagonal_mm = 1400
lower_edge_mm = 700
reduced_motion = true
left_handed = true
high_contrast = true
larger_text = true
low_reach = true
silent = true
force = 0
[reader]
file_mb = 32
vertices = 200000
)");
  EXPECT_THAT(r.problems, IsEmpty()) << all(r.problems);
  EXPECT_EQ(r.keys_checked, 30);
  EXPECT_THAT(r.exhibit.attract_scripts, ElementsAre("follow", "collapse"));
  EXPECT_EQ(r.exhibit.credit, "Museum of Jars");
  EXPECT_THAT(r.exhibit.languages, ElementsAre("ko"));
  EXPECT_EQ(r.exhibit.title, (std::map<std::string, std::string>{{"ko", "항아리"}}));
  EXPECT_EQ(r.exhibit.shelf, museum_ / "jars");
  EXPECT_THAT(r.exhibit.order, ElementsAre("olla", "moon_jar"));
  EXPECT_THAT(r.exhibit.hidden, ElementsAre("tea_bowl"));
  EXPECT_EQ(r.exhibit.keepsake.folder, "/var/lib/onggi/keepsakes");
  EXPECT_EQ(r.exhibit.keepsake.quota_mb, 10);
  EXPECT_EQ(r.exhibit.keepsake.days, 30);
  EXPECT_FALSE(r.exhibit.keepsake.gallery);
  EXPECT_FALSE(r.exhibit.keepsake.turning);
  EXPECT_FALSE(r.exhibit.store.count);
  EXPECT_EQ(r.exhibit.store.months, 12);
  EXPECT_EQ(r.exhibit.idle.warn_after, 30);
  EXPECT_EQ(r.exhibit.idle.countdown, 20.5);
  EXPECT_EQ(r.exhibit.idle.result_after, 90);
  EXPECT_EQ(r.exhibit.screen.viewing_distance_mm, 800);
  EXPECT_EQ(r.exhibit.screen.diagonal_mm, 1400);
  EXPECT_TRUE(r.exhibit.screen.reduced_motion);
  EXPECT_TRUE(r.exhibit.screen.left_handed);
  EXPECT_EQ(r.exhibit.screen.lower_edge_mm, 700);
  EXPECT_TRUE(r.exhibit.screen.high_contrast);
  EXPECT_TRUE(r.exhibit.screen.larger_text);
  EXPECT_TRUE(r.exhibit.screen.low_reach);
  EXPECT_TRUE(r.exhibit.screen.silent);
  EXPECT_EQ(r.exhibit.screen.force, 0);
  EXPECT_EQ(r.exhibit.reader.file_mb, 32);
  EXPECT_EQ(r.exhibit.reader.vertices, 200000);
  EXPECT_EQ(r.exhibit.reader.triangles, ReaderLimits{}.triangles);
}

TEST_F(ExhibitTest, a_vessel_is_named_once_in_each_list_of_the_shelf) {
  const ExhibitRead r = read("order = [\"a\", \"b\", \"a\"]\nhidden = []\n");
  ASSERT_THAT(r.problems, SizeIs(1)) << all(r.problems);
  EXPECT_THAT(r.problems[0].where, EndsWith("exhibit.toml:1:20"));
  EXPECT_THAT(r.problems[0].what, HasSubstr("\"a\" is named twice."));
  EXPECT_THAT(r.exhibit.order, ElementsAre("a", "b"));
  EXPECT_THAT(read("hidden = []\n").exhibit.order, ElementsAre("moon_jar"));
  EXPECT_THAT(read("order = []\n").exhibit.order, IsEmpty());
}

TEST_F(ExhibitTest, a_vessel_may_have_a_scene_of_its_own) {
  std::ofstream(museum_ / "exhibit/scenes/master.toml") << "";
  const ExhibitRead r = read(R"([vessel_scenes]
moon_jar = "scenes/master.toml"
tea_bowl = "scenes/mastre.toml"
amphora = 3
)");
  EXPECT_EQ(
      r.exhibit.vessel_scenes,
      (std::map<std::string, fs::path>{{"moon_jar", museum_ / "exhibit/scenes/master.toml"}}));
  ASSERT_THAT(r.problems, SizeIs(2)) << all(r.problems);
  EXPECT_THAT(r.problems[0].where, EndsWith("exhibit.toml:3:12"));
  EXPECT_THAT(r.problems[0].what, HasSubstr("mastre.toml"));
  EXPECT_THAT(r.problems[1].where, EndsWith("exhibit.toml:4:11"));
}

TEST_F(ExhibitTest, vessels_that_were_built_have_a_scene_where_there_is_one) {
  EXPECT_EQ(read("").exhibit.built_scene, std::nullopt) << "the default file is missing";
  std::ofstream(museum_ / "exhibit/scenes/built.toml") << "";
  EXPECT_EQ(read("").exhibit.built_scene, museum_ / "exhibit/scenes/built.toml");
  const ExhibitRead r = read("built_scene = \"scenes/bulit.toml\"\nbuild = false\n");
  ASSERT_THAT(r.problems, SizeIs(1)) << all(r.problems);
  EXPECT_THAT(r.problems[0].where, EndsWith("exhibit.toml:1:15"));
  EXPECT_FALSE(r.exhibit.build);
}

TEST_F(ExhibitTest, all_problems_are_told_at_once_and_good_values_are_kept) {
  const ExhibitRead r = read(R"(credit = "Museum"
languages = ["en", "ko"]
shelf = "../contents/vessels"
scene = "scenes/frist_touch.toml"
idle.warn_after = 5
idle.countdown = "long"
idle.result_aftre = 90
keepsake.quota_mb = 50
)");
  ASSERT_THAT(r.problems, SizeIs(5)) << all(r.problems);
  EXPECT_THAT(r.problems[0].where, EndsWith("exhibit.toml:3:9"));
  EXPECT_THAT(r.problems[0].what, HasSubstr((museum_ / "contents/vessels").string()));
  EXPECT_THAT(r.problems[1].where, EndsWith("exhibit.toml:4:9"));
  EXPECT_THAT(r.problems[1].what, HasSubstr("frist_touch.toml"));
  EXPECT_EQ(r.problems[2].what, "idle.warn_after is 5 s, but the smallest allowed value is 20 s.");
  EXPECT_THAT(r.problems[3].what, HasSubstr("is the text \"long\""));
  EXPECT_EQ(r.problems[4].remedy, "Did you mean result_after?");
  EXPECT_EQ(r.exhibit.credit, "Museum");
  EXPECT_EQ(r.exhibit.keepsake.quota_mb, 50);
  EXPECT_EQ(r.exhibit.idle.warn_after, 60.0) << "the default stands where the value is no good";
}

TEST_F(ExhibitTest, a_language_without_words_or_title_is_named) {
  const ExhibitRead r = read("languages = [\"en\", \"ja\"]\n[title]\nen = \"Throw\"\n");
  ASSERT_THAT(r.problems, SizeIs(2)) << all(r.problems);
  EXPECT_THAT(r.problems[0].where, EndsWith(":1:20"));
  EXPECT_THAT(r.problems[0].remedy, HasSubstr("ja.toml"));
  EXPECT_EQ(r.problems[1].what, "There is no title for the language \"ja\".");
  EXPECT_EQ(r.exhibit.title.at("ja"), "Throw") << "a visitor still sees a title";
}

TEST_F(ExhibitTest,
       a_language_without_a_title_shows_the_english_one_else_that_of_the_first_language) {
  const ExhibitRead english = read(
      "languages = [\"ko\", \"de\", \"ja\", \"en\"]\n"
      "[title]\nko = \"빚기\"\nde = \"Töpfern\"\nen = \"Throw\"\n");
  EXPECT_EQ(english.exhibit.title.at("ja"), "Throw");
  EXPECT_EQ(english.exhibit.title.at("de"), "Töpfern");
  const ExhibitRead none =
      read("languages = [\"ko\", \"de\", \"ja\"]\n[title]\nko = \"빚기\"\nde = \"Töpfern\"\n");
  EXPECT_EQ(none.exhibit.title.at("ja"), "빚기") << "de comes before ko only in the alphabet";
  for (const ExhibitRead& r : {english, none})
    EXPECT_THAT(all(r.problems), HasSubstr("There is no title for the language \"ja\"."));
}

TEST_F(ExhibitTest, a_language_code_can_never_lead_out_of_its_folder) {
  for (const std::string code : {"../en", "/etc/passwd", "", "e", "en/", "en_US", "en.", "-en"}) {
    const ExhibitRead r = read("languages = [\"" + code + "\", \"en\"]\n");
    ASSERT_THAT(r.problems, SizeIs(1)) << code << "\n" << all(r.problems);
    EXPECT_THAT(r.problems[0].what, HasSubstr("is not a language code"));
    EXPECT_THAT(r.exhibit.languages, ElementsAre("en"));
  }
}

TEST_F(ExhibitTest, languages_are_one_to_twelve_and_each_once) {
  EXPECT_THAT(read("languages = []\n").problems, SizeIs(1));
  EXPECT_THAT(read("languages = [\"en\", \"en\"]\n").problems, SizeIs(1));
  const ExhibitRead r = read("languages = [1, \"en\"]\n");
  ASSERT_THAT(r.problems, SizeIs(1));
  EXPECT_EQ(r.problems[0].what, "languages[0] is 1, but must be a text.");
  EXPECT_THAT(r.exhibit.languages, ElementsAre("en", "ko"));
}

TEST_F(ExhibitTest, words_that_would_not_fit_the_postcard_are_refused) {
  EXPECT_THAT(read("credit = \"" + std::string(121, 'x') + "\"\n").problems, SizeIs(1));
  EXPECT_THAT(read("credit = \"two\\nlines\"\n").problems, SizeIs(1));
  EXPECT_THAT(read("credit = \"  \"\n").problems, SizeIs(1));
  std::string hangul;
  for (int i = 0; i < 120; ++i) hangul += "항";
  EXPECT_THAT(read("credit = \"" + hangul + "\"\n").problems, IsEmpty()) << "letters, not bytes";
}

TEST_F(ExhibitTest, paths_that_cannot_be_meant_are_refused) {
  EXPECT_THAT(read("[keepsake]\nfolder = \"~/keepsakes\"\n").problems, SizeIs(1));
  EXPECT_THAT(read("[keepsake]\nfolder = \"\"\n").problems, SizeIs(1));
  EXPECT_THAT(read("[keepsake]\nfolder = \"a\\u0000b\"\n").problems, SizeIs(1));
  const ExhibitRead r = read("[keepsake]\nfolder = \"exhibit.toml\"\n");
  ASSERT_THAT(r.problems, SizeIs(1));
  EXPECT_THAT(r.problems[0].what, HasSubstr("is a file, not a folder"));
}

TEST_F(ExhibitTest, glazes_that_are_not_there_are_told) {
  const ExhibitRead r = read("glazes = \"jars.toml\"\n");
  ASSERT_THAT(r.problems, SizeIs(1)) << all(r.problems);
  EXPECT_THAT(r.problems[0].where, EndsWith(":1:10"));
  EXPECT_THAT(r.problems[0].what, HasSubstr("no file"));
}

TEST_F(ExhibitTest, a_file_that_is_not_there_leaves_an_exhibit_of_defaults) {
  const ExhibitRead r = read_exhibit(museum_ / "exhibit/other.toml");
  ASSERT_THAT(r.problems, SizeIs(1));
  EXPECT_EQ(r.exhibit.shelf, museum_ / "content/vessels");
}

TEST_F(ExhibitTest, a_day_without_hours_is_named_and_hours_that_are_none_keep_nobody_out) {
  const ExhibitRead r = read(R"([hours]
monday = "closed"
tuesday = "ten to six"
wednesday = "10:00-18:00"
thursday = "10:00-18:00"
friday = "10:00-18:00"
saturday = "10:00-18:00"
[hours.exceptions]
"24.12." = "closed"
"12-25" = "closed")");
  EXPECT_THAT(r.problems, SizeIs(3)) << all(r.problems);
  EXPECT_THAT(all(r.problems), HasSubstr("There are no hours for sunday."));
  EXPECT_THAT(all(r.problems), HasSubstr("\"24.12.\" is not a valid date."));
  EXPECT_THAT(all(r.problems),
              HasSubstr("tuesday is \"ten to six\", which cannot be read as opening hours."));
  EXPECT_TRUE(r.exhibit.hours.open_at({2026, 11, 24, 0})) << "a Tuesday";
  EXPECT_FALSE(r.exhibit.hours.open_at({2026, 11, 23, 720})) << "a Monday";
  EXPECT_FALSE(r.exhibit.hours.open_at({2026, 12, 25, 720}));
  EXPECT_TRUE(read("").exhibit.hours.open_at({2026, 11, 23, 0}));
}

TEST_F(ExhibitTest, an_address_that_no_phone_opens_is_named_and_no_code_is_shown) {
  const ExhibitRead good = read("[phone]\naddress = \"http://192.168.4.1:8080/\"\nhours = 48");
  EXPECT_THAT(good.problems, IsEmpty()) << all(good.problems);
  EXPECT_EQ(good.exhibit.phone.address, "http://192.168.4.1:8080");
  EXPECT_EQ(good.exhibit.phone.hours, 48);
  for (const char* right : {"https://pots.museum.org/wheel", "http://kiosk", "http://[fe80::1]:80"})
    EXPECT_EQ(read(std::string("[phone]\naddress = \"") + right + "\"").exhibit.phone.address,
              right);
  for (const char* wrong : {"192.168.4.1", "ftp://a", "http://a b", "http:", "http://a:99999/x",
                            "http://a?b", "http://a#b", "http://[::1", "http://user@a", "http://..",
                            "http://a:b", "http://-", "http://a:0"}) {
    const ExhibitRead r = read(std::string("[phone]\naddress = \"") + wrong + "\"");
    EXPECT_THAT(all(r.problems), HasSubstr("not an address that a phone can open")) << wrong;
    EXPECT_EQ(r.exhibit.phone.address, "");
  }
}

std::string join(const ExhibitRead& read) {
  return wifi_code(read.exhibit.phone.network, read.exhibit.phone.password);
}

TEST_F(ExhibitTest, a_phone_joins_the_kiosks_own_network_by_what_its_code_says) {
  const std::string address = "[phone]\naddress = \"http://192.168.4.1\"\n";
  EXPECT_EQ(join(read(address)), "");
  EXPECT_EQ(join(read(address + "network = \"Onggi\"")), "WIFI:T:nopass;S:Onggi;;");
  // What has a meaning in the code is escaped, and the password never comes first.
  const ExhibitRead good =
      read(address + "network = \"Wheel; \\\"a\\\", b:c\"\npassword = \"moon;jar:1,2\"");
  EXPECT_THAT(good.problems, IsEmpty()) << all(good.problems);
  EXPECT_EQ(join(good), R"(WIFI:T:WPA;S:Wheel\; \"a\"\, b\:c;P:moon\;jar\:1\,2;;)");
  for (const std::string& wrong : {std::string(33, 'n'), std::string("a\\u0007b")}) {
    const ExhibitRead r = read(address + "network = \"" + wrong + "\"");
    EXPECT_THAT(all(r.problems), HasSubstr("not a valid network name")) << wrong;
    EXPECT_EQ(join(r), "");
  }
  for (const std::string& wrong :
       {std::string("seven77"), std::string(64, 'p'), std::string("달항아리달항아리")}) {
    const ExhibitRead r = read(address + "password = \"" + wrong + "\"");
    EXPECT_THAT(all(r.problems), HasSubstr("not a valid WPA2 password")) << wrong;
    EXPECT_THAT(all(r.problems), Not(HasSubstr(wrong))) << "a log is no place for it";
  }
  EXPECT_THAT(all(read("[phone]\nnetwork = \"Onggi\"").problems), HasSubstr("but no address"));
}

TEST(exhibit, the_exhibit_that_ships_is_without_fault) {
  const ExhibitRead r = read_exhibit("config/exhibit.toml");
  EXPECT_THAT(r.problems, IsEmpty()) << all(r.problems);
  EXPECT_GE(r.keys_checked, 46);
}

}  // namespace
}  // namespace onggi::settings::exhibit_test
