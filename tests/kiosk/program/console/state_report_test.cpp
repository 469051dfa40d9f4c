#include "kiosk/program/console/state_report.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace onggi::console::state_report_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr std::int64_t kNow = 1'780'000'000;
constexpr const char* kExhibit = "/srv/onggi/config/exhibit.toml";

/// A kiosk that is well, an hour after it was opened.
Known well() {
  Known k;
  watch::KioskState s;
  s.health.version = "0.1.0";
  s.health.running_s = 3600;
  s.health.wakes = 3'600'000;
  s.exhibit = kExhibit;
  s.said = kNow - 5;
  s.open = true;
  s.vessel = "moon_jar";
  s.frames_a_second = 60;
  k.kiosk = {s, true};
  k.now = kNow;
  k.exhibit = kExhibit;
  k.vessel = "moon jar";
  k.free_bytes = 12'000'000'000;
  return k;
}

/// What an English page says.
std::string english(const Sentence& sentence) {
  if (sentence.english.empty()) return std::to_string(sentence.count);
  std::string text = sentence.one.empty() || sentence.count != 1 ? sentence.english : sentence.one;
  const auto fill = [&](const std::string& name, const std::string& words) {
    for (std::size_t at; (at = text.find('{' + name + '}')) != std::string::npos;)
      text.replace(at, name.size() + 2, words);
  };
  if (!sentence.one.empty()) fill("count", std::to_string(sentence.count));
  for (const auto& [name, words] : sentence.values) fill(name, english(words));
  return text;
}

std::string english(const std::vector<Sentence>& sentences) {
  std::string text;
  for (const Sentence& sentence : sentences) text += (text.empty() ? "" : " ") + english(sentence);
  return text;
}

const Line* line(const std::vector<Line>& lines, const std::string& id) {
  const auto found = std::ranges::find(lines, id, &Line::id);
  return found == lines.end() ? nullptr : &*found;
}

TEST(StateReport, OfAKioskThatIsWellSaysSoInWordsAndAsksForNothing) {
  const auto lines = report_of(well());
  for (const Line& one : lines) {
    EXPECT_EQ(one.mood, Mood::good) << one.id << ": " << english(one.says);
    EXPECT_EQ(one.remedy.english, "") << one.id;
    EXPECT_TRUE(english(one.says).ends_with('.')) << english(one.says);
    EXPECT_EQ(english(one.says).find('{'), std::string::npos) << english(one.says);
  }
  EXPECT_EQ(lines.front().id, "kiosk");
  EXPECT_THAT(english(lines.front().says),
              HasSubstr("waits for a visitor, with the moon jar on the wheel."));
  EXPECT_THAT(english(line(lines, "wheel")->says), HasSubstr("0 of 3600000 ticks were late"));
  EXPECT_EQ(english(line(lines, "disk")->says), "12.0 GB are free for keepsakes.");
  EXPECT_EQ(line(lines, "phones"), nullptr);
  EXPECT_EQ(line(lines, "trouble"), nullptr);
  EXPECT_THAT(json_of(lines).text(-1), HasSubstr("\"mood\":\"good\""));
}

TEST(StateReport, SaysWhatIsWrongAndWhatToDo) {
  struct Case {
    const char* id;
    Mood mood;
    const char* says;
    void (*spoil)(Known&);
  };
  const Case cases[] = {
      {"kiosk", Mood::wrong, "stopped without being closed",
       [](Known& k) { k.kiosk.runs = false; }},
      {"kiosk", Mood::look, "switched off",
       [](Known& k) { k.kiosk.runs = false, k.kiosk.state->ended = true; }},
      {"kiosk", Mood::wrong, "has left no word here", [](Known& k) { k.kiosk = {}; }},
      {"kiosk", Mood::wrong, "has said nothing since",
       [](Known& k) { k.kiosk.state->said = kNow - 60; }},
      {"kiosk", Mood::look, "the machine's clock was set back",
       [](Known& k) { k.kiosk.state->said = kNow + 86'400; }},
      {"kiosk", Mood::wrong, "another exhibit than yours",
       [](Known& k) { k.kiosk.state->stands_in = true; }},
      {"kiosk", Mood::look, "this page is about",
       [](Known& k) { k.kiosk.state->exhibit = "/elsewhere/config/exhibit.toml"; }},
      {"picture", Mood::look, "12 pictures a second",
       [](Known& k) { k.kiosk.state->frames_a_second = 12; }},
      {"wheel", Mood::look, "1000 were lost",
       [](Known& k) { k.kiosk.state->health.lost_ticks = 1000; }},
      {"keepsakes", Mood::wrong, "2 could not be saved",
       [](Known& k) { k.kiosk.state->health.not_kept = 2; }},
      {"disk", Mood::look, "900 MB", [](Known& k) { k.free_bytes = 900'000'000; }},
      {"disk", Mood::wrong, "50 MB", [](Known& k) { k.free_bytes = 50'000'000; }},
      {"disk", Mood::wrong, "cannot be read", [](Known& k) { k.free_bytes.reset(); }},
      {"files", Mood::wrong, "2 problems", [](Known& k) { k.file_problems = 2; }},
      {"phones", Mood::wrong, "no answer", [](Known& k) { k.phones_answered = false; }},
      {"trouble", Mood::look, "the last of 3",
       [](Known& k) {
         k.kiosk.state->trouble =
             files::Trouble{{"a.toml", "It is wrong.", "Mend it."}, kNow - 60, 3};
       }},
  };
  for (const Case& c : cases) {
    Known k = well();
    c.spoil(k);
    const auto lines = report_of(k);
    const Line* found = line(lines, c.id);
    ASSERT_NE(found, nullptr) << c.says;
    EXPECT_THAT(english(found->says), HasSubstr(c.says));
    EXPECT_EQ(found->mood, c.mood) << c.says;
    EXPECT_NE(found->remedy.english, "") << c.says;
    EXPECT_EQ((english(found->says) + english(found->remedy)).find('{'), std::string::npos)
        << english(found->says);
    // Nothing else is spoiled by it, but for what a silent kiosk no longer says.
    for (const Line& other : lines) {
      if (other.id != c.id) {
        EXPECT_EQ(other.mood, Mood::good) << english(other.says);
      }
    }
  }
}

TEST(StateReport, IsSentAsSentencesThatAPageSaysInItsOwnLanguage) {
  Known k = well();
  k.file_problems = 1;
  k.kiosk.state->trouble = files::Trouble{{"a.toml", "It is wrong.", "Mend it."}, kNow - 60, 1};
  const std::string json = json_of(report_of(k)).text(-1);
  EXPECT_THAT(
      json, HasSubstr(R"("english":"onggi check finds {count} problems in the exhibit's files.")"));
  EXPECT_THAT(json, HasSubstr(R"("one":"onggi check finds one problem in the exhibit's files.")"));
  EXPECT_THAT(json, HasSubstr(R"("count":1)"));
  // A sentence within another one, and a name that is the same in every language.
  EXPECT_THAT(json, HasSubstr(R"("when":{"english":"today at {time}","values":{"time":")"));
  EXPECT_THAT(json, HasSubstr(R"("values":{"vessel":"moon jar"})"));
  EXPECT_THAT(json, HasSubstr(R"({"english":"Mend it.","values":{},"theirs":true})"));
  EXPECT_THAT(json, HasSubstr(R"("all":3600000)"));  // each language writes a number in its own way
  EXPECT_THAT(json_of(report_of(well())).text(-1), HasSubstr(R"("remedy":null)"));
}

TEST(StateReport, OfAKioskThatIsOffSaysNothingOfPictureWheelAndDevices) {
  Known k = well();
  k.kiosk.runs = false;
  const auto lines = report_of(k);
  for (const char* id : {"picture", "wheel", "keepsakes", "devices"})
    EXPECT_EQ(line(lines, id), nullptr) << id;
  EXPECT_NE(line(lines, "disk"), nullptr);
}

TEST(StateReport, InTheDarkAndWhileItBeginsFewPicturesAreNoFault) {
  Known k = well();
  k.kiosk.state->frames_a_second = 1;
  k.kiosk.state->health.dark = true;
  EXPECT_EQ(line(report_of(k), "picture")->mood, Mood::good);
  EXPECT_THAT(english(report_of(k).front().says), HasSubstr("outside the opening hours"));
  k.kiosk.state->health.dark = k.kiosk.state->open = false;
  EXPECT_EQ(line(report_of(k), "picture")->mood, Mood::good);
  EXPECT_THAT(english(report_of(k).front().says), HasSubstr("still reads the vessels"));
}

TEST(StateReport, ATroubleOfYesterdayIsToldAndIsNoLongerAWarning) {
  Known k = well();
  k.kiosk.state->trouble = files::Trouble{{"a.toml", "It is wrong.", "Mend it."}, kNow - 90'000, 1};
  const auto lines = report_of(k);
  EXPECT_EQ(line(lines, "trouble")->mood, Mood::good);
  EXPECT_THAT(english(line(lines, "trouble")->says), Not(HasSubstr("the last of")));
}

}  // namespace
}  // namespace onggi::console::state_report_test
