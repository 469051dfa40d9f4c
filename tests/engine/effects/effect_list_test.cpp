#include "engine/effects/effect_list.h"

#include <gtest/gtest.h>

#include <array>
#include <span>
#include <string_view>

namespace onggi::effect_list_test {
namespace {

struct Told {
  std::string_view key;
  double usual, least, most;
};

template <class Def>
void expect(std::string_view effect, std::span<const Told> told) {
  EXPECT_EQ(Def::kName, effect);
  const Def def;
  ASSERT_EQ(Def::fields().size(), told.size()) << effect;
  for (std::size_t n = 0; n < told.size(); ++n) {
    const DefField<Def>& field = Def::fields()[n];
    EXPECT_EQ(field.key, told[n].key) << effect;
    EXPECT_EQ(def.*field.value, told[n].usual) << told[n].key;
    EXPECT_EQ(field.least, told[n].least) << told[n].key;
    EXPECT_EQ(field.most, told[n].most) << told[n].key;
  }
}

// What a scene's file gets that leaves a number out, and what it may say: config/README.md.
TEST(EffectField, EveryNumberHasItsUsualValueAndItsEnds) {
  expect<BeatingDef>("beating", std::to_array<Told>({{"energy", 0.03, 0.001, 2.0},
                                                     {"face", 0.02, 0.005, 0.08},
                                                     {"yield_stress", 80e3, 5e3, 1e6}}));
  expect<BuildingDef>("building", std::to_array<Told>({{"coil", 0.013, 0.008, 0.03},
                                                       {"tallest", 0.3, 0.05, 1.0},
                                                       {"pace", 0.5, 0.02, 5.0},
                                                       {"drift", 0.05, 0.0, 0.25},
                                                       {"joint", 0.3, 0.05, 1.0},
                                                       {"pinched", 0.8, 0.0, 1.0},
                                                       {"wetness", 0.1, 0.0, 1.0}}));
  expect<FrictionDef>("friction", std::to_array<Told>({{"coefficient", 0.35, 0.0, 2.0},
                                                       {"wet_factor", 0.3, 0.0, 1.0},
                                                       {"slip_speed", 0.01, 1e-4, 0.1}}));
  expect<KilnDef>("kiln", std::to_array<Told>({{"drying_shrinkage", 0.0625, 0.0, 0.15},
                                               {"firing_shrinkage", 0.0666, 0.0, 0.2},
                                               {"glaze_thickness", 0.0005, 0.0, 0.002}}));
  expect<MoistureDef>("moisture", std::to_array<Told>({{"wetting_time", 0.6, 0.05, 60.0},
                                                       {"drying_time", 60.0, 1.0, 36000.0},
                                                       {"fire_time", 10.0, 1.0, 36000.0},
                                                       {"softening", 0.5, 0.05, 1.0},
                                                       {"weakening", 0.03, 0.005, 1.0},
                                                       {"air", 0.0, 0.0, 1.0},
                                                       {"sponge_height", 0.0, 0.0, 1.0}}));
  expect<PrintsDef>("prints", std::to_array<Told>({{"pitch", 0.003, 5e-4, 0.01},
                                                   {"rings", 0.004, 0.0, 0.02},
                                                   {"depth", 4e-4, 5e-5, 0.002}}));
  ASSERT_EQ(PrintsDef::counts().size(), 1u);
  EXPECT_EQ(PrintsDef{}.paddle, PrintsDef::plain);
  expect<PropagationDef>("propagation", std::to_array<Told>({{"reach", 0.004, 0.0005, 0.05}}));
  expect<SlumpDef>("slump", std::to_array<Told>({{"yield_stress", 6000.0, 100.0, 1e6},
                                                 {"viscosity", 1e4, 10.0, 1e8},
                                                 {"density", 1950.0, 500.0, 4000.0},
                                                 {"fall", 0.1, 0.01, 0.9}}));
  expect<SmoothingDef>("smoothing", std::to_array<Told>({{"pace", 1e-4, 1e-6, 1e-2}}));
  expect<SpringbackDef>(
      "springback", std::to_array<Told>({{"share", 0.15, 0.0, 0.5}, {"time", 0.2, 0.01, 10.0}}));
  expect<WallsDef>("walls", std::to_array<Told>({{"support", 0.03, 0.001, 0.2},
                                                 {"tear_thickness", 0.0, 0.0, 0.02},
                                                 {"tear_strain", 0.0, 0.0, 10.0},
                                                 {"bending_strength", 0.0, 0.0, 1e6}}));
  expect<WobbleDef>("wobble", std::to_array<Told>({{"off_centre", 0.004, 0.0, 0.03},
                                                   {"centring_time", 0.05, 0.002, 60.0},
                                                   {"reach", 0.03, 0.001, 1.0}}));
}

}  // namespace
}  // namespace onggi::effect_list_test
