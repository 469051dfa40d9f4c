#include "kiosk/collection/decoration/starts.h"

#include <algorithm>
#include <cmath>

namespace onggi::decoration {

namespace {

constexpr double kOneZone = 0.04;                // shares: what lies nearer is one zone
constexpr int kLeastRepeats = 2, kNails = 24;    // a figure that comes back; more are one band
constexpr double kShort = 0.22;                  // of a figure's height
constexpr double kLeastReach = 0.012;            // share
constexpr double kNoZone = 0.02, kWhole = 0.75;  // shares: a coat's edge that nobody sees; a ground

/// The first way of a motif, shortened to kShort.
bool first_way(const Motif& motif, Vec2& from, Vec2& to) {
  const auto& ways = motif.lines.empty() ? motif.fills : motif.lines;
  if (ways.empty() || ways.front().size() < 2) return false;
  const auto& way = ways.front();
  from = to = way.front();
  for (std::size_t n = 1; n < way.size(); ++n) {
    to = way[n];
    const double far = std::hypot(to.x - from.x, to.y - from.y);
    if (far < kShort) continue;
    to = {from.x + (to.x - from.x) * kShort / far, from.y + (to.y - from.y) * kShort / far};
    break;
  }
  return from.x != to.x || from.y != to.y;
}

bool is_ring(const Step& step) {
  switch (step.kind) {
    case Step::band:
    case Step::coil:
      return true;
    case Step::coat:
      return step.pigment != kGlaze && step.to - step.from < kWhole && step.from > kNoZone;
    case Step::smoke:
      return true;
    case Step::cut:
    case Step::wipe:
      return step.motif.lines.empty() && step.motif.fills.empty();
    default:
      return false;
  }
}

}  // namespace

std::vector<Start> starts_of(const Decoration& decoration, double outside) {
  std::vector<Start> starts;
  for (const Step& step : decoration.steps) {
    Start start;
    start.inside = step.inside;
    start.ring = is_ring(step);
    start.at = step.kind == Step::coat    ? 0.5 * (step.from + step.to)
               : step.kind == Step::smoke ? step.from
                                          : step.at;
    start.reach = std::max(kLeastReach, 0.5 * step.width / outside);
    if (!start.ring) {
      const bool figure = step.kind == Step::paint || step.kind == Step::cut ||
                          step.kind == Step::wipe || step.kind == Step::stamp;
      if (!figure || step.repeat < kLeastRepeats) continue;
      const double unit = step.size / outside;
      start.reach = std::max(kLeastReach, 0.5 * unit);
      start.ring = step.repeat > kNails;
      start.repeats = start.ring ? 1 : step.repeat;
      start.turn = step.turn;
      if (!start.ring && !first_way(step.motif, start.from, start.to)) continue;
      start.from = start.from * unit, start.to = start.to * unit;
    }
    const bool known = std::ranges::any_of(starts, [&](const Start& other) {
      return other.ring == start.ring && other.inside == start.inside &&
             std::abs(other.at - start.at) < kOneZone;
    });
    if (!known) starts.push_back(start);
  }
  return starts;
}

}  // namespace onggi::decoration
