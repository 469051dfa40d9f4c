#include <cstdio>
#include <memory>

#include "kiosk/lab/commands/lab_commands.h"
#include "kiosk/lab/measure/touch_to_sound.h"
#include "kiosk/picture/drawing/put_report.h"

namespace onggi::laboratory {

namespace {

struct SoundArguments {
  files::Output json{files::Output::Kind::json};
  measure::TouchToSoundPlan plan;
};

Result<int> sound(const SoundArguments& arguments) {
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
          .help = "Measure how soon a touch is heard",
          .examples =
              "Example: onggi lab sound --seconds 3600 --json sound.json\n"
              "It times a touch from the clay to the sound card. SDL_AUDIODRIVER=dummy works "
              "without a card.",
          .options = {{.name = "--seconds",
                       .field = &a->plan.seconds,
                       .help = "Seconds of touches [60]",
                       .least = 1.0,
                       .most = 86400.0},
                      {"--seed", &a->plan.seed, "Seed of the touches [1]"},
                      {"--json", &a->json, "Write the figures as JSON (- for standard output)"}},
          .run = [a] { return sound(*a); }};
}

}  // namespace onggi::laboratory
