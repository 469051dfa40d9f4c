#include "kiosk/visit/sound/outline_song.h"

#include <algorithm>
#include <cmath>

namespace onggi::sound {

namespace {
constexpr double kLoud = 0.2, kOctave = 0.35;
constexpr double kWidest = 1.5;    // of the vessel's largest radius
constexpr double kFadeOut = 0.02;  // s of a note's end
}  // namespace

double pitch_of_width(double radius, double largest) {
  const double share = largest > 0 ? std::clamp(radius / largest, 0.0, kWidest) : 0.0;
  return OutlineSong::kHighest * std::exp2(-OutlineSong::kOctaves * share);
}

OutlineSong outline_song(std::span<const double> vessel, std::span<const double> pot) {
  OutlineSong song;
  const double largest = vessel.empty() ? 0.0 : *std::max_element(vessel.begin(), vessel.end());
  for (std::size_t n = 0; n < song.vessel.size(); ++n) {
    song.vessel[n] = pitch_of_width(n < vessel.size() ? vessel[n] : 0.0, largest);
    song.pot[n] = pitch_of_width(n < pot.size() ? pot[n] : 0.0, largest);
  }
  return song;
}

void OutlineVoice::sing(const OutlineSong& song) noexcept {
  song_ = song;
  step_ = 0;
  at_ = 0.0;
}

double OutlineVoice::next() noexcept {
  bool sounds = false, second = false;
  double hz = 0.0;
  if (singing()) {
    const auto n = static_cast<std::size_t>(step_);
    second = at_ >= OutlineSong::kNote;
    const double in_note = second ? at_ - OutlineSong::kNote : at_;
    sounds = in_note < OutlineSong::kNote - kFadeOut;
    hz = second ? song_.pot[n] : song_.vessel[n];
    at_ += 1.0 / kRate;
    if (at_ >= 2 * OutlineSong::kNote + OutlineSong::kBetween) {
      at_ = 0.0;
      ++step_;
    }
  }
  const double loud = loud_.to(sounds ? kLoud : 0.0);
  const double bright = bright_.to(second ? kOctave : 0.0);
  if (loud == 0.0) return 0.0;
  if (hz > 0.0) last_ = hz;
  return loud * (ground_.next(last_) + bright * octave_.next(2.0 * last_)) / (1.0 + kOctave);
}

}  // namespace onggi::sound
