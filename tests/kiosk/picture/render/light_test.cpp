#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kiosk/picture/render/levels.h"
#include "kiosk/picture/render/portrait.h"
#include "kiosk/picture/render/studio.h"

namespace onggi::render::light_test {
namespace {

glm::vec3 white(glm::vec3) { return glm::vec3(1.0f); }
glm::vec3 from_above(glm::vec3 d) { return glm::vec3(std::max(d.y, 0.0f)); }

TEST(Studio, AWhiteSphereLightsEverySideAlike) {
  const auto t = irradiance_terms(white, 32);
  EXPECT_NEAR(t[0].x, 1.0f, 1e-4f);
  for (std::size_t i = 1; i < 9; ++i) EXPECT_NEAR(t[i].x, 0.0f, 0.01f) << i;
}

TEST(Studio, ACosineSkyGivesItsExactIrradianceUpwards) {
  // E/pi facing up = 1/pi * integral of cos^2 over the hemisphere = 2/3.
  const auto t = irradiance_terms(from_above, 64);
  const float up = t[0].x + t[1].x - t[6].x - t[8].x;
  EXPECT_NEAR(up, 2.0f / 3.0f, 0.02f);
}

TEST(Studio, TheFarSideIsDimmerAndWarmer) {
  const glm::vec3 near = studio_light(window_direction(view::kWindowLeft)),
                  far = studio_light(-window_direction(view::kWindowLeft));
  EXPECT_GT(near.y, 2 * far.y);
  EXPECT_GT(far.x / far.z, near.x / near.z);
}

TEST(Levels, ACylinderSeesHalfItsPlaneAndNoShoulder) {
  Levels levels;
  levels.height = 0.2;
  levels.outer.fill(0.05f);
  levels.inner.fill(0.04f);
  const auto light = levels.light();
  EXPECT_NEAR(light[4 * 30 + 1], 0.0f, 1e-5f);
  EXPECT_NEAR(light[4 * 30 + 2], 1.0f, 1e-5f);
}

TEST(Levels, ANeckUnderAShoulderSeesLessSky) {
  Levels levels;
  levels.height = 0.2;
  levels.outer.fill(0.03f);
  for (std::size_t k = 40; k < 64; ++k) levels.outer[k] = 0.08f;
  const auto light = levels.light();
  EXPECT_GT(light[4 * 36 + 1], 0.5f);
  EXPECT_LT(light[4 * 36 + 2], 0.75f);
  EXPECT_GT(light[4 * 5 + 2], light[4 * 36 + 2]);
}

TEST(Levels, TheNarrowestRingOfABottleIsItsNeck) {
  Levels levels;
  levels.height = 0.2;
  levels.inner.fill(0.06f);
  for (std::size_t k = 50; k < 54; ++k) levels.inner[k] = 0.01f;
  const auto light = levels.light();
  EXPECT_NEAR(light[4 * (64 + 10) + 1], 0.01f, 1e-6f);
}

TEST(LevelsOf, ATurnedTubeHasItsOwnRadii) {
  Section tube;
  tube.outline = {{0, 0}, {0.05, 0}, {0.05, 0.2}, {0.04, 0.2}, {0.04, 0.01}, {0, 0.01}};
  const Levels levels = levels_of(revolve(tube, 128));
  for (std::size_t k = 6; k < 60; ++k) {
    EXPECT_NEAR(levels.outer[k], 0.05f, 2e-4f) << k;
    EXPECT_NEAR(levels.inner[k], 0.04f, 2e-4f) << k;
  }
}

TEST(LevelsOf, APlateIsOpenFromItsFloorUpThoughNothingOfItIsSteep) {
  Section plate;
  plate.outline = {{0, 0},        {0.06, 0},      {0.11, 0.016}, {0.114, 0.019},
                   {0.11, 0.019}, {0.06, 0.0045}, {0, 0.004}};
  const Levels levels = levels_of(revolve(plate, 128));
  const auto level = static_cast<std::size_t>(0.006 / 0.019 * kLevels);
  for (std::size_t k = level; k < kLevels; ++k) EXPECT_GT(levels.inner[k], 0.04f) << k;
  EXPECT_EQ(levels.inner[0], 0.0f);
}

TEST(LevelsOf, ASolidLumpHasNoInside) {
  Section lump;
  lump.outline = {{0, 0}, {0.05, 0}, {0.05, 0.2}, {0, 0.2}};
  const Levels levels = levels_of(revolve(lump, 128));
  for (std::size_t k = 0; k + 1 < kLevels; ++k) EXPECT_EQ(levels.inner[k], 0.0f) << k;
}

}  // namespace
}  // namespace onggi::render::light_test
