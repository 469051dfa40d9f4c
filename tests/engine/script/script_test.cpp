#include "engine/script/script.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

#include "engine/profile/measures.h"
#include "engine/scene/lump.h"
#include "engine/scene/scene.h"
#include "tests/engine/script/vessels.h"

namespace onggi::script_test {
namespace {

struct Thrown {
  Profile profile;
  std::uint64_t hash = 0;
  double seconds = 0;
  bool jumped = false;
  std::set<std::string, std::less<>> phases;
};

Thrown play(std::string_view name, const ScriptContext& context, Scene* on = nullptr) {
  Scene own = std::move(*Scene::create(context.scene));
  Scene& scene = on != nullptr ? *on : own;
  auto script = make_script(name, context);
  EXPECT_TRUE(script) << to_text(script.error());
  Thrown out;
  out.seconds = (*script)->duration();
  Hands last = (*script)->at(0.0, scene.clay());
  for (long n = 0; static_cast<double>(n) * 0.001 <= out.seconds + 0.01; ++n) {
    const double t = static_cast<double>(n) * 0.001;
    const Hands hands = (*script)->at(t, scene.clay());
    const double step = length(hands.hand[0].position - last.hand[0].position);
    out.jumped = out.jumped || step > (hands.hand[0].active ? 0.00055 : 0.002) * context.pace;
    out.phases.emplace((*script)->phase(t));
    last = hands;
    const Feedback felt = scene.step(hands, 0.001);
    EXPECT_EQ(felt.faults, 0u);
    if (felt.hand[0].contact) {
      EXPECT_EQ(felt.hand[0].side == WallSide::inside, hands.hand[0].side == SideWish::inside) << t;
    }
  }
  EXPECT_FALSE(last.hand[0].active);
  out.profile = scene.clay().profile();
  out.hash = scene.state_hash();
  return out;
}

// --- From one thick-walled cylinder, five recognisably different pots.

TEST(Script, CollarGivesAPotWithANeck) {
  const Dimensions d = dimensions(play("collar", {}).profile);
  EXPECT_LT(d.neck, 0.8 * d.belly);
  EXPECT_LT(d.belly_height, 0.5 * d.height);
  EXPECT_GT(d.mouth, d.neck);
}

TEST(Script, BellyGivesABarrelWidestInTheMiddle) {
  const Dimensions d = dimensions(play("belly", {}).profile);
  EXPECT_GT(d.belly, 1.3 * d.mouth);
  EXPECT_GT(d.belly, 1.3 * d.foot);
  EXPECT_NEAR(d.belly_height / d.height, 0.5, 0.15);
}

TEST(Script, BowlGivesAMouthWiderThanAnythingBelow) {
  const Thrown bowl = play("bowl", {});
  const Dimensions d = dimensions(bowl.profile);
  EXPECT_GT(d.mouth, 0.98 * d.belly);
  EXPECT_GT(d.mouth, 1.8 * d.foot);
  for (double h = 0.02; h < 0.19; h += 0.01)
    EXPECT_LT(bowl.profile.outer_at(h), bowl.profile.outer_at(h + 0.01) + 0.0005);
}

TEST(Script, GrooveCutsOneNotchAndLeavesTheRest) {
  const Profile p = play("groove", {}).profile;
  EXPECT_LT(p.outer_at(0.12), 0.051);
  for (double h : {0.02, 0.08, 0.105, 0.135, 0.18}) EXPECT_NEAR(p.outer_at(h), 0.055, 1e-5) << h;
}

TEST(Script, OpenMakesAPotOfASolidLump) {
  ScriptContext context;
  ClayDef& clay = context.scene.clay;
  clay.height = clay.floor_thickness = 0.08;
  const Thrown thrown = play("open", context);
  EXPECT_FALSE(thrown.jumped);
  EXPECT_NEAR(thrown.profile.floor_height(), 0.006, 0.001);
  for (double h = 0.02; h < 0.07; h += 0.01) {
    EXPECT_NEAR(thrown.profile.inner_at(h), 0.045, 0.0015) << h;
    EXPECT_NEAR(thrown.profile.outer_at(h), 0.055, 0.0005) << h;
  }
}

TEST(Script, PressRimMakesAPotLower) {
  ScriptContext context;
  context.scene.clay.inner_radius = 0.047;
  const Thrown thrown = play("press_rim", context);
  EXPECT_FALSE(thrown.jumped);
  EXPECT_NEAR(thrown.profile.height(), 0.192, 0.0025);
  EXPECT_NEAR(thrown.profile.outer_at(0.1), 0.055, 1e-6);
}

TEST(Script, FlareRimWidensTheMouth) {
  ScriptContext context;
  context.scene.clay.inner_radius = 0.049;
  const Thrown thrown = play("flare_rim", context);
  EXPECT_FALSE(thrown.jumped);
  EXPECT_GT(thrown.profile.points.back().outer, 0.0562);
  EXPECT_NEAR(thrown.profile.outer_at(0.14), 0.055, 1e-6);
}

TEST(Script, SqueezeThinsTheWallBetweenTwoHands) {
  ScriptContext context;
  context.scene.clay.inner_radius = 0.045;
  const Thrown thrown = play("squeeze", context);
  EXPECT_FALSE(thrown.jumped);
  for (double h = 0.03; h < 0.19; h += 0.02) {
    EXPECT_NEAR(thrown.profile.outer_at(h) - thrown.profile.inner_at(h), 0.0072, 0.0007)
        << h;  // the clay lags
    EXPECT_NEAR(thrown.profile.outer_at(h) + thrown.profile.inner_at(h), 0.1, 0.0006) << h;
  }
}

TEST(Script, TrueMakesABattedLumpACylinderAgain) {
  ScriptContext context;
  Scene scene = std::move(*Scene::create(context.scene));
  // Dents all round, on a wheel that stands still.
  Hands hands;
  for (int n = 0; n < 40; ++n) {
    const double angle = n * 2.4;
    const double height = 0.01 + 0.0045 * n;
    hands.hand[0].active = true;
    for (int k = 0; k < 40; ++k) {
      const double d = 0.066 - 0.0001 * k;
      hands.hand[0].position = {d * std::cos(angle), height, d * std::sin(angle)};
      scene.step(hands, 0.001);
    }
    hands.hand[0].active = false;
    scene.step(hands, 0.001);
  }
  const auto unevenness = [&scene] {
    float low = 1.0f;
    float high = 0.0f;
    for (int j = 0; j < scene.clay().rows(); ++j) {
      const auto row = scene.clay().outer(j);
      low = std::min(low, *std::min_element(row.begin(), row.end()));
      high = std::max(high, *std::max_element(row.begin(), row.end()));
    }
    return high - low;
  };
  const float before = unevenness();
  EXPECT_GT(before, 0.0002f);
  play("true", context, &scene);
  const Profile p = scene.clay().profile();
  for (double h = 0.0; h <= 0.2; h += 0.01) EXPECT_NEAR(p.outer_at(h), 0.94 * 0.055, 0.0012) << h;
}

// --- Follow: the chosen vessel's own outline.

class Follow : public testing::TestWithParam<std::pair<std::string, Profile>> {};

ScriptContext follow(const Profile& target, double pace = 1.0) {
  ScriptContext context;
  context.scene.clay = lump_for(target, context.scene);
  context.target = &target;
  context.pace = pace;
  return context;
}

TEST_P(Follow, ShapesTheClayToWithinAHundredthOfTheHeight) {
  const Profile& drawn = GetParam().second;
  const Profile target = scaled(drawn, workspace_scale(drawn));
  const Thrown thrown = play("follow", follow(target));
  const Measures m = compare(target, thrown.profile, true);
  EXPECT_LT(m.outline_rms, 0.010);
  EXPECT_GT(m.outline_overlap, 0.975);
  EXPECT_GE(thrown.seconds, 60.0);
  EXPECT_LE(thrown.seconds, 120.0);
  EXPECT_FALSE(thrown.jumped);
}

INSTANTIATE_TEST_SUITE_P(Vessels, Follow, testing::ValuesIn(vessels::all()),
                         [](const auto& vessel) {
                           std::string name = vessel.param.first;
                           std::replace(name.begin(), name.end(), ' ', '_');
                           return name;
                         });

// The clay of config/scenes/master.toml on a coarser grid: all that clay does.
SceneDef masters() {
  SceneDef def;
  def.clay.sectors = 180;
  def.clay.wall_min = 0.002;
  def.contact = {0.015, 1e7};
  each_effect(def, [](auto& effect) { effect.emplace(); });
  def.building.reset();  // its pot begins as a floor
  def.moisture->wetting_time = 5.0;
  def.moisture->weakening = 0.15;
  def.moisture->sponge_height = 0.06;
  def.slump->yield_stress = 9000.0;
  def.wobble->off_centre = 0.003;
  return def;
}

TEST(Script, WhereClayIsKeptItFollowsFromALumpThatHoldsTheVesselsClayAndThePotStands) {
  for (const auto& [drawn, most] : {std::pair{vessels::moon_jar(), 0.015},
                                    {vessels::bottle(), 0.015},
                                    {vessels::cylinder(), 0.015},
                                    {vessels::tea_bowl(), 0.04},
                                    {vessels::amphora(), 0.03}}) {
    const Profile target = scaled(drawn, workspace_scale(drawn));
    ScriptContext context;
    context.scene = masters();
    context.scene.clay = lump_for(target, context.scene);
    context.target = &target;
    Scene scene = std::move(*Scene::create(context.scene));
    const double lump = scene.clay().volume();
    const Thrown thrown = play("follow", context, &scene);
    EXPECT_NEAR(thrown.profile.height() / target.height(), 1.0, 0.05);
    EXPECT_LT(compare(target, thrown.profile, true).outline_rms, most);
    EXPECT_NEAR(scene.clay().volume() / lump, 1.0, 1e-6);
    EXPECT_FALSE(scene.fallen());
    EXPECT_FALSE(thrown.jumped);
  }
}

// A ring that is only narrowed keeps its clay, and a neck of a thick lump would close: first_touch.
TEST(Script, WhereWallsGoAsAWholeAndNoClayIsKeptAHandInsideHoldsTheMouthOpen) {
  for (const auto& [name, drawn] : vessels::all()) {
    const Profile target = scaled(drawn, workspace_scale(drawn));
    ScriptContext context;
    context.scene.clay.sectors = 96;
    context.scene.walls.emplace();
    context.scene.walls->support = 0.03;
    context.scene.clay = lump_for(target, context.scene);
    context.target = &target;
    Scene scene = std::move(*Scene::create(context.scene));
    const Thrown thrown = play("follow", context, &scene);
    EXPECT_LT(compare(target, thrown.profile, true).outline_rms, 0.03) << name;
    const Clay& clay = scene.clay();
    const int rim = clay.rows() - 1;
    EXPECT_GT(clay.inner(rim)[0], 0.6f * clay.outer(rim)[0]) << name;
    EXPECT_FALSE(thrown.jumped) << name;
  }
}

TEST(Script, WhoFollowsAVesselWetsItNoMoreThanItCarries) {
  // Soaked, clay of 9 kPa has 3 % of its strength and stands 2 cm high.
  const Profile target = scaled(vessels::moon_jar(), workspace_scale(vessels::moon_jar()));
  ScriptContext context;
  context.scene.clay.rows = 100;
  context.scene.clay.sectors = 96;
  context.scene.walls.emplace();
  context.scene.volume.emplace();
  context.scene.slump.emplace();
  context.scene.slump->yield_stress = 9000.0;
  context.scene.clay = lump_for(target, context.scene);
  context.target = &target;
  Scene scene = std::move(*Scene::create(context.scene));
  const Thrown thrown = play("follow", context, &scene);
  EXPECT_FALSE(scene.fallen());
  EXPECT_NEAR(thrown.profile.height() / target.height(), 1.0, 0.05);
}

TEST(Script, AtTwiceThePaceAJarIsStillThatJar) {
  const Profile drawn = vessels::maebyeong();
  const Profile target = scaled(drawn, workspace_scale(drawn));
  const Thrown thrown = play("follow", follow(target, 2.0));
  EXPECT_LT(compare(target, thrown.profile, true).outline_rms, 0.02);
  EXPECT_LT(thrown.seconds, 75.0);
  EXPECT_FALSE(thrown.jumped);
}

TEST(Script, TheSameSeedMovesTheSameHandsAndAnotherOnlyALittleUnlike) {
  ScriptContext a;
  ScriptContext b;
  b.seed = 2;
  const Thrown first = play("groove", a);
  EXPECT_EQ(first.hash, play("groove", a).hash);
  const Thrown other = play("groove", b);
  EXPECT_NE(first.hash, other.hash);
  EXPECT_NEAR(first.profile.outer_at(0.12), other.profile.outer_at(0.12), 0.0005);
}

TEST(Script, PhasesTellWhatTheHandsDo) {
  const auto phases = play("collar", {}).phases;
  EXPECT_TRUE(phases.contains("collar"));
  EXPECT_TRUE(phases.contains("water"));
  EXPECT_TRUE(phases.contains("lift"));
}

TEST(Script, AnUnknownNameAMissingTargetOrAWrongPaceIsRefusedWithARemedy) {
  const auto name = make_script("coller", {});
  ASSERT_FALSE(name);
  EXPECT_NE(name.error().remedy.find("\"collar\""), std::string::npos);
  const auto target = make_script("follow", {});
  ASSERT_FALSE(target);
  ScriptContext fast;
  fast.pace = 5.0;
  EXPECT_FALSE(make_script("true", fast));
  ScriptContext bad;
  bad.scene.clay.rows = 1;
  EXPECT_FALSE(make_script("true", bad));
  ScriptContext solid;
  solid.scene.clay.floor_thickness = solid.scene.clay.height;
  EXPECT_FALSE(make_script("squeeze", solid));
  EXPECT_TRUE(make_script("open", solid));
}

// A row of the table in engine/docs/scripts.md.
std::string row_of(const ScriptInfo& script) {
  std::string needs;
  const auto add = [&needs](bool there, std::string_view word) {
    if (there) needs += (needs.empty() ? "" : ", ") + std::string(word);
  };
  add(script.needs.target, "a vessel");
  add(script.needs.wall, "a wall");
  add(!script.needs.tool.empty(), "`" + std::string(script.needs.tool) + "`");
  const std::string shows = script.shows.empty() ? "" : "`" + std::string(script.shows) + "`";
  return "| `" + std::string(script.name) + "` | " + std::string(script.words) + " | " + needs +
         " | " + shows + " |";
}

TEST(Script, TheTableInTheDocumentsIsTheTableOfScripts) {
  std::ifstream file("engine/docs/scripts.md");
  std::vector<std::string> rows;
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("| `")) rows.push_back(line);
  std::vector<std::string> wanted;
  for (const ScriptInfo& script : scripts()) wanted.push_back(row_of(script));
  EXPECT_EQ(rows, wanted);
}

TEST(Script, EveryScriptCanBeMadeAndNamesAToolAndAnEffectThatThereAre) {
  SceneDef scene;
  each_effect(scene, []<class Def>(std::optional<Def>& effect) { effect.emplace(); });
  const Profile target{{{0.0, 0.05, 0.0}, {0.1, 0.06, 0.05}, {0.2, 0.05, 0.04}}};
  for (const ScriptInfo& script : scripts()) {
    const auto made = make_script(script.name, {.scene = scene, .target = &target});
    EXPECT_TRUE(made) << script.name;
    EXPECT_TRUE(script.shows.empty() || shows_its_effect(script, scene)) << script.name;
    EXPECT_EQ(find_script(script.name), &script) << "twice: " << script.name;
  }
  EXPECT_EQ(scripts().size(), script_names().size());
}

}  // namespace
}  // namespace onggi::script_test
