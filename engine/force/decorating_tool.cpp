#include "engine/force/decorating_tool.h"

#include <algorithm>
#include <cmath>

namespace onggi::force {

namespace {

constexpr double kShear = 170e3;   // Pa, tau of leather-hard clay
constexpr double kDryer = 1.0;     // share that dry clay has more
constexpr double kHard = 5.14;     // Prandtl's 2 + pi
constexpr double kFriction = 0.4;  // of steel or wood on clay: beta = 22 degrees
constexpr double kCutting = 2.47;  // 2 cot(39 degrees): a rake of 10
constexpr double kThrust = 0.21;   // tan(12 degrees)
constexpr double kSinks = 1.5e-4;  // m, d_y
constexpr double kKnifeEdge = 1.5e-4, kScraperEdge = 3e-4;  // m, e
// N/m: no stiffer than the wheel head, for which a device's coupling was derived.
constexpr double kStiffest = 500.0, kStop = 250.0;
constexpr double kThinChips =
    2.0;  // times as dear, where they are no thicker than the edge is blunt
constexpr double kMostEdge = 6.0;  // N that an edge bears before it sinks

/// The law's figures for one tool.
struct Answer {
  double edge = 0.0, yields = 1.0;  // Y, N; d_y, m
  double cuts = 0.0, thrust = 0.0;  // k, c, N/m
  double friction = 0.0, most = 0.0, stop = 0.0;
};

/// A number that is none is the lower end.
double within(double value, double low, double high) {
  return value > low ? std::min(value, high) : low;
}

Answer blade(double width, double strength, double edge, double fill) {
  Answer made;
  made.edge = std::min(kMostEdge, kHard * strength * width * edge);
  made.yields = std::max(kSinks, made.edge / kStiffest);
  made.cuts = kCutting * strength * width * fill;
  made.thrust = std::min(kStiffest, kThrust * made.cuts);
  made.friction = kFriction;
  made.most = kMostGrip;
  made.stop = kStop;
  return made;
}

Answer answer_of(const DecoratingTool& tool) {
  const double width = within(tool.width, DecoratingTool::kLeastWidth, DecoratingTool::kMostWidth);
  const double dryness = within(tool.dryness, 0.0, 1.0);
  const double strength = kShear * (1.0 + kDryer * dryness);
  const double wide = width / (width + 0.012);
  switch (tool.law) {
    case DecoratingLaw::none:
      break;
    case DecoratingLaw::cut:
      return blade(width, strength, kKnifeEdge, within(tool.fill, 0.0, 1.0));
    case DecoratingLaw::scrape:
      return blade(width, strength, kScraperEdge, kThinChips);
    case DecoratingLaw::brush:  // Hair bends and slides; the ferrule stops it.
      return {0.06 + 0.55 * wide, 0.002, 0.0, 0.0, 0.5, 0.3, 100.0};
    case DecoratingLaw::wipe:  // A fingertip's pad on wet glaze or slip; the bone.
      return {2.0 * wide, 0.002, 0.0, 0.0, kFriction, 1.5, kStop};
    case DecoratingLaw::stamp: {
      const double bears = 0.5 * kMostEdge * wide * (1.0 + kDryer * dryness);
      return {bears, std::max(4e-4, bears / kStiffest), 0.0, 0.0, kFriction, 2.0, kStop};
    }
  }
  return {};
}

}  // namespace

ToolPress press_of(const DecoratingTool& tool, double depth) noexcept {
  const Answer is = answer_of(tool);
  ToolPress press;
  press.stiffness = is.edge / is.yields + is.thrust + is.stop;
  if (!(depth > 0.0) || !std::isfinite(depth)) return press;
  const double own = within(tool.depth, DecoratingTool::kLeastDepth, DecoratingTool::kMostDepth);
  const double cut = std::min(depth, own);
  press.push = is.edge * depth / (depth + is.yields) + is.thrust * cut + is.stop * (depth - cut);
  press.grip = std::min(is.most, is.cuts * cut + is.friction * press.push);
  return press;
}

}  // namespace onggi::force
