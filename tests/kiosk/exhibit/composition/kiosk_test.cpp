#include "kiosk/exhibit/composition/kiosk.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <span>

#include "kiosk/ground/files/memory.h"
#include "kiosk/keepsake/store/statistics.h"
#include "tests/kiosk/exhibit/composition/whole_kiosk.h"
#include "tests/kiosk/picture/encoding/shown_gif.h"
#include "tests/support/holes.h"
#include "tests/support/sanitized.h"

// What only the whole kiosk can be asked: that it hands on what one room knows to another.

namespace onggi::exhibit::kiosk_test {
namespace {

using screens::ScreenId;

/// How far to the right what moves in the pictures goes, in pixels, weighed by how much it stands
/// out: a mark in front stands out more than the same mark behind, on its way back.
double goes_right(const encoding::Pictures& turn) {
  constexpr std::size_t kSide = TurntableRecorder::kSide;
  std::vector<double> mean(kSide * kSide);
  for (const auto& picture : turn)
    for (std::size_t i = 0; i < mean.size(); ++i)
      mean[i] += picture.at(3 * i) / static_cast<double>(turn.size());
  double way = 0, before = 0, stood_out = 0;
  for (const auto& picture : turn) {
    double all = 0, at = 0;
    for (std::size_t i = 0; i < mean.size(); ++i) {
      const double more = std::abs(picture[3 * i] - mean[i]);
      if (more < 8) continue;  // dither, and shades that are nearly alike
      all += more;
      at += more * static_cast<double>(i % kSide);
    }
    if (all > 0) at /= all;
    way += std::min(all, stood_out) * (at - before);
    before = at;
    stood_out = all;
  }
  return way;
}

// Which way is whose, TurntableRecorder's own tests say.
TEST_F(WholeKiosk, APictureThatTurnsGoesTheWayOfTheHandThatItsVisitorChose) {
  std::array<encoding::Pictures, 2> turns;
  for (const bool left_handed : {false, true}) {
    keep_a_pot(left_handed);
    until([&] { return !kiosk_->doing().turning && kiosk_->doing().kept->turning; });
    const auto& outcome = *kiosk_->doing().kept->turning;
    ASSERT_TRUE(outcome) << to_text(outcome.error());
    const std::string bytes = commands::content(*outcome);
    turns[left_handed ? 1 : 0] = encoding::shown_gif(std::as_bytes(std::span(bytes)));
    press("keepsake.done");
    until([&] { return kiosk_->doing().nobody_is_here; });
  }
  const auto& [right, left] = turns;
  ASSERT_EQ(right.size(), 40u);
  ASSERT_EQ(left.size(), 40u);
  EXPECT_LT(goes_right(right) * goes_right(left), 0) << goes_right(right);
}

/// One whose visits are counted, too.
class CountedKiosk : public StillKiosk {
 protected:
  CountedKiosk() { counted_ = true; }
  /// What is counted once the kiosk is closed.
  store::Cell counted() {
    kiosk_.reset();
    const auto found = store::read_statistics((folder_ / "kept/onggi.sqlite").string(), "", "");
    EXPECT_TRUE(found) << to_text(found.error());
    return found ? found->all : store::Cell{};
  }
};

// VisitEnded is carried out after the save, and the counter hears of the visit before the ticket
// of its save is forgotten: in the other order each visit is counted as one that kept nothing.
TEST_F(CountedKiosk, AVisitThatKeptAPotIsCountedWithItsKeepsake) {
  keep_a_pot(false);
  press("keepsake.done");
  until([&] { return kiosk_->doing().nobody_is_here; });
  const store::Cell all = counted();
  EXPECT_EQ(all.visits, 1);
  EXPECT_EQ(all.kept, 1);
}

// Closing waits for the save, tells the counter of it, and closes the counter, in this order.
TEST_F(CountedKiosk, AVisitThatIsClosedWhileItsKeepsakeIsOnItsWayIsCountedWithIt) {
  ask_to_keep_a_pot(false);
  ASSERT_TRUE(kiosk_->doing().saving);
  const store::Cell all = counted();
  EXPECT_EQ(all.visits, 1);
  EXPECT_EQ(all.kept, 1);
}

TEST_F(CountedKiosk, AVisitorWhoStartsAnewIsNotToldOfTheSaveOfTheOneBefore) {
  ask_to_keep_a_pot(false);
  ASSERT_TRUE(kiosk_->doing().saving);
  kiosk_->visit().close(now_);  // they leave at once
  until([&] { return !kiosk_->doing().saving; });
  EXPECT_EQ(kiosk_->visit().screen(), ScreenId::attract);
  EXPECT_FALSE(kiosk_->doing().kept->saved) << "what was saved is told to whom it belongs";
  EXPECT_EQ(kiosk_->doing().saved.kept, 1u);
}

TEST_F(StillKiosk, HolesInTheHeapGoBackWhenItsVisitorHasGoneAndNotBefore) {
  if (ONGGI_SANITIZED) GTEST_SKIP() << "a sanitizer owns malloc";
  files::keep_heap_small();
  keep_a_pot(false);
  const onggi::test::Holes holes;
  const double before = onggi::test::resident_mib();
  for (int n = 0; n < 50; ++n) frame();
  EXPECT_GT(onggi::test::resident_mib(), before - 0.1 * onggi::test::Holes::kMib)
      << "somebody looks at the keepsake";
  press("keepsake.done");
  until([&] { return kiosk_->doing().nobody_is_here; });
  frame();
  EXPECT_LT(onggi::test::resident_mib(), before - 0.7 * onggi::test::Holes::kMib);
}

TEST(Kiosk, AnExhibitIsOpenedInPagesAnewAndNotInThoseOfTheOneBefore) {
  if (ONGGI_SANITIZED) GTEST_SKIP() << "a sanitizer owns malloc";
  files::keep_heap_small();
  const onggi::test::Holes holes;
  const double before = onggi::test::resident_mib();
  KioskOptions options;
  options.config = "/nowhere/exhibit.toml";
  EXPECT_FALSE(Kiosk::open(options));
  EXPECT_LT(onggi::test::resident_mib(), before - 0.9 * onggi::test::Holes::kMib);
}

}  // namespace
}  // namespace onggi::exhibit::kiosk_test
