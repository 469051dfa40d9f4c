#pragma once

#include <array>
#include <cstdint>

#include "engine/scene/hands.h"

namespace onggi::sound {

/// The sound of one hand on the clay.
struct Rub {
  enum class Kind : std::uint8_t { hand, sponge, rib, wire };
  Kind kind = Kind::hand;
  double slip = 0.0;  ///< m/s: speed of the clay relative to the tool.
  double push = 0.0;  ///< N, between clay and tool; 0: no contact.
};

/// A hand's paddle.
struct Knock {
  double force = 0.0;  ///< N of the blow, while the paddle lies on the wall; 0: it does not.
};

/// Everything that can be heard at one moment. Plain values; NaN counts as 0.
struct Heard {
  double wheel = 0.0;                  ///< rad/s, in either direction.
  double wet = 0.0;                    ///< 0 dry .. 1 dripping.
  std::array<Rub, kMaxHands> rub;      ///< A hand each,
  std::array<Knock, kMaxHands> knock;  ///< and its paddle.
  double fire = 0.0;                   ///< 0 .. 1: the kiln.
  double volume = 0.0;                 ///< 0 silent .. 1.
};

}  // namespace onggi::sound
