#include "kiosk/collection/settings/mission_file.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "kiosk/collection/settings/visitor_text.h"
#include "tests/kiosk/ground/files/disk.h"

namespace onggi::settings::mission_file_test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const std::vector<std::string> kShelf{"moon_jar", "tea_bowl"};

class MissionFile : public ::testing::Test {
 protected:
  MissionsRead read(const std::string& text, const std::vector<std::string>& languages = {"en"}) {
    const auto file = folder_.path() / "missions.toml";
    std::ofstream(file) << text;
    return read_missions(file, languages, kShelf);
  }
  static std::string mission(const std::string& id, const std::string& more) {
    return "[[mission]]\nid = \"" + id + "\"\n" + more +
           "title = { en = \"A jar\" }\nabout = { en = \"Throw it.\" }\n";
  }

 private:
  files::test::ScratchFolder folder_;
};

TEST(Missions, TheExhibitsOwnAreWithoutFaultInEveryLanguageAndAllAreOff) {
  std::vector<std::string> languages;
  for (const auto& one : std::filesystem::directory_iterator("content/languages"))
    languages.push_back(one.path().stem());
  const MissionsRead r = read_missions("content/missions.toml", languages);
  EXPECT_THAT(r.problems, IsEmpty()) << to_text(r.problems.front());
  std::set<Mission::Kind> kinds;
  for (const Mission& one : r.missions) {
    kinds.insert(one.kind);
    EXPECT_FALSE(one.on) << one.id << ": a curator switches it on";
    for (const std::string& code : languages) {
      EXPECT_EQ(one.title.count(code), 1u) << one.id << ' ' << code;
      EXPECT_EQ(one.about.count(code), 1u) << one.id << ' ' << code;
    }
  }
  EXPECT_EQ(kinds.size(), kMissionKinds.size()) << "one of each kind";
}

TEST_F(MissionFile, AGoodOneIsReadWhole) {
  const MissionsRead r = read(mission("today", "kind = \"today\"\nvessels = [\"tea_bowl\"]\n") +
                              mission("litre",
                                      "kind = \"describe\"\non = false\nlitres = 0.25\n"
                                      "height_mm = [80, 120]\nmouth_mm = [60, 60]\n"));
  EXPECT_THAT(r.problems, IsEmpty());
  ASSERT_THAT(r.missions, SizeIs(2));
  EXPECT_TRUE(r.missions[0].on);
  EXPECT_EQ(r.missions[0].vessels, std::vector<std::string>{"tea_bowl"});
  const Mission& litre = r.missions[1];
  EXPECT_EQ(litre.kind, Mission::Kind::describe);
  EXPECT_FALSE(litre.on);
  EXPECT_DOUBLE_EQ(litre.wanted.volume, 0.00025);
  EXPECT_DOUBLE_EQ(litre.wanted.height->most, 0.12);
  EXPECT_DOUBLE_EQ(litre.wanted.mouth->least, 0.06);
}

TEST_F(MissionFile, ABrokenOneIsNamedWithLineMeaningAndRemedyAndTheOthersStand) {
  const MissionsRead r = read(
      mission("a", "kind = \"todya\"\n") + mission("b", "kind = \"describe\"\nlitres = 30\n") +
      mission("c", "kind = \"today\"\nvessels = [\"moonjar\"]\n") +
      mission("good", "kind = \"today\"\n") + mission("good", "kind = \"today\"\n") +
      mission("d", "kind = \"describe\"\nlitres = 1\nheight_mm = [90]\n") +
      mission("e", "kind = \"today\"\nlitres = 1\n") + mission("moon_jar", "kind = \"today\"\n"));
  ASSERT_THAT(r.problems, SizeIs(7));
  EXPECT_THAT(r.problems[0].where, HasSubstr("missions.toml:3:"));
  EXPECT_THAT(r.problems[0].remedy, HasSubstr("Did you mean \"today\"?"));
  EXPECT_THAT(r.problems[1].what, HasSubstr("litres"));
  EXPECT_THAT(r.problems[2].remedy, HasSubstr("moon_jar"));
  EXPECT_THAT(r.problems[3].what, HasSubstr("two missions \"good\""));
  EXPECT_THAT(r.problems[4].what, HasSubstr("height_mm"));
  EXPECT_THAT(r.problems[5].what, HasSubstr("litres"));
  EXPECT_THAT(r.problems[6].what, HasSubstr("vessel on the shelf"));
  for (const Problem& one : r.problems) EXPECT_FALSE(one.remedy.empty()) << one.what;
  ASSERT_THAT(r.missions, SizeIs(2)) << "good, and e, of which a key is too many";
  EXPECT_EQ(r.missions[0].id, "good");
}

TEST_F(MissionFile, ALanguageThatIsMissingIsNamedAndEnglishStandsThere) {
  const MissionsRead r = read(mission("a", "kind = \"today\"\n"), {"en", "ko"});
  ASSERT_THAT(r.problems, SizeIs(2)) << "of its title, and of what it says";
  EXPECT_THAT(r.problems[0].what, HasSubstr("\"ko\""));
  ASSERT_THAT(r.missions, SizeIs(1));
  EXPECT_EQ(r.missions[0].title_in("ko"), "A jar");
  const MissionsRead korean = read(
      "[[mission]]\nid = \"a\"\nkind = \"today\"\ntitle = { ko = \"그릇\" }\nabout = { ko = "
      "\"빚기\" }\n",
      {"ko"});
  ASSERT_THAT(korean.missions, SizeIs(1));
  EXPECT_EQ(korean.missions[0].title_in("fr"), "그릇") << "else the first there is";
}

TEST_F(MissionFile, OneThatNobodyCouldBeToldOfIsLeftOut) {
  for (const char* words : {"", "title = { en = \" \" }\n"}) {
    const MissionsRead r =
        read("[[mission]]\nid = \"a\"\nkind = \"today\"\nabout = { en = \"Throw it.\" }\n" +
             std::string(words));
    EXPECT_THAT(r.missions, IsEmpty());
    EXPECT_FALSE(r.problems.empty());
  }
  const std::string endless(bounds::kMissionTitle.letters + 1, 'x');
  const MissionsRead r = read(
      "[[mission]]\nid = \"a\"\nkind = \"today\"\nabout = { en = \"Throw it.\" }\ntitle = { en = "
      "\"" +
      endless + "\" }\n");
  EXPECT_THAT(r.missions, IsEmpty());
  EXPECT_THAT(r.problems.front().what, HasSubstr("41 letters"));
}

TEST_F(MissionFile, SixStandAndASeventhIsOneTooMany) {
  std::string text;
  for (int n = 0; n < 7; ++n) text += mission("m" + std::to_string(n), "kind = \"today\"\n");
  const MissionsRead r = read(text);
  EXPECT_THAT(r.missions, SizeIs(kMostMissions));
  ASSERT_THAT(r.problems, SizeIs(1));
  EXPECT_THAT(read("").problems, IsEmpty()) << "and none are none";
}

// Those that come with onggi are off, and a museum's shelf need not have their vessels.
TEST_F(MissionFile, OneThatIsOffMayNameAVesselThatIsNotOnTheShelf) {
  const std::string gone = "kind = \"eyes_closed\"\nvessel = \"amphora\"\n";
  const MissionsRead off =
      read(mission("a", "on = false\n" + gone) +
           mission("b", "on = false\nkind = \"today\"\nvessels = [\"urn\"]\n"));
  EXPECT_THAT(off.problems, IsEmpty());
  EXPECT_THAT(off.missions, SizeIs(2));
  EXPECT_THAT(read(mission("a", "on = true\n" + gone)).problems, SizeIs(1));
}

TEST_F(MissionFile, EyesAndHandsNameAVesselAndWhatTheSecondHas) {
  const MissionsRead r = read(mission("dark", "kind = \"eyes_closed\"\nvessel = \"tea_bowl\"\n") +
                              mission("two", "kind = \"two_hands\"\nsecond = \"keys\"\n") +
                              mission("a", "kind = \"two_hands\"\nsecond = \"key\"\n") +
                              mission("b", "kind = \"eyes_closed\"\nvessel = \"teabowl\"\n"));
  ASSERT_THAT(r.problems, SizeIs(2));
  EXPECT_THAT(r.problems[0].remedy, HasSubstr("\"keys\""));
  EXPECT_THAT(r.problems[1].remedy, HasSubstr("tea_bowl"));
  ASSERT_THAT(r.missions, SizeIs(2));
  EXPECT_EQ(r.missions[0].vessel, "tea_bowl");
  EXPECT_EQ(r.missions[1].vessel, "");
  EXPECT_EQ(r.missions[1].second, Mission::Second::keys);
}

}  // namespace
}  // namespace onggi::settings::mission_file_test
