#pragma once

#include <cstdint>

namespace onggi::loop {

/// What hand 0 works with, whatever device leads it.
enum class InHand : std::uint8_t {
  tool,    ///< Its tool (HandInput::tool).
  coil,    ///< A coil of clay (HandInput::coil).
  paddle,  ///< A paddle, with an anvil behind the wall: it beats three times a second where the
           ///< hand is (HandInput::blow). The hand of a force device beats while it rests on the
           ///< wall.
};

/// The rhythm of the paddle. Plain values; the loop's thread.
class Paddle {
 public:
  static constexpr double kBeat = 0.34;   ///< s from blow to blow,
  static constexpr double kLies = 0.12;   ///< of which the paddle lies on the wall so long.
  static constexpr double kSwing = 0.03;  ///< m: how far it is drawn back in between.

  /// A tick of `seconds`. `beats`: a hand is where it should strike. True while the paddle lies on
  /// the wall: a blow is where this becomes true. The first comes a sixth of a second after the
  /// hand, and each lies its whole time.
  bool step(bool beats, double seconds) noexcept {
    if (!beats && at_ >= kLies) return at_ = kBegins, false;
    at_ += seconds;
    if (at_ >= kBeat) at_ -= kBeat;
    return at_ < kLies;
  }
  /// How far it is from the wall now, 0..1 of kSwing.
  double back() const noexcept {
    const double share = (at_ - kLies) / (kBeat - kLies);
    return at_ < kLies ? 0.0 : 4.0 * share * (1.0 - share);
  }

 private:
  static constexpr double kBegins = kBeat - 1.0 / 6.0;
  double at_ = kBegins;  // s since the last blow
};

}  // namespace onggi::loop
