#include "kiosk/collection/content/lesson.h"

#include <gmock/gmock.h>

#include "tests/kiosk/collection/content/temporary.h"

namespace onggi::content::lesson_test {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class LessonTest : public Temporary {
 protected:
  LessonRead read(const std::string& text) {
    return read_lesson(write("lesson.toml", text), {"en", "ko"});
  }
  static std::string step(const std::string& id, const std::string& more = "") {
    return "[[step]]\nid = \"" + id + "\"\nwords = { en = \"Open it.\", ko = \"벌리기\" }\n" +
           (more.empty() ? "hands = \"up\"\nuntil = \"raised\"\n" : more);
  }
};

TEST(Lesson, TheExhibitsOwnIsWithoutFaultAndGoesFromTouchToRim) {
  const LessonRead r = read_lesson("content/lessons/first_minute.toml", {"en", "ko"});
  EXPECT_THAT(r.problems, IsEmpty()) << to_text(r.problems.front());
  ASSERT_THAT(r.steps, SizeIs(5));
  const char* ids[] = {"touch", "open", "pull", "shape", "rim"};
  double seconds = 0;
  for (std::size_t n = 0; n < r.steps.size(); ++n) {
    EXPECT_EQ(r.steps[n].id, ids[n]);
    EXPECT_NE(r.steps[n].words_in("ko"), r.steps[n].words_in("en"));
    seconds += r.steps[n].after;
  }
  EXPECT_LE(seconds, 95) << "most visitors stay about two minutes";
}

TEST(Lesson, TheExhibitsOwnForBuildingGoesFromTheFirstRingToTheLastBlow) {
  const LessonRead r = read_lesson("content/lessons/building.toml", {"en", "ko"});
  EXPECT_THAT(r.problems, IsEmpty()) << to_text(r.problems.front());
  std::vector<DoneWhen> until;
  for (const LessonStep& step : r.steps) until.push_back(step.until);
  EXPECT_THAT(until, ::testing::ElementsAre(DoneWhen::laid, DoneWhen::built, DoneWhen::dried,
                                            DoneWhen::ringing, DoneWhen::beaten));
  for (const LessonStep& step : r.steps) EXPECT_NE(step.words_in("ko"), step.words_in("en"));
}

TEST_F(LessonTest, AGoodStepIsReadWhole) {
  const LessonRead r = read(step("open", "hands = \"inside\"\nuntil = \"opened\"\nafter = 7.5\n"));
  EXPECT_THAT(r.problems, IsEmpty());
  ASSERT_THAT(r.steps, SizeIs(1));
  EXPECT_EQ(r.steps[0].hands, HandsDrawn::inside);
  EXPECT_EQ(r.steps[0].until, DoneWhen::opened);
  EXPECT_EQ(r.steps[0].after, 7.5);
  EXPECT_EQ(r.steps[0].words_in("ko"), "벌리기");
  EXPECT_EQ(r.steps[0].words_in("fr"), "Open it.");
}

TEST_F(LessonTest, AMistakeIsNamedWithItsLineAndTheNearestRightWord) {
  const LessonRead r =
      read(step("open", "hands = \"insde\"\nuntil = \"raised\"\nafter = 500\nafterr = 3\n"));
  ASSERT_THAT(r.problems, SizeIs(3));
  EXPECT_THAT(r.problems[0].where, HasSubstr("lesson.toml:4:"));
  EXPECT_THAT(r.problems[0].remedy, HasSubstr("\"inside\""));
  EXPECT_THAT(r.problems[1].where, HasSubstr("lesson.toml:6:"));
  EXPECT_THAT(r.problems[2].where, HasSubstr("lesson.toml:7:"));
  EXPECT_THAT(r.steps, SizeIs(1)) << "the step is shown all the same";
}

TEST_F(LessonTest, WordsThatLackOrAreTooManyForAGlanceAreNamed) {
  EXPECT_THAT(
      read("[[step]]\nid = \"a\"\nwords = { en = \"A\" }\nhands = \"up\"\nuntil = \"cut\"\n")
          .problems[0]
          .what,
      HasSubstr("\"ko\""));
  std::string lots = "b";
  for (int i = 0; i < 60; ++i) lots += " a";
  const LessonRead r = read("[[step]]\nid = \"a\"\nwords = { en = \"" + lots +
                            "\", ko = \"가\" }\nhands = \"up\"\nuntil = \"cut\"\n");
  ASSERT_THAT(r.problems, SizeIs(1));
  EXPECT_THAT(r.problems[0].what, HasSubstr("121 letters"));
}

TEST_F(LessonTest, TwoStepsOfOneNameAndStepsWithoutANameAreLeftOut) {
  const LessonRead r = read(step("open") + step("open") + step("Up!"));
  EXPECT_THAT(r.steps, SizeIs(1));
  EXPECT_THAT(r.problems, SizeIs(2));
}

TEST_F(LessonTest, AFileWithoutStepsIsNoLessonAndNoMistake) {
  const LessonRead r = read("# none for us\n");
  EXPECT_THAT(r.problems, IsEmpty());
  EXPECT_THAT(r.steps, IsEmpty());
}

}  // namespace
}  // namespace onggi::content::lesson_test
