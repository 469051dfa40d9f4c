#include "kiosk/lab/plots/accuracy_chart.h"

#include <gtest/gtest.h>

#include <string>

namespace onggi::plots::accuracy_chart_test {
namespace {

std::string text_of(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

AccuracyChart some_chart() {
  AccuracyChart chart;
  chart.title = "What accuracy costs";
  chart.lines = {{.name = "ours", .marks = {{2.0, 0.2, "50 × 45"}, {20.0, 0.01, "400 × 360"}}},
                 {.name = "printed", .hollow = true, .marks = {{9.0, 0.5, "", true}}}};
  chart.edge = chart.lines[0].marks;
  chart.thresholds = {{0.055, "a device"}};
  chart.forces = {{.elements = {0.01, 1.0}, .force = {1.1, 1.0}}};
  return chart;
}

TEST(AccuracyChart, IsTheSamePixelsTwiceAndAVectorWhereItsNameSaysSo) {
  const auto once = draw_accuracy(some_chart(), "a.png");
  EXPECT_TRUE(once == draw_accuracy(some_chart(), "a.png"));
  EXPECT_GT(once.size(), 10'000u);
  const std::string svg = text_of(draw_accuracy(some_chart(), "a.svg"));
  EXPECT_NE(svg.find("<svg"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(AccuracyChart, ARingIsDrawnWhereRandomHandsBrokeASettingAndAStarWhereOneIsRecommended) {
  const auto drawn = [](const AccuracyChart& chart) { return draw_accuracy(chart, "a.svg"); };
  AccuracyChart chart = some_chart();
  const auto ringed = drawn(chart);
  chart.lines[1].marks[0].broke = false;
  const auto whole = drawn(chart);
  EXPECT_GT(ringed.size(), whole.size());
  chart.chosen = {20.0, 0.01};
  EXPECT_GT(drawn(chart).size(), whole.size());
}

TEST(AccuracyChart, APotStandsBesideItsMarkToo) {
  AccuracyChart chart = some_chart();
  AccuracyChart::Pot pot{.name = "50 × 45",
                         .below = "0.2 mm off",
                         .columns = 2,
                         .rows = 2,
                         .height = 0.1,
                         .radius = {0.05f, 0.05f, 0.05f, 0.05f},
                         .off = {1e-4f, 1e-4f, 1e-3f, 1e-3f}};
  const auto images = [](const AccuracyChart& drawn) {
    const std::string svg = text_of(draw_accuracy(drawn, "a.svg"));
    std::size_t count = 0;
    for (std::size_t at = svg.find("<image"); at != std::string::npos;
         at = svg.find("<image", at + 1))
      ++count;
    return count;
  };
  chart.pots = {pot};
  EXPECT_EQ(images(chart), 1u);
  chart.pots[0].at = chart.lines[0].marks[0];
  EXPECT_EQ(images(chart), 2u);
}

TEST(AccuracyChart, ASettingBeyondATicksTimeHasItsName) {
  AccuracyChart chart = some_chart();
  const auto glyphs = [](const AccuracyChart& drawn) {
    return draw_accuracy(drawn, "a.svg").size();
  };
  chart.lines[0].marks.push_back({1600.0, 0.01, ""});
  const auto without = glyphs(chart);
  chart.lines[0].marks.back().name = "6400 × 2880";
  EXPECT_GT(glyphs(chart), without + 200);
}

}  // namespace
}  // namespace onggi::plots::accuracy_chart_test
