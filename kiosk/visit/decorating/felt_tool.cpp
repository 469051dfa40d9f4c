#include "kiosk/visit/decorating/felt_tool.h"

#include <variant>

namespace onggi::decorating {

namespace {

using force::DecoratingLaw;
using force::DecoratingTool;

constexpr double kHairBends = 0.002, kPad = 0.0015;  // m: how deep brush and finger are pressed
constexpr double kFillingBrush = 0.004;              // m
constexpr double kFills[] = {0.5, 0.785, 1.0, 0.5};  // by CutDef::Section, of width x depth

struct Felt {
  DecoratingTool operator()(const surface::CutDef& def) const {
    return {DecoratingLaw::cut, def.teeth * def.width, def.depth, 0.0, kFills[def.section]};
  }
  DecoratingTool operator()(const surface::BrushDef& def) const {
    return {DecoratingLaw::brush, def.width, kHairBends};
  }
  DecoratingTool operator()(const surface::ResistDef& def) const {
    return {DecoratingLaw::brush, def.width, kHairBends};
  }
  DecoratingTool operator()(const surface::FillDef&) const {
    return {DecoratingLaw::brush, kFillingBrush, kHairBends};
  }
  DecoratingTool operator()(const surface::ScrapeDef& def) const {
    return {DecoratingLaw::scrape, def.width, def.take};
  }
  DecoratingTool operator()(const surface::WipeDef& def) const {
    return {DecoratingLaw::wipe, def.width, kPad};
  }
  DecoratingTool operator()(const surface::BurnishDef& def) const {
    return {DecoratingLaw::wipe, def.width, kPad};
  }
  DecoratingTool operator()(const surface::CoilDef& def) const {
    return {DecoratingLaw::wipe, def.width, kPad};
  }
  DecoratingTool operator()(const surface::StampDef& def) const {
    return {DecoratingLaw::stamp, def.size, def.depth};
  }
  DecoratingTool operator()(const surface::DipDef&) const { return {}; }
  DecoratingTool operator()(const surface::SmokeDef&) const { return {}; }
};

}  // namespace

force::DecoratingTool felt_tool(const decoration::WayTool& tool, decoration::WayTool::State state) {
  DecoratingTool felt = std::visit(Felt(), tool.law);
  felt.dryness = state >= decoration::WayTool::dry ? 1.0 : 0.0;
  return felt;
}

}  // namespace onggi::decorating
