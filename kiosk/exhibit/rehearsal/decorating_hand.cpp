#include "kiosk/exhibit/rehearsal/decorating_hand.h"

#include <algorithm>
#include <cmath>

namespace onggi::rehearsal {

using decorating::DecoratedPot;
using decoration::WayTool;

namespace {

constexpr double kQuarter = 1.5707963267948966;  // rad
constexpr double kStroke = 1.2;                  // s on the pot
constexpr double kPause = 0.3;                   // s between two touches
/// Rings where they part a pot: under the rim and over the foot.
constexpr double kRings[] = {0.86, 0.2};

}  // namespace

DecoratingHand::DecoratingHand(const DecoratedPot& pot) {
  const auto& tools = pot.way().tools;
  for (int n = 0; n < static_cast<int>(tools.size()); ++n) {
    const WayTool& tool = tools[static_cast<std::size_t>(n)];
    if (tool.more) continue;  // behind a button
    switch (tool.hand) {
      case WayTool::ring:
        if (const auto* blade = std::get_if<surface::ScrapeDef>(&tool.law)) {
          // All over: the reveal.
          const double step = 0.85 * blade->width / pot.outside();
          for (double at = 0.5 * step; at < 1.0; at += step) touches_.push_back({n, at, at, 0});
        } else {
          for (const double at : kRings) touches_.push_back({n, at, at, 0});
        }
        break;
      case WayTool::figure:
        touches_.push_back({n, 0.56, 0.56, 0});
        break;
      case WayTool::line:
        touches_.push_back({n, 0.26, 0.38, 0.03});
        break;
      case WayTool::all:
        touches_.push_back({n, 0.5, 0.5, 0});
        break;
      case WayTool::up:
        touches_.push_back({n, 0.62, 0.62, 0});
        break;
    }
  }
}

DecoratingHand::Act DecoratingHand::step(double now, const DecoratedPot& pot,
                                         const view::Camera& camera) {
  if (done() || (pot.busy() && began_ < 0)) return {};
  const Touch& touch = touches_[next_];
  if (held_ != touch.tool) {
    held_ = touch.tool;
    began_ = -1;
    return {"decorate.tool." + std::to_string(touch.tool), {}};
  }
  if (began_ < 0) began_ = now + kPause;
  const double part = (now - began_) / kStroke;
  if (part < 0) return {};
  if (part >= 1) {
    ++next_;
    began_ = -1;
    return {};
  }
  const auto& surface = pot.surface();
  const double share = touch.from + part * (touch.to - touch.from);
  const int row = std::clamp(static_cast<int>(share * pot.outside() * 1e6) / surface::kRowHeight, 0,
                             surface.rows() - 1);
  // A line swings, like a leaf of grass.
  const double angle =
      kQuarter - camera.azimuth + 4 * kQuarter * touch.across * std::sin(4 * kQuarter * part);
  const double r = surface.row(row).radius;
  return {"", camera.project({r * std::cos(angle), surface.row(row).height, r * std::sin(angle)})};
}

}  // namespace onggi::rehearsal
