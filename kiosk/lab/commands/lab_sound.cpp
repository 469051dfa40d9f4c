#include <cstdio>
#include <memory>

#include "kiosk/lab/commands/lab_commands.h"
#include "kiosk/lab/measure/studio_film.h"
#include "kiosk/lab/measure/touch_to_sound.h"
#include "kiosk/picture/drawing/put_report.h"
#include "kiosk/picture/drawing/spectrogram.h"

namespace onggi::laboratory {

namespace {

struct SoundArguments {
  files::Output json{files::Output::Kind::json}, wav{files::Output::Kind::wav},
      plot{files::Output::Kind::picture};
  measure::TouchToSoundPlan plan;
};

Result<int> sound(const SoundArguments& arguments) {
  if (arguments.wav.wanted() || arguments.plot.wanted()) {
    const measure::StudioFilm film = measure::studio_film();
    if (auto good = arguments.wav.write(measure::wav_of(film)); !good)
      return tl::unexpected(good.error());
    if (arguments.plot.wanted())
      if (auto good = arguments.plot.write(
              drawing::draw_spectrogram(measure::spectrogram_of(film), arguments.plot.where()));
          !good)
        return tl::unexpected(good.error());
    // Listening needs no measurement, so skip it.
    if (!arguments.json.wanted()) return 0;
  }
  const auto heard = measure::touch_to_sound(arguments.plan, stderr);
  if (!heard) return tl::unexpected(heard.error());
  const auto put = drawing::put_report(measure::json_of(*heard), arguments.json);
  if (!put) return tl::unexpected(put.error());
  if (*put) std::fputs(measure::text_of(*heard).c_str(), stdout);
  return 0;
}

}  // namespace

cli::Command lab_sound_command() {
  const auto a = std::make_shared<SoundArguments>();
  return {.name = "sound",
          .help = "Measure how soon a touch is heard, or record and draw the studio's sounds",
          .examples =
              "Example: onggi lab sound --seconds 3600 --json sound.json\n"
              "         onggi lab sound --wav studio.wav --plot studio.png\n"
              "It times a touch from the clay to the sound card. With --wav or --plot nothing is "
              "timed,\nunless --json asks for it. SDL_AUDIODRIVER=dummy works without a card.",
          .options = {{.name = "--seconds",
                       .field = &a->plan.seconds,
                       .help = "Seconds of touches [60]",
                       .least = 1.0,
                       .most = 86400.0},
                      {"--seed", &a->plan.seed, "Seed of the touches [1]"},
                      {"--json", &a->json, "Write the figures as JSON (- for standard output)"},
                      {"--wav", &a->wav, "Write 17 s of all sounds into this WAV"},
                      {"--plot", &a->plot, "Draw them into this PNG or SVG: pitch over time"}},
          .run = [a] { return sound(*a); }};
}

}  // namespace onggi::laboratory
