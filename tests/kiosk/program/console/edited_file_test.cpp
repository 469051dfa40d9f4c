#include "kiosk/program/console/edited_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <random>

#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/ground/toml/stand_in.h"
#include "tests/kiosk/exhibit/editing/small_site.h"

namespace onggi::console::edited_file_test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class Editing : public ::testing::Test {
 protected:
  EditedFile file(const std::string& name) { return *EditedFile::find(site_, name); }
  /// What is wrong with `changes`, a JSON list.
  std::vector<ChangeFault> faults(const std::string& name, const std::string& changes) {
    const EditedFile edited = file(name);
    const auto wanted = edited.changes_in(R"({"changes": )" + changes + "}");
    EXPECT_TRUE(wanted) << changes;
    std::vector<ChangeFault> out;
    draft_ = edited.draft_of(*edited.text(), *wanted, out);
    for (ChangeFault& fault : edited.faults_of(draft_, *edited.text())) out.push_back(fault);
    return out;
  }
  /// The exhibit as it would be.
  settings::Exhibit as_changed() const {
    const toml::StandIn change(folder_.exhibit(), draft_.text);
    return settings::read_exhibit(folder_.exhibit()).exhibit;
  }

  editing::test::SmallSite folder_;
  Site site_ = *Site::open(folder_.path());
  changes::Draft draft_;
};

TEST_F(Editing, WhatTheReaderRefusesIsSaidAtItsKeyInTheReadersWords) {
  const auto wrong = faults("exhibit", R"([["idle.warn_after", 5], ["credit", "Clay"]])");
  ASSERT_EQ(wrong.size(), 1u);
  EXPECT_EQ(wrong[0].key, "idle.warn_after");
  EXPECT_THAT(wrong[0].what, HasSubstr("the smallest allowed value is 20 s"));
  EXPECT_FALSE(wrong[0].remedy.empty());
  const auto word = faults("exhibit", R"([["idle.warn_after", "soon"]])");
  ASSERT_EQ(word.size(), 1u);
  EXPECT_THAT(word[0].what, HasSubstr("not a number"));
  const auto hours = faults("exhibit", R"([["hours.monday", "10-12"]])");
  EXPECT_TRUE(std::ranges::any_of(
      hours, [](const ChangeFault& fault) { return fault.key == "hours.monday"; }));
  // Six days without hours are one field's fault.
  for (const ChangeFault& fault : faults("exhibit", R"([["hours.monday", "closed"]])"))
    EXPECT_EQ(fault.key, "hours.every_day");
  const auto language = faults("exhibit", R"([["languages", ["en", "xx"]], ["title.ko", null]])");
  ASSERT_EQ(language.size(), 2u);
  EXPECT_EQ(language[0].key, "languages");
  EXPECT_EQ(language[1].key, "title.xx");
  EXPECT_TRUE(faults("exhibit", R"([["idle.warn_after", 90], ["sound.volume", 0.25]])").empty());
}

TEST_F(Editing, EveryFaultOfSeveralIsSaidAtOnce) {
  const auto wrong = faults(
      "exhibit", R"([["idle.warn_after", 5], ["sound.volume", 7], ["credit", ""], ["no.key", 1]])");
  std::vector<std::string> keys;
  for (const ChangeFault& fault : wrong) keys.push_back(fault.key);
  EXPECT_THAT(
      keys, ::testing::UnorderedElementsAre("idle.warn_after", "sound.volume", "credit", "no.key"));
}

TEST_F(Editing, AnOldFaultIsNoFaultOfTheChange) {
  folder_.by_hand("config/exhibit.toml", "countdown = 25 ", "countdown = 1 ");
  EXPECT_TRUE(faults("exhibit", R"([["credit", "Clay"]])").empty());
}

TEST_F(Editing, ALabelIsCheckedAsAVesselsFileIs) {
  const auto wrong =
      faults("vessel/moon_jar", R"([["label.en.title", "   "], ["true_height_mm", 2]])");
  std::vector<std::string> keys;
  for (const ChangeFault& fault : wrong) keys.push_back(fault.key);
  EXPECT_THAT(keys, ::testing::UnorderedElementsAre("label.en.title", "true_height_mm"));
  const auto gone = faults("vessel/moon_jar", R"([["label.en.culture", null]])");
  ASSERT_EQ(gone.size(), 1u);
  EXPECT_EQ(gone[0].key, "label.en.culture");
  EXPECT_TRUE(faults("vessel/moon_jar", R"([["label.ko.title", "달항아리 둘"]])").empty());
}

TEST_F(Editing, WhatAnUnfinishedVesselLacksIsSaidAtItsFieldsWhenVisitorsShallSeeIt) {
  folder_.by_hand("content/vessels/moon_jar/vessel.toml", "true_height_mm",
                  "unfinished = true\ntrue_height_mm");
  folder_.by_hand("content/vessels/moon_jar/vessel.toml", "institution =", "# institution =");
  EXPECT_TRUE(faults("vessel/moon_jar", R"([["label.ko.title", "달항아리 둘"]])").empty());
  for (const char* value : {"null", "false"}) {
    const auto gaps = faults("vessel/moon_jar", std::string(R"([["unfinished", )") + value + "]]");
    ASSERT_EQ(gaps.size(), 1u) << value;
    EXPECT_EQ(gaps[0].key, "institution");
  }
}

TEST_F(Editing, ALabelOfAnUnfinishedVesselMayBeHalfWritten) {
  constexpr const char* kHalf = R"([["label.ko.culture", null], ["label.ko.made", null]])";
  EXPECT_FALSE(faults("vessel/moon_jar", kHalf).empty()) << "visitors would see it";
  folder_.by_hand("content/vessels/moon_jar/vessel.toml", "true_height_mm",
                  "unfinished = true\ntrue_height_mm");
  EXPECT_TRUE(faults("vessel/moon_jar", kHalf).empty());
  // Without a title it is no label.
  const auto bare = faults("vessel/moon_jar", R"([["label.ko.title", null]])");
  ASSERT_EQ(bare.size(), 1u);
  EXPECT_EQ(bare[0].key, "label.ko.title");
}

TEST_F(Editing, WhereFilesLieOnTheMachineIsNotChangedHere) {
  for (const char* key : {"shelf", "rubric", "keepsake.folder", "reader.file_mb", "phone.address",
                          "vessel_scenes.moon_jar", "missions"}) {
    const auto wrong = faults("exhibit", std::string("[[\"") + key + R"(", "/etc"]])");
    ASSERT_EQ(wrong.size(), 1u) << key;
    EXPECT_TRUE(draft_.values.empty()) << key;
  }
  EXPECT_EQ(faults("vessel/moon_jar", R"([["drawing", "../../../secret.toml"]])").size(), 1u);
}

TEST_F(Editing, ASceneIsChosenAmongThoseBesideTheExhibit) {
  EXPECT_TRUE(faults("exhibit", R"([["scene", "scenes/studio.toml"]])").empty());
  EXPECT_EQ(as_changed().scene.filename(), "studio.toml");
  EXPECT_TRUE(faults("exhibit", R"([["built_scene", null]])").empty());
  folder_.write("config/elsewhere.toml", "[kiln]\n");
  for (const char* other :
       {"elsewhere.toml", "scenes/../elsewhere.toml", "scenes/none.toml", "./scenes/studio.toml",
        "scenes/studio.toml/", "'scenes/studio.toml'"}) {
    const auto wrong = faults("exhibit", nlohmann::json::array({{"scene", other}}).dump());
    ASSERT_FALSE(wrong.empty()) << other;
    EXPECT_EQ(wrong[0].key, "scene") << other;
    EXPECT_TRUE(draft_.values.empty()) << other;
  }
}

TEST_F(Editing, AnEffectIsAddedOrTakenOutAndWhatItLacksIsSaidAtItsSwitch) {
  const auto alone = faults("scene/first_touch", R"([["slump", {}]])");
  ASSERT_EQ(alone.size(), 1u);
  EXPECT_EQ(alone[0].key, "slump");
  EXPECT_THAT(alone[0].what, HasSubstr("slump needs volume"));
  EXPECT_TRUE(faults("scene/first_touch", R"([["slump", {}], ["volume", {}]])").empty());
  EXPECT_TRUE(faults("scene/first_touch", R"([["friction", null]])").empty());
  EXPECT_THAT(draft_.text, ::testing::Not(HasSubstr("\n[friction]\n")));
  // The last limit on forces is not for a page, nor is what is no effect.
  for (const char* key : {"guard.max_force", "guard", "paper", "paper.c_eta", "clay"})
    for (const char* value : {"{}", "2.5", "null"}) {
      EXPECT_EQ(
          faults("scene/first_touch", std::string("[[\"") + key + "\", " + value + "]]").size(), 1u)
          << key << value;
      EXPECT_TRUE(draft_.values.empty()) << key << value;
    }
}

TEST_F(Editing, WhatANewMissionLacksIsSaidAtItsFields) {
  std::vector<std::string> keys;
  for (const ChangeFault& fault :
       faults("missions", R"([["mission.cup", {}], ["mission.cup.kind", "today"]])"))
    keys.push_back(fault.key);
  EXPECT_THAT(keys, ::testing::IsSupersetOf({"mission.cup.title.en", "mission.cup.title.ko"}));
  EXPECT_TRUE(faults("missions", R"([["mission.litre_jar", null]])").empty());
  for (const char* typed : {R"("60, 90")", R"("[60, 90]")", "[60, 90]"})
    EXPECT_TRUE(
        faults("missions", std::string(R"([["mission.litre_jar.height_mm", )") + typed + "]]")
            .empty())
        << typed;
}

TEST_F(Editing, WordsAreOfTheSiteAndKeepTheirPlaces) {
  EXPECT_TRUE(faults("language/ko", R"([["text.attract.begin", "여기를 누르세요"]])").empty());
  const auto wrong = faults("language/ko", R"([["text.all.list", "하나"]])");
  ASSERT_EQ(wrong.size(), 1u);
  EXPECT_EQ(wrong[0].key, "text.all.list");
  const auto gone = faults("language/ko", R"([["text.attract.begin", null]])");
  ASSERT_EQ(gone.size(), 1u);
  EXPECT_EQ(gone[0].key, "text.attract.begin");
  EXPECT_EQ(faults("language/ko", R"([["code", "fr"]])").size(), 1u);
  fs::remove_all(folder_ / "content/languages");
  EXPECT_FALSE(EditedFile::find(site_, "language/ko")) << "those of the program are nobody's here";
}

TEST_F(Editing, AVesselIsAFolderOfTheShelfAndNothingElse) {
  folder_.write("content/vessel.toml", "true_height_mm = 1\n");
  for (const char* name :
       {"vessel/..", "vessel/../vessels/moon_jar", "vessel/", "vessel/.", "vessel/none",
        "vessel/moon_jar/..", "", "scene", "exhibit/", "scene/../exhibit", "scene/none",
        "scene/a\nb", "language/../glazes", "language/"})
    EXPECT_FALSE(EditedFile::find(site_, name)) << name;
  EXPECT_FALSE(EditedFile::find(site_, std::string("scene/studio.toml\0", 18)));
  EXPECT_TRUE(EditedFile::find(site_, "vessel/moon_jar"));
}

TEST_F(Editing, WhatIsNoListOfChangesIsRefused) {
  const EditedFile edited = file("exhibit");
  const auto in = [](const std::string& list) { return R"({"changes": )" + list + "}"; };
  for (const char* wrong : {"", "{}", "[1]", R"([["a"]])", R"([["a", {"b": 1}]])", R"([[1, 2]])",
                            R"([["a", [[1]]]])", "[["}) {
    EXPECT_FALSE(edited.changes_in(in(wrong))) << wrong;
    EXPECT_FALSE(edited.changes_in(wrong)) << wrong;
  }
  // As deep as a body may be.
  const std::string deep = std::string(60'000, '[') + std::string(60'000, ']');
  EXPECT_FALSE(edited.changes_in(in(R"([["credit", )" + deep + "]]")));
  EXPECT_TRUE(edited.changes_in(in("[]")));
}

TEST_F(Editing, ATextOfAnyLettersIsWrittenSoThatItReadsBackTheSame) {
  std::mt19937 random(4);
  static const std::vector<std::string> kLetters{
      "a", "'", "\"", "\\", "#", "é", "도", "器", "=", "[", ", ", "\xF0\x9F\x8F\xBA", "{", "%"};
  for (int n = 0; n < 200; ++n) {
    std::string text = "x";
    for (std::size_t k = random() % 12; k > 0; --k) text += kLetters[random() % kLetters.size()];
    const nlohmann::json change = {{"credit", text}};
    ASSERT_TRUE(faults("exhibit", nlohmann::json::array({{"credit", text}}).dump()).empty())
        << text;
    EXPECT_EQ(as_changed().credit, text);
  }
}

TEST_F(Editing, AnEmptyPlaceTakesTheKeyOutAndItsDefaultHolds) {
  EXPECT_TRUE(faults("exhibit", R"([["idle.countdown", null], ["order", ["moon_jar"]]])").empty());
  EXPECT_THAT(draft_.text, ::testing::Not(HasSubstr("countdown")));
  EXPECT_EQ(as_changed().idle.countdown, 25);
}

}  // namespace
}  // namespace onggi::console::edited_file_test
