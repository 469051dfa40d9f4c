#include "kiosk/visit/decorating/wet_slip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "kiosk/visit/decorating/decorated_pot.h"
#include "tests/kiosk/visit/decorating/a_jar.h"
#include "tests/kiosk/visit/decorating/every_tool.h"

namespace onggi::decorating::wet_slip_test {
namespace {

float all(const std::vector<float>& wet) { return std::accumulate(wet.begin(), wet.end(), 0.0f); }

/// A tap with a tool, half-way up, and what it draws by itself.
std::unique_ptr<DecoratedPot> tapped(const decoration::Way& way, int tool) {
  auto pot = *DecoratedPot::begin(a_jar(), way);
  pot->choose_tool(tool);
  pot->press({0.5 * pot->outside(), 0.25});
  pot->lift();
  pot->end_work();
  return pot;
}

TEST(WetSlip, SlipGlistensWhereItWasLaidAndNowhereElse) {
  const decoration::Way way = every_tool();
  const auto pot = tapped(way, band);
  const std::vector<float>& wet = pot->wetness();
  ASSERT_EQ(wet.size(), static_cast<std::size_t>(WetSlip::kLevels));
  EXPECT_EQ(wet.front(), 0.0f);
  EXPECT_EQ(wet.back(), 0.0f);
  EXPECT_EQ(*std::max_element(wet.begin(), wet.end()), 1.0f);
  EXPECT_EQ(all(tapped(way, flood)->wetness()), static_cast<float>(WetSlip::kLevels));
}

TEST(WetSlip, DriesWithinTenSecondsHoweverLongAFrameIs) {
  const decoration::Way way = every_tool();
  for (const double frame : {1.0 / 60, 0.25}) {
    const auto pot = tapped(way, flood);
    float before = all(pot->wetness());
    for (double t = frame; t < 9.7; t += frame) {
      pot->update(frame);
      ASSERT_LT(all(pot->wetness()), before);
      before = all(pot->wetness());
    }
    for (double t = 0; t < 0.6; t += frame) pot->update(frame);
    EXPECT_TRUE(pot->wetness().empty()) << frame;
  }
}

TEST(WetSlip, NoToolThatLaysNoSlipWetsThePot) {
  const decoration::Way way = every_tool();
  for (const int tool : {cut, scrape, glaze, wipe, smoke})
    EXPECT_TRUE(tapped(way, tool)->wetness().empty()) << way.tools[std::size_t(tool)].id;
}

}  // namespace
}  // namespace onggi::decorating::wet_slip_test
