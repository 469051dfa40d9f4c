#include "kiosk/visit/screens/led_tool.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "kiosk/visit/decorating/felt_tool.h"

namespace onggi::screens {

namespace {
constexpr double kSeenFrom = 0.02;       // m from the wall: its finger is faint there
constexpr int kRowsACorner = 2;          // of the outline that a device feels
constexpr double kMostTurnAFrame = 0.5;  // rad: more is another view of the pot, no turning
}  // namespace

LedTool::~LedTool() {
  if (hard_) commands_.harden(nullptr);
}

void LedTool::harden(const surface::Surface& surface) {
  std::vector<Vec2> corners;
  for (int row = 0; row < surface.rows(); row += kRowsACorner)
    corners.push_back({surface.row(row).radius, surface.row(row).height});
  constexpr double kRow = 1e-6 * surface::kRowHeight;  // m
  commands_.harden(
      std::make_unique<force::LeatherOutline>(corners, 0.5 * kRow, kRowsACorner * kRow));
  hard_ = true;
}

std::optional<std::size_t> LedTool::hand_at(const loop::LoopStatus& status) const {
  if (leads_ && status.at_leather[*leads_].near) return leads_;
  std::optional<std::size_t> found;
  for (std::size_t h = 0; h < status.at_leather.size(); ++h)
    if (status.at_leather[h].near &&
        (!found || status.at_leather[h].depth > status.at_leather[*found].depth))
      found = h;
  return found;
}

void LedTool::let_go(decorating::TouchQueue& touches) {
  if (leads_) touches.lift();
  leads_.reset();
  waits_ = true;
}

bool LedTool::update(const loop::LoopStatus& status, const decorating::DecoratedPot& pot,
                     double angle, double dt, bool free, decorating::TouchQueue& touches) {
  finger_.reset();
  if (!hard_ && !status.hands_taken) return false;
  if (!hard_) harden(pot.surface());
  if (tool_ != pot.tool()) {
    let_go(touches);
    tool_ = pot.tool();
  }
  const double turned = angle - std::exchange(angle_, angle).value_or(angle);
  force::LeatherTurn turn{angle, 0.0};
  if (dt > 0.0 && turned > -kMostTurnAFrame && turned < kMostTurnAFrame) turn.speed = turned / dt;
  commands_.decorate(
      pot.waits(tool_) ? force::DecoratingTool{} : decorating::felt_tool(pot.held(), pot.state()),
      turn);
  const auto hand = status.leather ? hand_at(status) : std::nullopt;
  if (!hand || !status.at_leather[*hand].contact) {
    if (leads_) touches.lift();
    leads_.reset();
    waits_ = false;
  }
  if (!hand) return false;
  const force::LeatherPlace& place = status.at_leather[*hand];
  const decorating::Place at{place.along, place.turns};
  if (const double off = -place.depth / kSeenFrom; off < 1.0)
    finger_ = {at, std::clamp(off, 0.0, 1.0)};
  if (!place.contact) return false;
  if (!free) {
    let_go(touches);
    return false;
  }
  if (waits_) return false;
  if (leads_) {
    touches.move(at);
    return false;
  }
  leads_ = hand;
  touches.press(at);
  return true;
}

}  // namespace onggi::screens
