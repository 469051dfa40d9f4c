#include "kiosk/visit/screens/visit_notes.h"

#include <gtest/gtest.h>

#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::visit_notes_test {
namespace {

using By = NoteTaker::By;

TEST(VisitNotes, TimeIsFromTheFirstTouchToTheLastAndNeverTheIdleTail) {
  NoteTaker notes;
  notes.touch(By::mouse, 5);
  notes.enter(ScreenId::choose, 10);
  notes.touch(By::mouse, 14);
  notes.enter(ScreenId::throwing, 15);
  notes.pot();
  notes.touch(By::mouse, 16);
  notes.touch(By::mouse, 40);
  const VisitNotes found = notes.finish(125, VisitNotes::End::idle).value();
  EXPECT_EQ(found.since_s, 115.0);
  EXPECT_EQ(found.active_s, 30.0);
  EXPECT_EQ(found.throwing_s, 26.0);
  EXPECT_EQ(found.reached, ScreenId::throwing);
  EXPECT_EQ(found.left, ScreenId::throwing);
  EXPECT_EQ(found.end, VisitNotes::End::idle);
  EXPECT_EQ(found.pots, 1);
  notes.enter(ScreenId::choose, 200);
  const VisitNotes next = notes.finish(201, VisitNotes::End::back).value();
  EXPECT_EQ(next.active_s, 0.0);
  EXPECT_EQ(next.pots, 0) << "the next visitor's own";
  EXPECT_EQ(next.end, VisitNotes::End::back);
}

TEST(VisitNotes, HowTheyPlayedIsWhatTheyTouchedMostAndADeviceBeforeAll) {
  const auto way = [](int glass, int mouse, int keys, std::string_view device) {
    NoteTaker notes;
    notes.enter(ScreenId::throwing, 0);
    for (int n = 0; n < glass; ++n) notes.touch(By::glass, n);
    for (int n = 0; n < mouse; ++n) notes.touch(By::mouse, n);
    for (int n = 0; n < keys; ++n) notes.touch(By::keys, n);
    if (!device.empty()) notes.device(device, 1);
    return notes.finish(2, VisitNotes::End::back)->way;
  };
  EXPECT_EQ(way(3, 1, 1, ""), "touch");
  EXPECT_EQ(way(1, 3, 1, ""), "mouse");
  EXPECT_EQ(way(2, 2, 5, ""), "keys");
  EXPECT_EQ(way(9, 0, 0, "space_mouse"), "space_mouse");
}

TEST(VisitNotes, AVisitToItsEndAndOneThatIsLeftSayWhereAndHow) {
  Visitor v;
  v.make_result();
  v.requests();
  v.touch("result.keep");
  v.show();
  v.visit->keepsake_kept("kept");
  v.frames(1);
  v.touch("keepsake.done");
  v.touch("keepsake.done");  // thanks
  v.show();
  const auto over = [](Visitor& visitor) {
    std::vector<VisitNotes> all;
    for (const Request& request : visitor.requests())
      if (const auto* forget = std::get_if<VisitEnded>(&request))
        all.push_back(forget->notes.value());
    return all;
  };
  const auto finished = over(v);
  ASSERT_EQ(finished.size(), 1u);
  EXPECT_EQ(finished[0].end, VisitNotes::End::finished);
  EXPECT_EQ(finished[0].reached, ScreenId::keepsake);
  EXPECT_GE(finished[0].card, 0);
  EXPECT_EQ(finished[0].pots, 1);
  EXPECT_EQ(finished[0].language, "en");
  EXPECT_TRUE(finished[0].likeness);
  EXPECT_GT(finished[0].active_s, 0.0);
  EXPECT_LE(finished[0].throwing_s, finished[0].active_s);

  Visitor leaves;
  leaves.throw_a_pot();
  leaves.frames(200);
  const auto left = over(leaves);
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left[0].end, VisitNotes::End::idle);
  EXPECT_EQ(left[0].left, ScreenId::throwing);
  EXPECT_FALSE(left[0].likeness);
  EXPECT_LT(left[0].active_s, 20.0) << "nobody was there for the rest";
}

TEST(VisitNotes, AFaultThatNobodyWasThereForIsNoVisitAndOneInTheMiddleOfAVisitEndsIt) {
  NoteTaker notes;
  notes.enter(ScreenId::fault, 10);
  notes.touch(By::glass, 400);
  EXPECT_FALSE(notes.finish(400, VisitNotes::End::back)) << "whoever touches it away found nothing";
  notes.enter(ScreenId::choose, 500);
  notes.enter(ScreenId::fault, 507);
  notes.touch(By::glass, 509);
  const auto found = notes.finish(509, VisitNotes::End::back);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->end, VisitNotes::End::fault);
  EXPECT_EQ(found->reached, ScreenId::choose);
  EXPECT_EQ(found->active_s, 9.0);
  EXPECT_EQ(found->since_s, 9.0);

  Visitor v;
  v.visit->fail({"the shelf", "No vessel.", "Mend it.", 1});
  v.show();
  v.touch("fault.on");
  v.show();
  int forgotten = 0;
  for (const Request& request : v.requests())
    if (const auto* forget = std::get_if<VisitEnded>(&request)) {
      ++forgotten;
      EXPECT_FALSE(forget->notes);
    }
  EXPECT_EQ(forgotten, 1);
}

TEST(VisitNotes, AVisitThatIsUnderWayWhenTheProgramEndsIsOverAndAttractIsNone) {
  const auto over = [](Visitor& visitor) {
    visitor.visit->close(visitor.now);
    visitor.show();
    std::vector<std::optional<VisitNotes>> all;
    for (const Request& request : visitor.requests())
      if (const auto* forget = std::get_if<VisitEnded>(&request)) all.push_back(forget->notes);
    return all;
  };
  Visitor v;
  v.show();
  EXPECT_TRUE(over(v).empty());
  v.throw_a_pot();
  v.frames(1.0);
  const auto visits = over(v);
  ASSERT_EQ(visits.size(), 1u);
  ASSERT_TRUE(visits[0]);
  EXPECT_EQ(v.visit->screen(), ScreenId::attract);
  EXPECT_EQ(visits[0]->end, VisitNotes::End::closed);
  EXPECT_EQ(visits[0]->left, ScreenId::throwing);
  EXPECT_GT(visits[0]->since_s, 1.0);
}

}  // namespace
}  // namespace onggi::screens::visit_notes_test
