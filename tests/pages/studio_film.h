#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tests/pages/spectrogram.h"

namespace onggi::pages {

/// Seventeen seconds of all sounds of the studio in sequence, to listen to and to look at.
struct StudioFilm {
  std::vector<float> samples;  ///< One channel, sound::kRate a second.
  std::vector<Spectrogram::Part> parts;
};
/// The same samples on every machine. Allocates.
StudioFilm studio_film();
/// As a WAV file of 16 bits.
std::vector<std::byte> wav_of(const StudioFilm& film);
Spectrogram spectrogram_of(const StudioFilm& film);

}  // namespace onggi::pages
