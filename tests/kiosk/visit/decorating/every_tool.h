#pragma once

#include <utility>

#include "kiosk/collection/decoration/way.h"
#include "tests/kiosk/visit/decorating/a_jar.h"

namespace onggi::decorating {

enum Of { band, leaf, cut, flood, scrape, glaze, wipe, smoke };

inline decoration::WayTool a_tool(const char* id, decoration::WayTool::Hand hand, surface::Tool law,
                                  int repeats = 8) {
  decoration::WayTool tool;
  tool.id = id, tool.hand = hand, tool.law = std::move(law), tool.repeats = repeats;
  return tool;
}

/// One of every kind, in the order of `Of`.
inline decoration::Way every_tool() {
  using decoration::WayTool;
  decoration::Way way;
  way.palette.pigments = {{{0.9f, 0.9f, 0.9f}, {0.8f, 0.8f, 0.8f}, 2e-5},
                          {{0.4f, 0.1f, 0.1f}, {0.02f, 0.02f, 0.02f}, 2e-5}};
  way.pigments = {{"white", {}}, {"black", {}}};
  way.figures = {{"leaf", {{{{-0.3, -0.5}, {0.3, -0.5}, {0.3, 0.5}, {-0.3, 0.5}}}, {}}, {}}};
  surface::BrushDef brush;
  brush.width = 0.006, brush.reach = 100.0;
  way.tools.push_back(a_tool("band", WayTool::ring, brush));
  way.tools.back().pigments = {0, 1};
  way.tools.push_back(a_tool("leaf", WayTool::figure, brush, 5));
  way.tools.back().pigments = {1, 0};
  way.tools.back().motifs = {0};
  surface::CutDef needle;
  needle.width = 0.001, needle.depth = 7e-4, needle.burr = 0.0;
  way.tools.push_back(a_tool("cut", WayTool::line, needle));
  surface::BrushDef broad = brush;
  broad.width = 0.03, broad.fill = 0.67;
  way.tools.push_back(a_tool("flood", WayTool::all, broad));
  way.tools.back().pigments = {0};
  surface::ScrapeDef blade;
  blade.width = 0.02;
  way.tools.push_back(a_tool("scrape", WayTool::ring, blade));
  way.tools.back().needs = flood;
  surface::DipDef dip;
  dip.seconds = 1.0, dip.drinks = 1.0;
  way.tools.push_back(a_tool("glaze", WayTool::all, dip));
  surface::WipeDef finger;
  finger.wet_time = 3600.0;
  way.tools.push_back(a_tool("wipe", WayTool::line, finger));
  way.tools.back().needs = glaze;
  way.tools.push_back(a_tool("smoke", WayTool::up, surface::SmokeDef{}));
  return way;
}

}  // namespace onggi::decorating
