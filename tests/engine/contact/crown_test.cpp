#include "engine/contact/crown.h"

#include <gtest/gtest.h>

namespace onggi::contact::crown_test {
namespace {

// A row's bounds are loose after a press or an undo, and are measured again one row a tick. The
// push at the rim was up to 3.6 % off in the meantime.
TEST(Crown, ThePushDoesNotDependOnWhatIsKnownOfTheRowsBounds) {
  ClayDef def;
  def.inner_radius = 0.047;
  const Clay known = std::move(*Clay::create(def));
  Clay loose = known;
  for (int j = 0; j < loose.rows(); ++j) loose.widen_extent(j, 0.060f, 0.040f);
  for (const WallSide side : {WallSide::outside, WallSide::inside})
    for (const double y : {0.195, 0.199, 0.203}) {
      const double x = side == WallSide::outside ? 0.061 : 0.041;
      const EdgePush a = push_at_edge(known, side, {x, y, 0.001}, 0.008, 0.2, true);
      const EdgePush b = push_at_edge(loose, side, {x, y, 0.001}, 0.008, 0.2, true);
      EXPECT_GT(a.face_normal, 0.0);
      EXPECT_EQ(a.face.x, b.face.x) << y;
      EXPECT_EQ(a.face.y, b.face.y) << y;
      EXPECT_EQ(a.top.y, b.top.y) << y;
    }
}

}  // namespace
}  // namespace onggi::contact::crown_test
