#include "tests/pages/studio_film.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "kiosk/visit/sound/voice.h"

namespace onggi::pages {
namespace {

double loudness(const StudioFilm& film, std::size_t part) {
  const auto at = [&](std::size_t n) {
    return n < film.parts.size() ? static_cast<std::size_t>(film.parts[n].begin * sound::kRate)
                                 : film.samples.size();
  };
  double sum = 0.0;
  // Its first half glides from what was before.
  const std::size_t from = (at(part) + at(part + 1)) / 2, to = at(part + 1);
  for (std::size_t n = from; n < to; ++n) sum += double{film.samples[n]} * film.samples[n];
  return std::sqrt(sum / static_cast<double>(to - from));
}

TEST(StudioFilm, HasEveryPartAndRestWhereThereIsRest) {
  const StudioFilm film = studio_film();
  ASSERT_EQ(film.parts.size(), 9u);
  for (std::size_t n = 0; n < film.parts.size(); ++n) {
    if (film.parts[n].name == "rest")
      EXPECT_LT(loudness(film, n), 1e-4);
    else
      EXPECT_GT(loudness(film, n), 5e-3) << film.parts[n].name;
    EXPECT_LT(loudness(film, n), 0.4) << film.parts[n].name << ": a quiet studio";
  }
}

TEST(StudioFilm, IsAWavFileOfItsSamples) {
  const StudioFilm film = studio_film();
  const std::vector<std::byte> wav = wav_of(film);
  ASSERT_EQ(wav.size(), 44 + 2 * film.samples.size());
  EXPECT_EQ(std::memcmp(wav.data(), "RIFF", 4), 0);
  EXPECT_EQ(std::memcmp(wav.data() + 8, "WAVEfmt ", 8), 0);
  std::uint32_t rate = 0, size = 0;
  std::memcpy(&rate, wav.data() + 24, 4);
  std::memcpy(&size, wav.data() + 40, 4);
  EXPECT_EQ(rate, 48000u);
  EXPECT_EQ(size, 2 * film.samples.size());
  for (const std::size_t n : {std::size_t{0}, std::size_t{200'000}, film.samples.size() - 1}) {
    std::int16_t sample = 0;
    std::memcpy(&sample, wav.data() + 44 + 2 * n, 2);
    EXPECT_NEAR(sample / 32767.0, film.samples[n], 2e-5) << n;
  }
}

}  // namespace
}  // namespace onggi::pages
