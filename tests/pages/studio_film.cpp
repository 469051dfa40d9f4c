#include "tests/pages/studio_film.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "kiosk/ground/files/byte_writer.h"
#include "kiosk/visit/sound/synthesis.h"

namespace onggi::pages {

namespace {

using sound::Heard;
using sound::Rub;

constexpr double kTurn = 6.283185307179586;

struct StudioScene {
  const char* name;
  double seconds;
  double rpm;
  Rub rub;
  double wet, fire;
};

constexpr StudioScene kScenes[] = {
    {"wheel", 2.0, 172, {}, 0.0, 0.0},
    {"a light hand", 2.0, 172, {Rub::Kind::hand, 0.4, 0.5}, 0.0, 0.0},
    {"a firm one", 2.0, 172, {Rub::Kind::hand, 1.0, 3.0}, 0.0, 0.0},
    {"wet", 1.5, 172, {Rub::Kind::hand, 1.0, 3.0}, 1.0, 0.0},
    {"sponge", 1.5, 172, {Rub::Kind::sponge, 0.8, 2.0}, 1.0, 0.0},
    {"rib", 1.5, 172, {Rub::Kind::rib, 0.8, 2.0}, 0.3, 0.0},
    {"wire", 1.5, 60, {Rub::Kind::wire, 0.3, 2.0}, 0.3, 0.0},
    {"rest", 1.0, 0, {}, 0.0, 0.0},
    {"kiln", 4.0, 0, {}, 0.0, 1.0}};

}  // namespace

StudioFilm studio_film() {
  StudioFilm film;
  sound::Synthesis synthesis;
  for (const StudioScene& scene : kScenes) {
    film.parts.push_back({static_cast<double>(film.samples.size()) / sound::kRate, scene.name});
    Heard heard;
    heard.wheel = scene.rpm * kTurn / 60.0;
    heard.wet = scene.wet;
    heard.rub[0] = scene.rub;
    heard.fire = scene.fire;
    heard.volume = 1.0;
    const std::size_t from = film.samples.size();
    film.samples.resize(from + static_cast<std::size_t>(scene.seconds * sound::kRate));
    synthesis.play(heard, std::span(film.samples).subspan(from));
  }
  return film;
}

std::vector<std::byte> wav_of(const StudioFilm& film) {
  const auto rate = static_cast<std::uint32_t>(sound::kRate);
  const auto size = static_cast<std::uint32_t>(2 * film.samples.size());
  files::ByteWriter out(44 + size);
  out.text("RIFF");
  out.u32(36 + size);
  out.text("WAVEfmt ");
  out.u32(16);
  out.u16(1);  // PCM
  out.u16(1);  // channels
  out.u32(rate);
  out.u32(2 * rate);
  out.u16(2);   // bytes a sample
  out.u16(16);  // bits
  out.text("data");
  out.u32(size);
  for (const float x : film.samples)
    out.u16(static_cast<std::uint16_t>(
        static_cast<std::int16_t>(std::lround(32767.0f * std::clamp(x, -1.0f, 1.0f)))));
  return out.take();
}

Spectrogram spectrogram_of(const StudioFilm& film) {
  return {.title = "What the studio sounds like",
          .subtitle =
              "onggi_page_sound --plot FILE: at full volume, 48 kHz, the same samples on every "
              "machine. "
              "Loudness from -90 dB of full scale (paper) to -20 dB (ink).",
          .samples = film.samples,
          .rate = sound::kRate,
          .parts = film.parts};
}

}  // namespace onggi::pages
