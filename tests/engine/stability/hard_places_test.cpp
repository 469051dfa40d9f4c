#include "tests/engine/stability/cases.h"

// Where a tool may be that formulas do not like. The printed model stands beside ours where it
// fails.
namespace onggi::stability::hard_places_test {
namespace {

Trial trial(const SceneDef& def, std::vector<Stroke> strokes) {
  return {def, 1, std::move(strokes)};
}

// A hand that goes in at 3 cm, past the axis on either side, and out again.
std::vector<Stroke> across_the_axis(double height) {
  std::vector<Stroke> strokes;
  for (const double aside : {0.0, 1e-9, 0.0005, 0.004})
    for (const double wheel : {12.0, -12.0, 0.0}) {
      strokes.push_back(stroke({0.03, height, aside}, {-0.03, height, aside}, 240, wheel));
      strokes.push_back(stroke({-0.03, height, aside}, {0.03, height, -aside}, 240, wheel));
    }
  return strokes;
}

TEST(HardPlaces, AToolThatStraddlesTheAxis) {
  SceneDef def = small();
  for (const double height : {0.1, 0.012, 0.2}) {
    expect_stable(trial(def, across_the_axis(height)));
    expect_stable(trial(everything(def), across_the_axis(height)));
  }
  const auto breach = printed_breach(trial(def, {held({0, 0.1, 0}, 20)}));
  ASSERT_TRUE(breach);  // acos(0 / 0)
  EXPECT_EQ(breach->invariant, Invariant::force);
}

TEST(HardPlaces, AToolOnTheAxisToTheLastBit) {
  for (const double x : {0.0, -0.0, kDenormal, -kDenormal, 1e-300, 1e-160, 1e-30, 5e-17})
    for (const double z : {0.0, kDenormal, -1e-160}) {
      expect_stable(trial(small(), {held({x, 0.1, z}, 30), held({x, 0.008, z}, 30),
                                    stroke({x, 0.22, z}, {x, -0.02, z}, 100)}));
    }
}

TEST(HardPlaces, ASectionThatShrinksToNothing) {
  // Rows at the ball's very top and bottom: r_s goes through every value down to none.
  SceneDef def = small(400, 48);
  std::vector<Stroke> strokes;
  for (const double off : {0.0, 1e-17, 1e-12, 1e-9, 1e-6}) {
    const double row = 100.5 * def.clay.height / def.clay.rows;
    for (const double pole : {def.tool.radius, -def.tool.radius}) {
      strokes.push_back(held({0.056, row + pole + off, 0.0}, 20));
      strokes.push_back(held({0.056, row + pole - off, 0.0}, 20));
    }
  }
  expect_stable(trial(def, strokes));
  def.tool.radius = 0.001;  // and a ball no larger than the rows are far apart
  def.clay.rows = 100;
  expect_stable(trial(def, {stroke({0.0555, 0.05, 0.0}, {0.0545, 0.055, 0.001}, 2000)}));
}

TEST(HardPlaces, AToolLargerThanThePot) {
  SceneDef def = small(40, 32);
  def.clay.height = 0.02;
  def.clay.outer_radius = 0.008;
  def.clay.inner_radius = 0.002;
  def.clay.radius_min = 0.0005;
  def.clay.wall_min = 0.001;
  def.clay.floor_thickness = 0.003;
  def.tool.radius = 0.05;
  for (SceneTool& tool : def.tools) tool.size = find_tool_shape(tool.name)->most;
  for (const SceneDef& pot : {def, everything(def)}) {
    std::vector<Stroke> strokes = across_the_axis(0.01);
    for (std::uint8_t tool = 0; tool <= pot.tools.size(); ++tool)
      for (const Vec3 from : {Vec3{0.06, 0.01, 0.0}, {0.0, 0.075, 0.0}, {0.002, -0.03, 0.001}}) {
        strokes.push_back(stroke(from, {0.0, 0.01, 0.0}, 60));
        strokes.back().hand[0].begins.tool = tool;
      }
    expect_stable(trial(pot, strokes));
  }
  // Eq. 2 looks at 2 H_r / d radians of the pot, and the ball holds all of it: some is left.
  Scene ours = std::move(*Scene::create(def));
  Scene theirs = std::move(*Scene::create(printed(def)));
  Hands hands;
  hands.hand[0] = {{0.0502, 0.01, 0.0}, true};
  for (int n = 0; n < 500; ++n) {
    hands.hand[0].position.x = 0.0582 - 1.6e-5 * n;
    ours.step(hands, 0.001);
    theirs.step(hands, 0.001);
  }
  const int row = 20;
  const auto touched = [&](const Scene& scene) {
    int count = 0;
    for (const float radius : scene.clay().outer(row)) count += radius < 0.00799f;
    return count;
  };
  EXPECT_GT(touched(ours), touched(theirs));
}

TEST(HardPlaces, AWallAtItsThinnest) {
  SceneDef def = small();
  def.clay.inner_radius = 0.040;
  def.clay.wall_min = 0.0005;
  std::vector<Stroke> strokes;
  for (const double angle : {0.0, 1.0, 2.0, 4.0}) {
    const Vec3 middle = round_axis(0.0475, angle, 0.06);
    const Vec3 apart = round_axis(0.007, angle, 0.0);
    strokes.push_back(squeezed(middle, middle + Vec3{0, 0.1, 0}, apart, 1500));
  }
  for (const double speed : {kFastest, -kFastest})
    strokes.push_back(stroke({0.07, 0.1, 0.0}, {0.01, 0.1, 0.0}, 1500, speed));
  expect_stable(trial(def, strokes));
  expect_stable(trial(everything(def), strokes));

  // The printed model has one face: the other follows at once, and nothing is ever thin.
  Scene theirs = std::move(*Scene::create(printed(def)));
  const double wall = def.clay.outer_radius - def.clay.inner_radius;
  Hands hands;
  hands.wheel_speed = 12.0;
  for (int n = 0; n < 1000; ++n) {
    hands.hand[0] = {{0.0475 + 0.007 + 0.006 * (1.0 - n / 1000.0), 0.1, 0.0}, true};
    hands.hand[1] = {{0.0475 - 0.007, 0.1, 0.0}, true, SideWish::inside};
    theirs.step(hands, 0.001);
  }
  const Profile profile = theirs.clay().profile();
  EXPECT_LT(profile.outer_at(0.1), 0.055);
  EXPECT_NEAR(profile.inner_at(0.1), 0.055 - wall, 1e-4);  // the hand inside pressed nothing
}

TEST(HardPlaces, HandsThatAreElsewhereEveryTick) {
  for (const SceneDef& def : {small(), everything(small())}) {
    Random random(5);
    std::vector<Stroke> strokes;
    for (int n = 0; n < 1500; ++n) {
      const auto anywhere = [&] {
        return round_axis(random.uniform(0.0, 0.08), random.uniform(0.0, 6.28),
                          random.uniform(-0.02, 0.24));
      };
      strokes.push_back(held(anywhere(), 1 + static_cast<int>(random.bits() % 3)));
      strokes.back().hand[1].begins = {anywhere(), true};
      strokes.back().hand[1].ends = anywhere();
      for (Stroke::Part& part : strokes.back().hand)
        part.begins.tool = static_cast<std::uint8_t>(random.bits() % (def.tools.size() + 1));
    }
    expect_stable(trial(def, strokes));
  }
}

TEST(HardPlaces, AHandBelowTheWheelHeadAndOneAsFarAsAHandMayBe) {
  SceneDef def = small();
  def.clay.floor_thickness = def.clay.height;
  for (const double floor : {0.2, 0.01, 0.0}) {
    def.clay.floor_thickness = floor;
    std::vector<Stroke> strokes;
    for (const double height : {-0.001, -0.02, -1.0, -10.0, 10.0})
      for (const double out : {0.0, 0.03, 0.054, 10.0})
        strokes.push_back(held({out, height, 0.0}, 10));
    expect_stable(trial(def, strokes));
    expect_stable(trial(everything(def), strokes));
  }
}

TEST(HardPlaces, RowsThatAreThickerThanTheToolIsLarge) {
  SceneDef def = small(8, 16);
  def.clay.height = 1.0;
  def.tool.radius = 0.001;
  std::vector<Stroke> strokes;
  for (std::uint8_t tool = 0; tool <= def.tools.size(); ++tool) {
    strokes.push_back(stroke({0.06, 0.3, 0.0}, {0.05, 0.7, 0.0}, 400));
    strokes.back().hand[0].begins.tool = tool;
  }
  expect_stable(trial(def, strokes));
  expect_stable(trial(everything(def), strokes));
}

}  // namespace
}  // namespace onggi::stability::hard_places_test
