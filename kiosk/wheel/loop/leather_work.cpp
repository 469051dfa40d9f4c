#include "kiosk/wheel/loop/leather_work.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace onggi::loop {

namespace {
constexpr double kSlides =
    0.005;  // m/s: slower, a device without a coupling feels less of the grip
}  // namespace

force::LeatherOutline* LeatherWork::begin(force::LeatherOutline* wall) noexcept {
  force::LeatherOutline* const before = wall_;
  *this = LeatherWork();
  wall_ = wall;
  return before;
}

force::LeatherOutline* LeatherWork::ended(bool now) noexcept {
  if (wall_ == nullptr || (!now && !(ending_ && share_ <= 0.0))) return nullptr;
  return begin(nullptr);
}

void LeatherWork::hold(const force::DecoratingTool& tool, const force::LeatherTurn& turn) noexcept {
  next_ = tool;
  if (!std::isfinite(turn.angle) || !std::isfinite(turn.speed)) return;
  turn_ = turn;
  silent_ = 0.0;
}

HandFeedback LeatherWork::felt_by(Hand& hand, const HandInput& input, double seconds,
                                  const force::GuardLimits& limits) noexcept {
  HandFeedback felt;
  if (!input.active) {
    hand = Hand();
    return felt;
  }
  felt.touch = hand.tool.meet(*wall_, tool_, input.position, share_, turn_);
  felt.contact = hand.tool.place().contact;
  felt.depth = felt.contact ? hand.tool.place().depth : 0.0;
  // For devices without a coupling: friction by the velocity, which passes through 0 evenly.
  const Vec3 slides = hand.velocity.go(input.position, seconds) - felt.touch.clay;
  const double speed = std::sqrt(dot(slides, slides) + kSlides * kSlides);
  bool finite = true;
  felt.force = hand.guard.step(felt.touch.push - (felt.touch.grip / speed) * slides, seconds,
                               limits, finite);
  return felt;
}

std::array<HandFeedback, kMaxHands> LeatherWork::step(const std::array<HandInput, kMaxHands>& hands,
                                                      double seconds,
                                                      const force::GuardLimits& limits) noexcept {
  std::array<HandFeedback, kMaxHands> felt;
  if (wall_ == nullptr) return felt;
  const bool goes = ending_ || next_ != tool_;
  share_ = std::clamp(share_ + (goes ? -seconds / kGoes : seconds / kComes), 0.0, 1.0);
  if (share_ <= 0.0 && !ending_) tool_ = next_;
  silent_ += seconds;
  if (silent_ > kSilent) turn_.speed = 0.0;
  turn_.angle += turn_.speed * seconds;
  for (std::size_t h = 0; h < felt.size(); ++h)
    felt[h] = felt_by(hands_[h], hands[h], seconds, limits);
  return felt;
}

}  // namespace onggi::loop
