#pragma once

#include <array>
#include <cstdint>

#include "engine/scene/hands.h"

namespace onggi::sound {

/// One hand on the clay, as it sounds.
struct Rub {
  enum class Kind : std::uint8_t { hand, sponge, rib, wire };
  Kind kind = Kind::hand;
  double slip = 0.0;  ///< m/s: the clay's velocity against the tool.
  double push = 0.0;  ///< N, how hard clay and tool press each other; 0: they do not touch.
};

/// Everything that there is to hear at one moment. Plain values; what is no number counts as 0.
struct Heard {
  double wheel = 0.0;              ///< rad/s, either way.
  double wet = 0.0;                ///< 0 dry .. 1 dripping.
  std::array<Rub, kMaxHands> rub;  ///< A hand each.
  double fire = 0.0;               ///< 0 .. 1: of the kiln.
  double volume = 0.0;             ///< 0 silent .. 1.
};

}  // namespace onggi::sound
