#include "engine/effects/move_face.h"

#include <gtest/gtest.h>

#include <utility>

namespace onggi::effects::move_face_test {
namespace {

TEST(MoveFace, AFloorRowHasNoInsideAndAFirmWallGivesNoWay) {
  Clay clay = std::move(*Clay::create({}));
  clay.keep_areas();
  clay.areas()->keep_firm();
  const int floor = clay.floor_rows() - 1, wall = clay.floor_rows() + 5;
  ASSERT_GE(floor, 0);
  row_kernels::FaceMove how{};
  EXPECT_TRUE(may_move(clay, WallSide::outside, floor, 0.0, how));
  EXPECT_FALSE(how.hollow);
  EXPECT_FALSE(may_move(clay, WallSide::inside, floor, 0.0, how));
  for (const WallSide side : {WallSide::outside, WallSide::inside}) {
    EXPECT_TRUE(may_move(clay, side, wall, 0.0, how));
    EXPECT_TRUE(how.hollow);
  }
  clay.areas()->harden(wall, true, true);
  clay.areas()->harden_all(false, false);
  EXPECT_FALSE(may_move(clay, WallSide::outside, wall, 0.0, how));
  EXPECT_FALSE(may_move(clay, WallSide::inside, wall, 0.0, how));
  EXPECT_TRUE(may_move(clay, WallSide::outside, wall + 1, 0.0, how)) << "its neighbour is soft";
}

TEST(MoveFace, AFirmWallsOtherFaceGoesWithItAsFarAsItselfAndASoftOnesByWhatHandsLetIt) {
  Clay clay = std::move(*Clay::create({}));
  clay.keep_areas();
  clay.areas()->keep_firm();
  const int wall = clay.floor_rows() + 5;
  clay.areas()->harden(wall, true, false);
  clay.areas()->harden_all(false, false);
  row_kernels::FaceMove firm{}, soft{};
  ASSERT_TRUE(may_move(clay, WallSide::outside, wall, 0.3, firm));
  ASSERT_TRUE(may_move(clay, WallSide::outside, wall + 1, 0.3, soft));
  EXPECT_EQ(firm.along, 1.0f);
  EXPECT_EQ(soft.along, 0.3f);
}

}  // namespace
}  // namespace onggi::effects::move_face_test
