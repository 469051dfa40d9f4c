#include "kiosk/visit/screens/measured_pot.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "kiosk/picture/render/text.h"
#include "tests/kiosk/visit/screens/layout_check.h"
#include "tests/kiosk/visit/screens/visitor.h"

// Missions as a visitor meets them: before the shelf, at the wheel, and in what they came to.

namespace onggi::screens::measured_pot_test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

settings::Mission todays() {
  settings::Mission mission;
  mission.id = "todays_vessel";
  mission.title = {{"en", "Today’s vessel"}};
  mission.about = {{"en", "Everybody throws this one today."}};
  return mission;
}

void to_the_shelf(Visitor& v) {
  v.touch("attract.begin");
  v.show();
  if (v.visit->screen() == ScreenId::clay) v.touch("clay.on");  // where strokes are made by buttons
}
void begin(Visitor& v, int mission = 0) {
  to_the_shelf(v);
  v.touch("choose.mission." + std::to_string(mission));
  v.touch("choose.throw");
  v.frames(1);
}
/// The pot on the wheel, hollow all the way up to `radius`.
void hollow(Visitor& v, double radius) {
  const auto sectors = static_cast<std::size_t>(v.clay.sectors());
  for (int j = v.clay.floor_rows(); j < v.clay.rows(); ++j)
    v.clay.shape(j, std::vector<float>(sectors, static_cast<float>(radius + 0.006)),
                 std::vector<float>(sectors, static_cast<float>(radius)));
  v.frames(1);
}
const StartPot* started(const std::vector<Request>& requests) {
  const StartPot* last = nullptr;
  for (const Request& one : requests)
    if (const auto* start = std::get_if<StartPot>(&one); start && !start->scripted) last = start;
  return last;
}

TEST(MissionOnTheShelf, StandsBeforeTheVesselsAndIsOneToTheKeysToo) {
  Visitor v;
  v.put_on(todays(), 2);
  v.put_on(Visitor::described(1));
  to_the_shelf(v);
  const auto today = v.visit->control("choose.mission.0"),
             jar = v.visit->control("choose.mission.1"), vessel = v.visit->control("choose.card.0");
  ASSERT_TRUE(today && jar && vessel);
  EXPECT_LT(today->x, jar->x);
  EXPECT_LT(jar->x, vessel->x);
  EXPECT_THAT(words_in(v.frame), HasSubstr("A jar that holds a litre"));
  Visitor keys;
  keys.put_on(todays(), 2);
  keys.key(view::Key::enter);
  keys.show();
  EXPECT_EQ(keys.visit->focus(), "choose.mission.0");
  for (const Control& c : keys.visit->reading().controls)
    if (c.id == "choose.mission.0") {
      EXPECT_THAT(c.words, HasSubstr("Today’s vessel"));
      EXPECT_THAT(c.words, HasSubstr(keys.vessels[2].labels["en"].title));
    }
}

TEST(MissionOnTheShelf, IsNotSpokenOfWhereNoneIsOn) {
  Visitor v;
  to_the_shelf(v);
  EXPECT_FALSE(v.visit->control("choose.mission.0"));
  EXPECT_THAT(words_in(v.frame), Not(HasSubstr("Mission")));
}

TEST(TodaysMission, IsThrownAsAnyVesselAndTheResultSaysWhatItWas) {
  Visitor v;
  v.put_on(todays(), 2);
  begin(v);
  const auto asked = v.requests();
  ASSERT_NE(started(asked), nullptr);
  EXPECT_EQ(started(asked)->card, 2);
  ASSERT_TRUE(v.visit->sight());
  v.touch("throw.done");
  v.frames(1);
  EXPECT_THAT(words_in(v.frame), HasSubstr("Today’s vessel: Moon jar"));
  EXPECT_TRUE(v.visit->control("result.figures"));
}

TEST(Description, SaysWhatThePotHoldsWhileItIsThrownAndWhatWouldBringItNearer) {
  Visitor v;
  v.put_on(Visitor::described(1));
  begin(v);
  EXPECT_EQ(started(v.requests())->card, own_card(0));
  for (const double radius : {0.03, 0.0409, 0.05}) {
    hollow(v, radius);
    const long hundredths = std::lround(v.clay.capacity() * 1e5);
    const std::string rest = std::to_string(100 + hundredths % 100).substr(1);
    std::string said = std::to_string(hundredths / 100) + '.' + rest;
    while (said.back() == '0') said.pop_back();
    if (said.back() == '.') said.pop_back();
    EXPECT_THAT(words_in(v.frame), HasSubstr("It holds " + said + " l of 1 l."));
    v.frames(3);
    EXPECT_THAT(words_in(v.frame), HasSubstr(hundredths < 97    ? "from inside"
                                             : hundredths > 110 ? "from outside"
                                                                : "should be lower"))
        << said;
  }
}

TEST(Description, SpeaksOfNoLineNorOfThePotThatStoodThereBefore) {
  Visitor v;
  v.put_on(Visitor::described(1));
  to_the_shelf(v);
  v.touch("choose.mission.0");
  v.touch("choose.throw");
  for (int n = 0; n < 90; ++n) {
    EXPECT_THAT(words_in(v.frame), Not(HasSubstr("to the line")));
    EXPECT_THAT(words_in(v.frame), Not(HasSubstr("Press")));
    v.show();
  }
}

TEST(Description, ChangesItsFiguresNoMoreThanTwiceASecond) {
  Visitor v;
  v.put_on(Visitor::described(1));
  begin(v);
  std::string before;
  int changes = 0;
  for (int n = 0; n < 90; ++n) {
    const auto sectors = static_cast<std::size_t>(v.clay.sectors());
    for (int j = v.clay.floor_rows(); j < v.clay.rows(); ++j)
      v.clay.shape(j, std::vector<float>(sectors, 0.08f),
                   std::vector<float>(sectors, 0.03f + 0.0003f * static_cast<float>(n)));
    v.show();
    const std::string now = v.visit->reading().words.size() > 1 ? words_in(v.frame) : "";
    changes += now != before ? 1 : 0;
    before = now;
  }
  EXPECT_GE(changes, 3);
  EXPECT_LE(changes, 8) << "of ninety frames in three seconds; hints come every two";
}

TEST(Description, IsJudgedByItsFiguresWithNoVesselBesideIt) {
  Visitor v(9, nullptr, true);
  v.put_on(Visitor::described(1));
  begin(v);
  hollow(v, 0.0409);
  v.touch("throw.done");
  v.frames(1);
  EXPECT_EQ(v.visit->screen(), ScreenId::result);
  ASSERT_TRUE(v.frame.pot);
  EXPECT_FALSE(v.frame.pot->beside) << "there is none";
  const std::string words = words_in(v.frame);
  EXPECT_THAT(words, HasSubstr("The task"));
  EXPECT_THAT(words, HasSubstr("l of 1 l."));
  EXPECT_THAT(words, HasSubstr("The task: 100 to 150 mm."));
  EXPECT_FALSE(v.visit->control("result.figures")) << "the task is in figures already";
  EXPECT_EQ(v.visit->score().asked.size(), 3u);
  v.touch("result.keep");
  v.touch("kiln.glaze.0");
  v.frames(12);
  v.touch("kiln.keep");
  const auto asked = v.requests();
  const auto keep = std::find_if(asked.begin(), asked.end(), [](const Request& one) {
    return std::holds_alternative<MakeKeepsake>(one);
  });
  ASSERT_NE(keep, asked.end());
  EXPECT_EQ(std::get<MakeKeepsake>(*keep).card, own_card(0));
}

TEST(Description, IsToldToWhoDoesNotSeeTheScreen) {
  Visitor v;
  v.exhibit.screen.spoken = true;
  v.put_on(Visitor::described(1));
  begin(v);
  hollow(v, 0.03);
  v.touch("throw.tell");
  v.frames(1);
  const ScreenText reading = v.visit->reading();
  EXPECT_THAT(reading.differences, Contains(HasSubstr("l of 1 l.")));
  EXPECT_THAT(reading.differences, Contains("Try: Widen, Whole pot."));
  EXPECT_THAT(words_in(v.frame), Not(HasSubstr("from inside"))) << "it does not draw";
  for (const Control& c : reading.controls) EXPECT_THAT(c.note, Not(HasSubstr("mm")));
}

TEST(Description, AdvisesTheStrokeThatBringsItNearerByTheNamesOfItsButtons) {
  struct Case {
    double radius;
    settings::Mission::Described wanted;
    const char* advice;
  };
  using Bounds = settings::Mission::Described::Bounds;
  const double h = 0.2;  // of the lump, from which nobody's stroke takes anything
  const auto wants = [&](double litres, Bounds height, Bounds mouth) {
    settings::Mission::Described wanted;
    wanted.volume = 1e-3 * litres;
    wanted.height = height;
    wanted.mouth = mouth;
    return wanted;
  };
  const Bounds any{0.04, 0.2}, any_mouth{0.04, 0.22};
  for (const Case& one :
       {Case{0.03, wants(3, any, any_mouth), "Try: Widen, Whole pot."},
        Case{0.06, wants(0.1, any, any_mouth), "Try: Narrow, Whole pot."},
        Case{0.03, wants(0.5, any, {0.14, 0.2}), "Try: Widen, Rim."},
        Case{0.06, wants(1.9, any, {0.04, 0.06}), "Try: Narrow, Rim."},
        Case{0.04, wants(0.9, {0.04, 0.6 * h}, any_mouth), "It should be lower."}}) {
    SCOPED_TRACE(one.advice);
    Visitor v;
    v.exhibit.screen.one_switch = true;
    settings::Mission mission = Visitor::described(1);
    mission.wanted = one.wanted;
    v.put_on(mission);
    v.visit->activate("attract.begin", v.now);
    v.frames(0.5);
    v.visit->activate("choose.mission.0", v.now);
    v.frames(0.5);
    v.visit->activate("choose.throw", v.now);
    v.frames(1);
    hollow(v, one.radius);
    v.frames(3);
    EXPECT_THAT(v.visit->reading().differences, Contains(one.advice));
    EXPECT_THAT(words_in(v.frame), HasSubstr(one.advice)) << "and it stands on the screen";
  }
}

TEST(Mission, IsCountedByItsIdAndTheNextVisitorBeginsWithNone) {
  Visitor v;
  v.put_on(Visitor::described(1));
  begin(v);
  v.requests();
  v.touch("back");
  v.touch("back");
  v.show();
  ASSERT_EQ(v.visit->screen(), ScreenId::attract);
  std::optional<VisitNotes> notes;
  for (const Request& one : v.requests())
    if (const auto* over = std::get_if<VisitEnded>(&one)) notes = over->notes;
  ASSERT_TRUE(notes);
  EXPECT_EQ(notes->mission, "litre_jar");
  v.throw_a_pot();
  v.frames(1);
  EXPECT_THAT(words_in(v.frame), Not(HasSubstr("l of 1 l.")));
  v.visit->close(v.now);
  v.show();
  for (const Request& one : v.requests())
    if (const auto* over = std::get_if<VisitEnded>(&one)) notes = over->notes;
  EXPECT_EQ(notes->mission, "");
}

TEST(Mission, LosesNoWordOnAnyScreenInAnySizeLanguageOrComfort) {
  const render::Typesetter fonts;
  for (const auto& [width, height] : {std::pair{1280, 720}, {1024, 600}, {1080, 1920}})
    for (const bool all : {false, true})
      for (const char* language : {"en", "de", "ar", "ja"}) {
        SCOPED_TRACE(std::to_string(width) + " " + language + (all ? " all comforts" : ""));
        Visitor v(9, &fonts, true);
        v.languages.insert(
            v.languages.begin(),
            *content::Language::read(std::string("content/languages/") + language + ".toml"));
        v.width = width;
        v.height = height;
        v.exhibit.screen.larger_text = v.exhibit.screen.high_contrast = all;
        v.put_on(Visitor::described(1));
        v.put_on(todays(), 2);
        const auto look = [&](const std::string& name) {
          v.frames(1);
          check_layout(v, fonts, name);
        };
        to_the_shelf(v);
        look("choose");
        v.touch("choose.mission.0");
        look("label");
        v.touch("choose.throw");
        look("throw");
        v.touch("throw.wheel");
        look("drawer");
        v.touch("throw.less");
        hollow(v, 0.03);
        v.touch("throw.done");
        look("result");
        v.touch("result.keep");
        look("kiln");
      }
}

TEST(MissionHelp, AtTheResultSpeaksOfAVesselBesideThePotOnlyWhereOneStands) {
  for (const bool described : {false, true}) {
    Visitor v;
    v.put_on(described ? Visitor::described(1) : todays(), 2);
    begin(v);
    hollow(v, 0.05);
    v.touch("throw.done");
    v.frames(1);
    ASSERT_EQ(v.visit->screen(), ScreenId::result);
    v.touch("help");
    v.frames(1);
    const std::string words = words_in(v.frame);
    EXPECT_EQ(words.find("beside the one you chose") != std::string::npos, !described) << words;
    EXPECT_EQ(words.find("size beside the task") != std::string::npos, described) << words;
  }
}

}  // namespace
}  // namespace onggi::screens::measured_pot_test
