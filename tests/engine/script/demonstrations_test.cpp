#include "engine/script/demonstrations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include "engine/effects/wobble.h"
#include "engine/math/portable.h"
#include "engine/math/vectors.h"
#include "engine/profile/measures.h"
#include "engine/scene/lump.h"
#include "engine/scene/scene.h"
#include "engine/script/coiling.h"
#include "tests/engine/script/vessels.h"

namespace onggi::demonstrations_test {
namespace {

// Everything that a scene can have but the kiln, which comes later.
SceneDef everything() {
  SceneDef def;
  def.clay.rows = 120;
  def.clay.sectors = 96;
  def.clay.inner_radius = 0.035;
  each_effect(def, []<class Def>(std::optional<Def>& effect) { effect.emplace(); });
  def.kiln.reset();
  def.wobble.reset();
  def.building.reset();
  def.prints.reset();  // they move nothing
  def.moisture->sponge_height = 0.06;
  return def;
}

std::vector<std::string_view> demonstrations() {
  std::vector<std::string_view> names;
  for (const ScriptInfo& script : scripts())
    if (!script.shows.empty() && !script.needs.target) names.push_back(script.name);
  return names;
}

struct Thrown {
  Scene scene;
  bool fell = false, tore = false;
  std::map<std::string_view, double> wet, deep;  // at each phase's end; deepest press in it
};

Thrown play(std::string_view name, SceneDef def, Vectors kind = best_vectors()) {
  Thrown out{std::move(*Scene::create(def, kind)), false, false, {}, {}};
  auto script = std::move(*make_script(name, {.scene = def}));
  for (int n = 0; n * 0.001 <= script->duration(); ++n) {
    const Feedback felt = out.scene.step(script->at(n * 0.001, out.scene.clay()), 0.001);
    EXPECT_EQ(felt.faults, 0u);
    out.fell = out.fell || felt.fallen;
    out.tore = out.tore || felt.torn;
    out.wet[script->phase(n * 0.001)] = felt.wetness;
    double& deep = out.deep[script->phase(n * 0.001)];
    deep = std::max(deep, felt.hand[0].depth);
  }
  return out;
}

TEST(Demonstrations, PullTallMakesAPotHalfAsTallAgain) {
  const Thrown pot = play("pull_tall", everything());
  EXPECT_GT(pot.scene.clay().rim_height(), 0.26);
  EXPECT_FALSE(pot.fell);
}

TEST(Demonstrations, CollapseFallsWhereTheSceneHasItAndStandsWhereItHasNot) {
  EXPECT_TRUE(play("collapse", everything()).fell);
  SceneDef firm = everything();
  firm.slump.reset();
  const Thrown stands = play("collapse", firm);
  EXPECT_FALSE(stands.fell);
  EXPECT_GT(stands.scene.clay().rim_height(), 0.22);
}

TEST(Demonstrations, AWallThatCanTearTearsWhereThePotFallsAndNowhereElse) {
  SceneDef def = everything();
  def.wobble.emplace();
  def.clay.wall_min = 0.002;
  def.walls->tear_thickness = 0.0025;
  def.walls->tear_strain = 2.0;
  for (const std::string_view name : demonstrations()) {
    const Thrown pot = play(name, def);
    EXPECT_EQ(pot.tore, pot.fell) << name;
  }
}

TEST(Demonstrations, DryOutDriesAndReWetWets) {
  const Thrown pot = play("re_wet", everything());
  EXPECT_LT(pot.wet.at("dry"), 0.8 * pot.wet.at("wet"));
  EXPECT_GT(pot.wet.at("wet again"), pot.wet.at("drier"));
}

TEST(Demonstrations, CentreCentres) {
  SceneDef def = everything();
  def.wobble.emplace();
  const Thrown pot = play("centre", def);
  const effects::OffCentre off = effects::off_centre_of(pot.scene.clay(), 60);
  EXPECT_LT(off.x * off.x + off.z * off.z, 0.001 * 0.001);
}

TEST(Demonstrations, RibSmoothTakesTheLineAway) {
  const auto unevenness = [](const Scene& scene) {
    const Profile p = scene.clay().profile();
    double rough = 0.0;  // of second differences: a slow slope is none
    for (double h = 0.09; h < 0.12; h += 0.002)
      rough = std::max(rough,
                       std::abs(p.outer_at(h - 0.003) - 2 * p.outer_at(h) + p.outer_at(h + 0.003)));
    return rough;
  };
  SceneDef def = everything();
  const double with = unevenness(play("rib_smooth", def).scene);
  def.smoothing.reset();
  EXPECT_LT(with, 0.7 * unevenness(play("rib_smooth", def).scene));
}

TEST(Demonstrations, BeatMakesTheWallThinnerWiderAndHigher) {
  SceneDef def = everything();
  def.clay.inner_radius = 0.045;
  def.beating = BeatingDef{0.08, 0.03, 16e3};  // soft clay, as in config/scenes/built.toml
  const auto played = [](const SceneDef& scene) {
    return play("beat", scene).scene.clay().profile();
  };
  const Profile beaten = played(def);
  def.beating.reset();
  const Profile plain = played(def);
  EXPECT_NEAR(plain.height(), def.clay.height, 0.002) << "no hand presses the wall";
  EXPECT_GT(beaten.height(), 1.05 * plain.height());
  const double h = 0.5 * plain.height();
  EXPECT_GT(beaten.outer_at(h), plain.outer_at(h) + 0.0005);
  EXPECT_LT(beaten.outer_at(h) - beaten.inner_at(h),
            0.95 * (plain.outer_at(h) - plain.inner_at(h)));
}

// On a disc, as a jar of onggi begins.
TEST(Demonstrations, CoilUpLaysFiveRingsThatCloseEachWithItsOwnClay) {
  SceneDef def = everything();
  def.building.emplace();
  def.clay.rows = 16;
  def.clay.height = def.clay.floor_thickness = 0.010;
  const Thrown pot = play("coil_up", def);
  EXPECT_TRUE(pot.scene.coil().centre.empty()) << "the last ring is closed";
  const double coil = def.building->coil;
  EXPECT_NEAR(pot.scene.clay().rim_height(), 0.010 + 5 * 0.89 * coil, 0.004);
  EXPECT_FALSE(pot.tore);
  // Pappus: the section times the way of its middle, which drifts outwards from 0.049 m.
  const double ring = 0.25 * portable::kPi * coil * coil * 2.0 * portable::kPi * 0.049;
  EXPECT_GT(pot.scene.coil().added, 5.0 * ring);
  EXPECT_LT(pot.scene.coil().added, 5.3 * ring);
}

// On the floor that lump_for() beats for it.
Scene built(const Profile& target, SceneDef def) {
  def.clay = lump_for(target, def);
  const auto script = std::move(*make_script("build", {.scene = def, .target = &target}));
  EXPECT_LT(script->duration(), 120.0);
  Scene scene = std::move(*Scene::create(def));
  for (double t = 0.0; t < script->duration() + 0.1; t += 0.001)
    scene.step(script->at(t, scene.clay()), 0.001);
  EXPECT_TRUE(scene.coil().centre.empty()) << "every ring is closed";
  return scene;
}

TEST(Demonstrations, BuildRaisesAVesselUpItsOwnLineWhereCoilsComeNearIt) {
  std::vector<std::string> came, never;
  for (const auto& [name, drawn] : vessels::all()) {
    const Profile target = scaled(drawn, workspace_scale(drawn));
    SceneDef def = everything();
    def.building.emplace();
    def.beating.reset();
    const Profile made = built(target, def).clay().profile();
    EXPECT_NEAR(made.height(), target.height(), def.building->coil) << name;
    const double off = compare(target, made, true).outline_rms;
    const bool near = script::coils_come_near(target, def.building->coil);
    (near ? came : never).push_back(name);
    EXPECT_EQ(off < 0.0345, near) << name << ": " << off;
  }
  EXPECT_GE(came.size(), 2u) << "what is steep";
  EXPECT_GE(never.size(), 2u) << "bowls";
}

// With the coil and the paddle of config/scenes/built.toml.
TEST(Demonstrations, BuildBeatsItsRingsOutToALineThatCoilsAloneDoNotFollow) {
  for (const Profile& drawn : {vessels::moon_jar(), vessels::amphora()}) {
    const Profile target = scaled(drawn, workspace_scale(drawn));
    SceneDef def = everything();
    def.slump->yield_stress = 9000.0;
    def.building.emplace().coil = 0.018;
    def.beating = BeatingDef{0.15, 0.03, 16e3};
    const Profile beaten = built(target, def).clay().profile();
    def.beating.reset();
    const Profile laid = built(target, def).clay().profile();
    const double off = compare(target, beaten, true).outline_rms;
    EXPECT_LT(off, 0.03);
    EXPECT_LT(off, compare(target, laid, true).outline_rms);
    const double h = 0.5 * target.height();
    EXPECT_LT(beaten.outer_at(h) - beaten.inner_at(h), 0.8 * (laid.outer_at(h) - laid.inner_at(h)));
  }
}

// A ring rises for some ticks: on fine grids one counted twice.
TEST(Demonstrations, CoilUpLaysFiveRingsOnAFineGridToo) {
  SceneDef def = everything();
  def.building.emplace().coil = 0.018;
  def.clay.rows = 80;
  def.clay.sectors = 512;
  def.clay.height = def.clay.floor_thickness = 0.010;
  const Thrown pot = play("coil_up", def);
  EXPECT_NEAR(pot.scene.clay().rim_height(), 0.010 + 5 * 0.89 * 0.018, 0.006);
}

TEST(Demonstrations, CoilUpAlsoHeightensAWallThatWasThrown) {
  SceneDef def = everything();
  def.building.emplace().tallest = 0.4;
  const Thrown pot = play("coil_up", def);
  EXPECT_GT(pot.scene.clay().rim_height(), def.clay.height + 0.05);
}

// The hash at each script's end is kept in tests/golden: it changes only with its reason told.
TEST(Demonstrations, ComesToTheGoldenHashes) {
  std::ostringstream hashes;
  SceneDef def = everything();
  def.wobble.emplace();
  for (const std::string_view name : demonstrations()) {
    if (find_script(name)->shows == BuildingDef::kName) def.building.emplace();
    hashes << name << ' ' << std::hex << play(name, def).scene.state_hash() << '\n';
    def.building.reset();
  }
  std::ifstream file("tests/golden/effects_trace.txt");
  std::ostringstream golden;
  golden << file.rdbuf();
  EXPECT_EQ(hashes.str(), golden.str());
}

TEST(Demonstrations, EffectsComeToTheSameBitsOnEveryKindOfVectors) {
  SceneDef def = everything();
  def.clay.rows = 40;  // a tool's kernel is not optimised under sanitizers
  def.clay.sectors = 72;
  def.wobble.emplace();
  for (const std::string_view name : {"centre", "rib_smooth"}) {
    const std::uint64_t best = play(name, def).scene.state_hash();
    for (const Vectors kind : vectors_here())
      EXPECT_EQ(play(name, def, kind).scene.state_hash(), best) << name << " on " << name_of(kind);
  }
}

TEST(Demonstrations, EveryScriptIsShownWhereItsEffectIsAndNowhereElse) {
  SceneDef all = everything();
  all.wobble.emplace();
  all.building.emplace();
  SceneDef bare;
  each_effect(bare, [](auto& effect) { effect.reset(); });
  for (const std::string_view name : demonstrations()) {
    EXPECT_TRUE(shows_its_effect(*find_script(name), all)) << name;
    EXPECT_FALSE(shows_its_effect(*find_script(name), bare)) << name;
  }
  EXPECT_FALSE(shows_its_effect(*find_script("follow"), all));
}

TEST(Demonstrations, AScriptWhoseToolIsNotToHandIsRefused) {
  SceneDef def = everything();
  def.tools.clear();
  EXPECT_FALSE(shows_its_effect(*find_script("rib_smooth"), def));
  EXPECT_FALSE(make_script("rib_smooth", {.scene = def}));
  EXPECT_TRUE(make_script("centre", {.scene = def}));
}

}  // namespace
}  // namespace onggi::demonstrations_test
