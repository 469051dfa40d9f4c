#include "tests/engine/stability/cases.h"

#include <algorithm>

// What random scenes found, each as small as it got. engine/docs/stability.md says how each was
// mended.
namespace onggi::stability::found_test {
namespace {

SceneDef pot(double outer, double inner, double wall, int rows, int sectors) {
  SceneDef def = small(rows, sectors);
  def.clay.outer_radius = outer;
  def.clay.inner_radius = inner;
  def.clay.wall_min = wall;
  def.clay.radius_min = std::min(def.clay.radius_min, inner);
  return def;
}
// By its name, since tools change places when there are more of them; "" is the scene's ball.
std::uint8_t tool_named(const std::string& name) {
  const std::uint8_t tool = tool_of(small(), name);
  EXPECT_EQ(tool == 0, name.empty()) << name;
  return tool;
}
Stroke with(const std::string& tool, Vec3 from, Vec3 to, int ticks, double dt = 0.001) {
  Stroke out = stroke(from, to, ticks, 0.0);
  out.hand[0].begins.tool = tool_named(tool);
  out.dt = dt;
  return out;
}
void expect_held(const SceneDef& def, std::vector<Stroke> strokes) {
  expect_stable({def, 1, std::move(strokes)});
}

TEST(Found, AFloorRowOfANarrowLumpOffTheMiddleKeepsRoomForItsHole) {
  SceneDef def = pot(0.00475, 0.002, 0.00125, 400, 360);
  def.wobble.emplace();
  const Vec3 at{0.000361961, 0.0108658, -8.41039e-05};
  expect_held(def, {with("", at, at, 20)});
}

TEST(Found, ARimThatIsPressedAsideChangesTheAreasOfItsRows) {
  SceneDef def = pot(0.00061, 0.0001, 0.0005, 60, 24);
  def.volume.emplace();
  expect_held(def,
              {with("sponge", {0, 0.0376799, 0}, {0.000314163, 0.0683052, 0.000226704}, 4, 0.005)});
}

TEST(Found, AnEdgeThatPushesAWallAtItsThinnestAsideCutsNothingOff) {
  SceneDef def = pot(0.055, 0.0505, 0.004, 60, 48);
  def.volume.emplace();
  for (const char* tool : {"needle", "loop_trimmer"})
    expect_held(def, {with(tool, {0.045, 0.1, 0.0}, {0.056, 0.1, 0.0}, 600)});
}

TEST(Found, ARowThatIsPressedDownAndHasGotLargerMeanwhileDoesNotShrink) {
  SceneDef def = pot(0.003, 0.002, 0.0005, 400, 360);
  def.wobble.emplace();
  def.volume.emplace();
  expect_held(def, {with("", {0.00165666, 0.595828, -0.00031621},
                         {-0.000223728, 0.11156, 0.000964135}, 24)});
}

TEST(Found, APotThatSagsNeverRisesByItselfThoughAHandCentresItMeanwhile) {
  SceneDef def = pot(0.055, 0.0107522, 0.004, 400, 64);
  def.wobble.emplace();
  def.volume.emplace();
  def.slump.emplace();
  def.slump->density = 4000.0;
  Stroke still = held({-0.0290371, 0.125089, 0}, 300, -15.88);
  still.dt = 0.005;
  expect_held(def, {still});
}

TEST(Found, APressIsNoDeeperThanTheClayIsHigh) {
  SceneDef solid = small();
  solid.clay.floor_thickness = solid.clay.height;
  expect_held(solid, {held({0, -0.011454, 0}, 10), held({0, -9.0, 0}, 10)});
  SceneDef low = pot(0.00475, 0.002, 0.00125, 60, 48);  // under a sponge of 3 cm
  low.clay.height = 0.0205824;
  low.clay.radius_max = 0.007125;
  const Vec3 at{-0.00338112, 0.0234249, -0.000289659};
  expect_held(low, {with("sponge", at, at, 10)});
}

TEST(Found, TwoEdgesInAThinWallCutOffNoMoreThanThereIs) {
  SceneDef def = pot(0.055, 0.022, 0.004, 400, 360);
  def.clay.radius_min = 0.00015527;
  def.contact.relaxation_time = 0.001;
  def.volume.emplace();
  for (SceneTool& tool : def.tools)
    if (tool.name == "loop_trimmer") tool.size.thickness = 0.01;
  Stroke down = with("loop_trimmer", {0.0337033394, 0.01288966, 0.037408453}, {0, 0.01288966, 0}, 3,
                     0.0005775);
  down.hand[0].begins.roll = -1.46;
  Stroke both = with("loop_trimmer", {0, 0.01288966, 0},
                     {-0.00262787396, 0.0517767033, -0.0031313049}, 2, 0.005);
  both.hand[0].begins.roll = -1.46;
  both.hand[1].begins = {
      {-0.0250229219, 0.01288966, 0}, true, SideWish::by_position, tool_named("loop_trimmer")};
  both.hand[1].ends = both.hand[1].begins.position;
  expect_held(def, {down, both, both, both});
}

TEST(Found, AWideWallAtItsThinnestStaysSoThroughHundredsOfSweepsOfSlump) {
  SceneDef def = pot(0.501, 0.5, 0.0005, 9, 38);
  def.clay.radius_min = 0.5;
  def.clay.radius_max = 0.7515;
  def.wobble.emplace();
  def.volume.emplace();
  def.slump.emplace();
  def.slump->viscosity = 1e8;
  const Vec3 below{-0.435627755, -0.00309278201, 0.246408151};
  Stroke away =
      with("curved_rib", {-0.0336832428, -0.00309278201, -0.0305515197}, below, 292, 0.005);
  Stroke across = with("curved_rib", below, {0.267302303, 0.12487427, -0.26908389}, 148, 0.005);
  for (Stroke* one : {&away, &across}) {
    one->wheel_speed = -22.9772693;
    one->hand[0].begins.roll = -3.69;
  }
  expect_held(def, {away, across});
}

// Ticks of 5 ms are worked in parts of a millisecond, and clay that rises and sags does both within
// one.
TEST(Found, APressIsNoDeeperThanTheClayWasWithinALongTick) {
  SceneDef def = small(12, 72);
  def.clay.outer_radius = 0.03;
  def.clay.height = def.clay.floor_thickness = 0.573645;
  def.volume.emplace();
  def.slump.emplace();
  Stroke down = with("curved_rib", {0.00053, 0.3, 0.00052}, {0.00059, 0.0578, 0.00051}, 35, 0.005);
  down.hand[1].begins = {
      {-0.0074, 0.3, -0.0366}, true, SideWish::by_position, tool_named("curved_rib")};
  down.hand[1].ends = {-0.0074, 0.0578, -0.0366};
  Stroke in = down, still = down;
  in.ticks = 44;
  in.dt = 0.001;
  in.hand[0].ends = {0.0, 0.028, 0.0};
  in.hand[1].ends = {0.0, 0.4, 0.00024};
  still.ticks = 2;
  for (std::size_t n = 0; n < down.hand.size(); ++n) {
    in.hand[n].begins.position = down.hand[n].ends;
    still.hand[n].begins.position = still.hand[n].ends = in.hand[n].ends;
  }
  expect_held(def, {down, in, still});
}

// Its rows take turns to get their girth, 2.8 ms for all of them, in a tick of 5 ms as in five.
TEST(Found, AStrawUnderASpongeGetsItsGirthNoSoonerInLongTicksThanInShort) {
  SceneDef def = pot(0.0011, 0.0001, 0.0005, 126, 360);
  def.moisture.emplace();
  def.moisture->wetting_time = 0.05;
  def.slump.emplace();
  def.volume.emplace();
  const Vec3 from{-0.000371275776, 0.171729917, -0.000531560631};
  const Vec3 to{0.00061353201, 0.171729917, 0.0009008167};
  expect_held(def, {with("sponge", from, to, 161, 0.005)});
  expect_held(def, {with("sponge", from, to, 805, 0.001)});
}

}  // namespace
}  // namespace onggi::stability::found_test
