#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "engine/math/random.h"
#include "kiosk/exhibit/rehearsal/decorating_hand.h"

namespace onggi::rehearsal {

/// Somebody who never held a brush, at the screen where a pot is decorated: random places, taps,
/// wavering and far too quick strokes, strokes that leave the pot, now and then *Undo*. The seed
/// says who it is: one taps, one scribbles, one uses one tool, one uses all of them in their order,
/// one mixes. Deterministic in the seed. Main thread.
class NaiveDecorator {
 public:
  enum class Who { taps, scribbles, one_tool, all_tools, mixes };

  /// `seconds`: when they have enough, 5 to 600.
  NaiveDecorator(std::uint64_t seed, double seconds);

  Who who() const { return who_; }
  /// Once a frame; `now`: s, on the visit's clock.
  DecoratingHand::Act step(double now, const decorating::DecoratedPot& pot,
                           const view::Camera& camera);
  bool done() const { return done_; }

 private:
  /// The next tool, colour, figure or number; empty: they are content with what they have.
  std::string choice(const decorating::DecoratedPot& pot);
  void begin_stroke(double now, const decorating::DecoratedPot& pot, const view::Camera& camera);

  Random random_;
  Who who_;
  double seconds_, begun_ = -1.0, last_ = 0.0;
  bool done_ = false;
  int only_ = -1, strokes_ = 0;  ///< The one tool; strokes with the held one.
  double free_at_ = 0.0;         ///< They look on until then.
  // The stroke under way: pixels, and pixels a second.
  double until_ = -1.0;
  std::pair<double, double> at_{}, speed_{};
  double bend_ = 0.0, shake_ = 0.0;  ///< rad/s, px
  bool down_ = false;
};

}  // namespace onggi::rehearsal
