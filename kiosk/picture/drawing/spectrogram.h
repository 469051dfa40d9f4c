#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace onggi::drawing {

/// A sound as it is looked at: time across, pitch up, and how loud each pitch is at each moment.
struct Spectrogram {
  std::string title{}, subtitle{};
  std::span<const float> samples{};  ///< -1..1, one channel.
  double rate = 48000.0;             ///< Samples a second.
  struct Part {
    double begin = 0.0;  ///< s
    std::string name{};  ///< Over the picture, from there on.
  };
  std::vector<Part> parts{};       ///< In order of time.
  int width = 1600, height = 900;  ///< Pixels.
};

/// The picture's bytes: an SVG where the name of `file` ends in ".svg", else a PNG. Pitches from 30
/// Hz to 12 kHz by equal intervals, each heard through a Hann window of 43 ms; loudness from -90 dB
/// (paper) to -20 dB of full scale (ink). Allocates; any thread.
std::vector<std::byte> draw_spectrogram(const Spectrogram& sound, const std::string& file);

}  // namespace onggi::drawing
