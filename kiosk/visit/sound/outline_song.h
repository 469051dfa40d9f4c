#pragma once

#include <array>
#include <span>

#include "kiosk/visit/sound/voice.h"

namespace onggi::sound {

/// Two outlines to be heard: from the foot to the rim, at each height first how wide the vessel is
/// and then how wide the pot is, the wider the lower.
struct OutlineSong {
  static constexpr int kSteps = 16;
  static constexpr double kNote = 0.12, kBetween = 0.06;  ///< s of a note, and after two of them
  static constexpr double kHighest = 880.0;               ///< Hz of no width at all,
  static constexpr double kOctaves = 2.0;  ///< and so much lower at the vessel's widest.
  static constexpr double kSeconds = kSteps * (2 * kNote + kBetween);

  std::array<double, kSteps> vessel{}, pot{};  ///< Hz.
};

/// Hz of a radius, where the vessel's largest is `largest`, both m; at most half as wide again.
double pitch_of_width(double radius, double largest);
/// Radii at kSteps heights, from the foot to the rim, m.
OutlineSong outline_song(std::span<const double> vessel, std::span<const double> pot);

/// Sings it, once; a second one is begun at once. The vessel's note is a plain tone, the pot's has
/// an octave in it, so that nobody takes one for the other. No allocation, no lock.
class OutlineVoice {
 public:
  void sing(const OutlineSong& song) noexcept;
  bool singing() const noexcept { return step_ < OutlineSong::kSteps; }
  /// The next sample, -0.25..0.25; 0 when it is over.
  double next() noexcept;

 private:
  OutlineSong song_;
  int step_ = OutlineSong::kSteps;
  double at_ = 0.0;    ///< s in the step.
  double last_ = 440;  ///< Hz of the note that sounds, or fades.
  Tone ground_, octave_;
  Glide loud_{0.004}, bright_{0.004};
};

}  // namespace onggi::sound
