#include "kiosk/lab/measure/frame_load.h"

#include <gtest/gtest.h>

#include <map>

#include "kiosk/ground/files/virtual_display.h"

namespace onggi::measure::frame_load_test {
namespace {

class AFrameOfTheExhibit : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    auto display = files::VirtualDisplay::ensure(640, 360);
    if (!display) return;
    FrameLoadPlan plan;
    plan.config = "config/exhibit.toml";
    plan.size = {640, 360};
    plan.frames = 8;
    plan.attract = 6;
    plan.naive = 6;
    auto loads = measure_load(plan);
    ASSERT_TRUE(loads) << to_text(loads.error());
    for (const FrameLoad& load : *loads)
      loads_[load.screen + (load.moving ? "" : ", still")] = load;
  }
  void SetUp() override {
    if (loads_.empty()) GTEST_SKIP() << "no display, and Xvfb is not installed";
  }
  static std::map<std::string, FrameLoad> loads_;
};
std::map<std::string, FrameLoad> AFrameOfTheExhibit::loads_;

// What this very plan asked for, a frame, on the day that frames were first counted.
struct Once {
  const char* screen;
  double draws, vertices, bytes, vertex_runs, fragment_runs;
};
constexpr Once kOnce[] = {{"attract", 22.0, 61800, 121212, 15071, 1702708},
                          {"throwing", 85.5, 178081, 175956, 38219, 1862946}};

// Smooth edges did not exist then: the lip's strip, creases and outlines.
constexpr double kEdges = 3.0, kBytesOfEdges = 64e3;

TEST_F(AFrameOfTheExhibit, AsksForHalfAsManyDrawCallsVerticesAndBytesAsItOnceDid) {
  for (const Once& once : kOnce) {
    const FrameLoad& load = loads_[once.screen];
    EXPECT_LE(load.a_frame(load.work.draws), 0.5 * once.draws + kEdges) << once.screen;
    EXPECT_LE(load.a_frame(load.work.draws), 13.0 + kEdges) << once.screen;
    EXPECT_LE(load.a_frame(load.work.vertices), 0.5 * once.vertices) << once.screen;
    EXPECT_LE(load.a_frame(load.work.bytes), 0.5 * once.bytes + kBytesOfEdges) << once.screen;
    // It does draw.
    EXPECT_GE(load.a_frame(load.work.draws), 6.0) << once.screen;
    EXPECT_GE(load.a_frame(load.work.vertices), 3e3) << once.screen;
  }
}

TEST_F(AFrameOfTheExhibit, RunsHalfAsManyShaders) {
  if (!loads_["attract"].shading_counted) GTEST_SKIP() << "this driver counts no shader runs";
  for (const Once& once : kOnce) {
    const FrameLoad& load = loads_[once.screen];
    EXPECT_LE(load.a_frame(load.work.vertex_runs), 0.5 * once.vertex_runs) << once.screen;
    EXPECT_LE(load.a_frame(load.work.fragment_runs), 0.5 * once.fragment_runs) << once.screen;
    EXPECT_GE(load.a_frame(load.work.fragment_runs), 640.0 * 360.0) << once.screen;
  }
}

TEST_F(AFrameOfTheExhibit, AsksForNothingWhereNothingMoves) {
  EXPECT_EQ(loads_["attract, still"].work, render::FrameWork{});
  // A hint may come or go.
  const FrameLoad& still = loads_["throwing, still"];
  EXPECT_LE(still.work.draws, 2u * 8);
  EXPECT_LE(still.work.bytes, 64u << 10);
}

}  // namespace
}  // namespace onggi::measure::frame_load_test
