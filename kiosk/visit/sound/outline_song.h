#pragma once

#include <array>
#include <span>

#include "kiosk/visit/sound/voice.h"

namespace onggi::sound {

/// Plays two outlines from the foot to the rim: at each height first the vessel's width, then the
/// pot's. Wider is lower.
struct OutlineSong {
  static constexpr int kSteps = 16;
  static constexpr double kNote = 0.12, kBetween = 0.06;  ///< s of a note, and after each pair
  static constexpr double kHighest = 880.0;               ///< Hz for no width,
  static constexpr double kOctaves = 2.0;  ///< and this many octaves lower at the vessel's widest.
  static constexpr double kSeconds = kSteps * (2 * kNote + kBetween);

  std::array<double, kSteps> vessel{}, pot{};  ///< Hz.
};

/// Hz for a radius, if the vessel's largest is `largest`, both m. Radii are limited to 1.5 times
/// `largest`.
double pitch_of_width(double radius, double largest);
/// Radii at kSteps heights, from the foot to the rim, m.
OutlineSong outline_song(std::span<const double> vessel, std::span<const double> pot);

/// Plays it once; a second song starts at once. The vessel's note is a plain tone and the pot's
/// contains an octave, so that they cannot be confused. No allocation, no lock.
class OutlineVoice {
 public:
  void sing(const OutlineSong& song) noexcept;
  bool singing() const noexcept { return step_ < OutlineSong::kSteps; }
  /// The next sample, -0.25..0.25; 0 after the end.
  double next() noexcept;

 private:
  OutlineSong song_;
  int step_ = OutlineSong::kSteps;
  double at_ = 0.0;    ///< s in the step.
  double last_ = 440;  ///< Hz of the current or fading note.
  Tone ground_, octave_;
  Glide loud_{0.004}, bright_{0.004};
};

}  // namespace onggi::sound
