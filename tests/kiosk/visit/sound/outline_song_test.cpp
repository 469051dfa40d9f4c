#include "kiosk/visit/sound/outline_song.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "kiosk/visit/sound/synthesis.h"

namespace onggi::sound::outline_song_test {
namespace {

using Radii = std::array<double, OutlineSong::kSteps>;

Radii belly(double widest) {
  Radii r{};
  for (std::size_t n = 0; n < r.size(); ++n)
    r[n] = 0.04 + (widest - 0.04) * std::sin(std::numbers::pi * static_cast<double>(n) / 15.0);
  return r;
}

std::vector<float> heard(const OutlineSong& song) {
  Synthesis synthesis;
  Heard silence;
  silence.volume = 1.0;
  std::vector<float> out(48000);
  synthesis.play(silence, out);  // The volume has come up.
  synthesis.sing(song);
  out.resize(static_cast<std::size_t>((OutlineSong::kSeconds + 0.3) * kRate));
  synthesis.play(silence, out);
  return out;
}

/// Hz between `from` and `to` s, by the lag at which the sound is most like itself
/// (autocorrelation, with a parabola through its peak). Knows nothing of how the sound was made.
double measured(const std::vector<float>& sound, double from, double to) {
  const auto begin = static_cast<std::size_t>(from * kRate),
             end = static_cast<std::size_t>(to * kRate);
  const std::size_t most = 600, window = end - begin - most;
  std::vector<double> like(most + 1);
  for (std::size_t lag = 20; lag <= most; ++lag) {
    double sum = 0, a = 0, b = 0;
    for (std::size_t n = begin; n < begin + window; ++n) {
      sum += double{sound[n]} * sound[n + lag];
      a += double{sound[n]} * sound[n];
      b += double{sound[n + lag]} * sound[n + lag];
    }
    like[lag] = sum / std::sqrt(a * b + 1e-30);
  }
  for (std::size_t lag = 21; lag < most; ++lag) {
    if (like[lag] < 0.97 || like[lag] < like[lag - 1] || like[lag] < like[lag + 1]) continue;
    const double bend = like[lag - 1] - 2 * like[lag] + like[lag + 1];
    const double shift = bend != 0 ? 0.5 * (like[lag - 1] - like[lag + 1]) / bend : 0;
    return kRate / (static_cast<double>(lag) + shift);
  }
  return 0;
}

TEST(OutlineSong, EveryHeightIsHeardAtThePitchOfItsWidthFirstTheVesselThenThePot) {
  const Radii vessel = belly(0.1), pot = belly(0.07);
  const OutlineSong song = outline_song(vessel, pot);
  const auto sound = heard(song);
  const double step = 2 * OutlineSong::kNote + OutlineSong::kBetween;
  for (std::size_t n = 0; n < vessel.size(); ++n)
    for (const bool second : {false, true}) {
      const double begin = static_cast<double>(n) * step + (second ? OutlineSong::kNote : 0.0);
      const double hz = measured(sound, begin + 0.03, begin + OutlineSong::kNote - 0.022);
      const double radius = second ? pot[n] : vessel[n];
      EXPECT_NEAR(hz, 880 * std::pow(2, -2 * radius / 0.1), 0.01 * hz) << n << second;
    }
}

TEST(OutlineSong, WiderIsLowerAndAnEighthOfATenthIsMoreThanEarsNeed) {
  EXPECT_NEAR(pitch_of_width(0.1, 0.1), 220, 1e-9);
  EXPECT_NEAR(pitch_of_width(0.05, 0.1), 440, 1e-9);
  EXPECT_NEAR(pitch_of_width(0.0, 0.1), 880, 1e-9);
  EXPECT_NEAR(pitch_of_width(0.4, 0.1), pitch_of_width(0.15, 0.1), 1e-9)
      << "no lower than a cellar";
  EXPECT_EQ(pitch_of_width(0.1, 0.0), 880);
  // Of 2.5 % of the width: half a semitone.
  EXPECT_GT(12 * std::log2(pitch_of_width(0.1, 0.1) / pitch_of_width(0.1025, 0.1)), 0.5);
}

TEST(OutlineSong, ThePotsNoteHasAnOctaveInItAndTheVesselsHasNone) {
  const Radii same = belly(0.1);
  const auto sound = heard(outline_song(same, same));
  const auto share = [&](double from, double hz) {
    double re = 0, im = 0;
    for (int n = 0; n < 3000; ++n) {
      const double angle = 2 * std::numbers::pi * hz * n / kRate;
      const double x = sound[static_cast<std::size_t>(from * kRate) + static_cast<std::size_t>(n)];
      re += x * std::cos(angle), im += x * std::sin(angle);
    }
    return std::hypot(re, im);
  };
  const double hz = pitch_of_width(same[7], 0.1);
  const double begin = 7 * (2 * OutlineSong::kNote + OutlineSong::kBetween) + 0.03;
  EXPECT_LT(share(begin, 2 * hz), 0.06 * share(begin, hz));
  EXPECT_GT(share(begin + OutlineSong::kNote, 2 * hz),
            0.25 * share(begin + OutlineSong::kNote, hz));
}

TEST(OutlineSong, NoStepOfItIsAClickItIsQuietAndItEnds) {
  const auto sound = heard(outline_song(belly(0.1), belly(0.06)));
  float most = 0, step = 0;
  for (std::size_t n = 1; n < sound.size(); ++n) {
    most = std::max(most, std::abs(sound[n]));
    step = std::max(step, std::abs(sound[n] - sound[n - 1]));
  }
  EXPECT_LT(most, 0.26f);
  EXPECT_GT(most, 0.1f);
  EXPECT_LT(step, 0.04f);
  for (std::size_t n = sound.size() - 4800; n < sound.size(); ++n) ASSERT_EQ(sound[n], 0.0f);
}

TEST(OutlineSong, IsNotHeardByWhoWantsNoSound) {
  Synthesis synthesis;
  synthesis.sing(outline_song(belly(0.1), belly(0.06)));
  std::vector<float> out(48000);
  synthesis.play(Heard{}, out);
  for (const float x : out) ASSERT_EQ(x, 0.0f);
}

}  // namespace
}  // namespace onggi::sound::outline_song_test
