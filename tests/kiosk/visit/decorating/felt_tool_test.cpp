#include "kiosk/visit/decorating/felt_tool.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace onggi::decorating::felt_tool_test {
namespace {

using decoration::WayTool;
using force::DecoratingLaw;
using force::DecoratingTool;

TEST(FeltTool, ACombHasTheWidthOfAllItsTeethAndAVHalfOfWhatAFlatOneTakes) {
  WayTool tool;
  surface::CutDef comb;
  comb.teeth = 5, comb.width = 8e-4, comb.depth = 6e-4, comb.section = surface::CutDef::v;
  tool.law = comb;
  const DecoratingTool felt = felt_tool(tool, WayTool::leather);
  EXPECT_EQ(felt.law, DecoratingLaw::cut);
  EXPECT_DOUBLE_EQ(felt.width, 0.004);
  EXPECT_DOUBLE_EQ(felt.depth, 6e-4);
  EXPECT_DOUBLE_EQ(felt.fill, 0.5);
  EXPECT_EQ(felt.dryness, 0.0);
  EXPECT_EQ(felt_tool(tool, WayTool::dry).dryness, 1.0);
}

TEST(FeltTool, EveryToolOfEveryWayIsFeltButADipAndSmokeAndNoneBeyondItsRange) {
  int brushes = 0, cuts = 0;
  for (const auto& file : std::filesystem::directory_iterator("content/ways")) {
    const auto read = decoration::read_way(file.path(), {});
    for (const WayTool& tool : read.way.tools) {
      const DecoratingTool felt = felt_tool(tool, WayTool::leather);
      const bool still = std::holds_alternative<surface::DipDef>(tool.law) ||
                         std::holds_alternative<surface::SmokeDef>(tool.law);
      EXPECT_EQ(felt.law == DecoratingLaw::none, still) << file.path() << ' ' << tool.id;
      const double grip = force::press_of(felt, felt.depth).grip;
      if (felt.law == DecoratingLaw::brush) {
        ++brushes;
        EXPECT_GE(grip, 0.02) << file.path() << ' ' << tool.id;
        EXPECT_LE(grip, 0.3) << file.path() << ' ' << tool.id;
      }
      if (felt.law == DecoratingLaw::cut) {
        ++cuts;
        EXPECT_GE(grip, 0.02) << file.path() << ' ' << tool.id;
        EXPECT_LE(grip, 8.0) << file.path() << ' ' << tool.id;
      }
    }
  }
  EXPECT_GT(brushes, 10);
  EXPECT_GT(cuts, 5);
}

}  // namespace
}  // namespace onggi::decorating::felt_tool_test
