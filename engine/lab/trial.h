#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/math/random.h"
#include "engine/scene/replay.h"

namespace onggi::lab {

/// A stretch of work: each hand goes straight from one place to another.
struct Stroke {
  struct Part {
    HandInput begins;    ///< At the first tick.
    Vec3 ends;           ///< At the last, studio frame, m.
    bool beats = false;  ///< Strikes a blow every kBeat ticks.
  };
  static constexpr int kBeat = 40;
  int ticks = 1;         ///< >= 1
  double dt = 0.001;     ///< Of each tick, s. Any value, also invalid ones.
  bool ragged = false;   ///< Each tick has its own length, above 0 and up to `dt`.
  double tremble = 0.0;  ///< m: how far a hand shakes about its way.
  std::array<Part, kMaxHands> hand{};
  double wheel_speed = 0.0;  ///< rad/s. Any value.
  bool water = false, fire = false, renew = false, restore = false;
};

/// A scene and all input: enough to repeat it to the bit.
struct Trial {
  SceneDef def;
  std::uint64_t seed = 0;
  std::vector<Stroke> strokes;

  std::uint64_t ticks() const;
  /// Calls `each(const TickRecord&)` with the input of every tick; false ends it.
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

/// Options of a random trial.
struct TrialPlan {
  int ticks = 4000;  ///< Approximate.
  int strokes = 24;
  /// Hands that are NaN, out of reach or without a tool, and invalid times.
  bool nonsense = true;
  int least_sectors = 16;  ///< Up to 72.
  /// True: numbers at the ends of their ranges, too; false: anywhere within.
  bool ends = true;
};

/// Scene and hands drawn from `seed`: any grid of some thousand elements, any effects, numbers at
/// the ends of their ranges, every tool, and hands that go anywhere. The same seed gives the same
/// trial everywhere. Allocates.
Trial random_trial(std::uint64_t seed, const TrialPlan& plan = {});
/// The hands alone, for a given scene.
Trial random_hands(const SceneDef& def, std::uint64_t seed, const TrialPlan& plan = {});

/// The mirror image: z becomes -z, and the wheel turns the other way.
Hands mirrored(Hands hands);

/// One line: grid, effects, tools, strokes, ticks.
std::string words_of(const Trial& trial);

/// The trial's first `ticks` ticks (at least one) as a replay for `onggi replay`, with a hash each
/// simulated second. Runs the trial. Empty if the scene is invalid.
std::vector<std::byte> replay_of(const Trial& trial, std::uint64_t ticks);

}  // namespace onggi::lab
