#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace onggi::pages {

/// A spectrogram: time across, pitch up, and the loudness of each pitch at each moment.
struct Spectrogram {
  std::string title{}, subtitle{};
  std::span<const float> samples{};  ///< -1..1, one channel.
  double rate = 48000.0;             ///< Samples a second.
  struct Part {
    double begin = 0.0;  ///< s
    std::string name{};  ///< Above the picture, from `begin` on.
  };
  std::vector<Part> parts{};       ///< Sorted by time.
  int width = 1600, height = 900;  ///< Pixels.
};

/// The picture's bytes: an SVG where the name of `file` ends in ".svg", else a PNG. Pitches from 30
/// Hz to 12 kHz by equal intervals, each heard through a Hann window of 43 ms; loudness from -90 dB
/// (paper) to -20 dB of full scale (ink). Allocates; any thread.
std::vector<std::byte> draw_spectrogram(const Spectrogram& sound, const std::string& file);

}  // namespace onggi::pages
