#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/math/random.h"
#include "engine/scene/replay.h"

namespace onggi::lab {

/// A stretch of a potter's work: each hand goes straight from one place to another.
struct Stroke {
  struct Part {
    HandInput begins;  ///< At the first tick.
    Vec3 ends;         ///< At the last, studio frame, m.
  };
  int ticks = 1;         ///< >= 1
  double dt = 0.001;     ///< Of each tick, s. Anything, also what is no time.
  bool ragged = false;   ///< Each tick has a length of its own, above 0 and up to `dt`.
  double tremble = 0.0;  ///< m: how far a hand shakes about its way.
  std::array<Part, kMaxHands> hand{};
  double wheel_speed = 0.0;  ///< rad/s. Anything.
  bool water = false, renew = false, restore = false;
};

/// A scene and all that is done in it: enough to do it again to the bit.
struct Trial {
  SceneDef def;
  std::uint64_t seed = 0;
  std::vector<Stroke> strokes;

  std::uint64_t ticks() const;
  /// Input of every tick, one after the other: `each(const TickRecord&)`, which gives false to end.
  template <class Each>
  void play(Each&& each) const {
    for (std::size_t n = 0; n < strokes.size(); ++n) {
      Random random(seed ^ (n + 1) * 0x9e3779b97f4a7c15ULL);
      for (int k = 0; k < strokes[n].ticks; ++k)
        if (!each(tick_of(strokes[n], k, random))) return;
    }
  }

 private:
  static TickRecord tick_of(const Stroke& stroke, int k, Random& random);
};

/// What a random trial is to be like.
struct TrialPlan {
  int ticks = 4000;  ///< About that many.
  int strokes = 24;
  /// Hands that are no numbers, beyond reach, or hold no tool, and times that are none.
  bool nonsense = true;
  int least_sectors = 16;  ///< Up to 72.
  /// Numbers of the scene at the ends of their ranges, or anywhere within.
  bool ends = true;
};

/// Scene and hands drawn from `seed`: any grid of some thousand elements, any effects, numbers at
/// the ends of their ranges, every tool, and hands that go anywhere. The same seed gives the same
/// trial everywhere. Allocates.
Trial random_trial(std::uint64_t seed, const TrialPlan& plan = {});
/// The hands alone, in a scene that is given.
Trial random_hands(const SceneDef& def, std::uint64_t seed, const TrialPlan& plan = {});

/// The same seen in a mirror: z is -z, and the wheel turns the other way.
Hands mirrored(Hands hands);

/// One line: grid, effects, tools, strokes, ticks.
std::string words_of(const Trial& trial);

/// What `onggi replay` opens: the trial's first `ticks` ticks (at least one), with a hash a
/// simulated second. Runs it. Empty where the scene is none.
std::vector<std::byte> replay_of(const Trial& trial, std::uint64_t ticks);

}  // namespace onggi::lab
