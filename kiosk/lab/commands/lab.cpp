#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "engine/base/plain_text.h"
#include "kiosk/collection/settings/scene_file.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/ground/files/replay_file.h"
#include "kiosk/lab/commands/lab_commands.h"
#include "kiosk/lab/measure/bill_plot.h"
#include "kiosk/lab/measure/loop_timing.h"
#include "kiosk/lab/measure/price_list.h"
#include "kiosk/lab/measure/stability.h"
#include "kiosk/picture/drawing/put_report.h"

namespace onggi::laboratory {

namespace {

constexpr int kPasses = 3;

struct LabArguments {
  files::Output json{files::Output::Kind::json};
  files::Output plot{files::Output::Kind::picture};
  std::string count, bill, grid = "400x360";
  bool quick = false;
};

Result<int> bill(const LabArguments& arguments) {
  const settings::SceneRead read = settings::read_scene(arguments.bill);
  if (!read.problems.empty()) return tl::unexpected(read.problems.front());
  auto paid = tuning::bill_of(std::filesystem::path(arguments.bill).stem().string(), read.def,
                              arguments.quick ? 1 : kPasses);
  if (!paid) return tl::unexpected(paid.error());
  paid->command = "onggi lab effects --bill " + arguments.bill;
  const auto put = drawing::put_report(tuning::json_of(*paid), arguments.json);
  if (!put) return tl::unexpected(put.error());
  if (*put && !arguments.plot.to_stdout()) std::fputs(tuning::text_of(*paid).c_str(), stdout);
  if (!arguments.plot.wanted()) return 0;
  return arguments.plot.write(plots::draw_bill(measure::sheet_of(*paid), arguments.plot.where()))
      .map([] { return 0; });
}

Result<int> effects(const LabArguments& arguments) {
  if (!arguments.bill.empty()) return bill(arguments);
  int rows = 0, sectors = 0;
  char rest = 0;
  if (std::sscanf(arguments.grid.c_str(), "%dx%d%c", &rows, &sectors, &rest) != 2)
    return problem("--grid", "It is not ROWSxSECTORS.", "Write 400x360.");
  const auto scenes = measure::scenes_with_presets(rows, sectors);
  if (!scenes) return tl::unexpected(scenes.error());
  if (!arguments.count.empty()) {
    for (const measure::PricedScene& scene : *scenes)
      if (scene.name == arguments.count)
        return measure::play_priced_ticks(scene).map([] { return 0; });
    return problem("--count", "There is no scene of that name.",
                   "Choose one that onggi lab effects lists.");
  }
  const bool taken = arguments.json.to_stdout() || arguments.plot.to_stdout();
  const auto list = measure::measure_prices(*scenes, rows, sectors, arguments.quick ? 1 : kPasses,
                                            !arguments.quick, taken ? stderr : stdout);
  if (!list) return tl::unexpected(list.error());
  if (const auto put = drawing::put_report(measure::json_of(*list), arguments.json); !put)
    return tl::unexpected(put.error());
  if (!arguments.plot.wanted()) return 0;
  return arguments.plot.write(drawing::draw_plot(measure::plot_of(*list), arguments.plot.where()))
      .map([] { return 0; });
}

cli::Command effects_command() {
  const auto a = std::make_shared<LabArguments>();
  return {.name = "effects",
          .help = "List what each effect and each scene costs",
          .examples =
              "Example: onggi lab effects --json prices.json --plot prices.png\n"
              "         onggi lab effects --bill config/scenes/studio.toml --plot bill.png\n"
              "Bytes are beyond the base scene's. Instructions are per tick, under "
              "valgrind.\n"
              "A bill shows what each effect of a scene costs and what it does.",
          .options = {{"--json", &a->json, "Write the list as JSON (- for standard output)"},
                      {"--plot", &a->plot, "Draw it into this PNG or SVG"},
                      {.name = "--grid",
                       .field = &a->grid,
                       .help = "ROWSxSECTORS",
                       .shows_default = true,
                       .excludes = "--bill"},
                      {"--bill", &a->bill, "Only this scene's TOML: with each effect, and without"},
                      {"--quick", &a->quick, "Count no instructions, and time once"},
                      {.name = "--count", .field = &a->count, .help = "", .hidden = true}},
          .run = [a] { return effects(*a); }};
}

struct StabilityArguments {
  measure::StabilityPlan plan;
  std::string out = plan.folder.string(), check;
  int trial = -1;
  files::Output json{files::Output::Kind::json};
};

Result<int> stability(StabilityArguments& arguments) {
  if (!arguments.check.empty()) {
    const auto replay = files::read_replay(arguments.check);
    if (!replay) return tl::unexpected(replay.error());
    const auto said = measure::check_replay(*replay);
    if (!said) return tl::unexpected(said.error());
    std::printf("%s: %s\n", terminal::plain(arguments.check).c_str(), said->c_str());
    return 0;
  }
  arguments.plan.folder = arguments.out;
  const auto tally =
      arguments.trial < 0
          ? measure::measure_stability(arguments.plan, stderr)
          : measure::measure_trial(arguments.plan, static_cast<std::uint64_t>(arguments.trial));
  if (!tally) return tl::unexpected(tally.error());
  const auto free = drawing::put_report(measure::json_of(*tally), arguments.json);
  if (!free) return tl::unexpected(free.error());
  if (*free) {
    std::printf("stability: seed %llu, %llu trials, %llu ticks, %zu found%s\n",
                static_cast<unsigned long long>(tally->seed),
                static_cast<unsigned long long>(tally->trials),
                static_cast<unsigned long long>(tally->ticks), tally->finds.size(),
                tally->interrupted ? "; interrupted: run it again to continue" : "");
    for (const measure::StabilityFind& find : tally->finds)
      std::printf("  trial %llu, %s: %s\n    %s\n", static_cast<unsigned long long>(find.trial),
                  find.invariant.c_str(), find.what.c_str(), find.replay.c_str());
  }
  return tally->finds.empty() ? 0 : 1;
}

cli::Command stability_command() {
  const auto a = std::make_shared<StabilityArguments>();
  return {
      .name = "stability",
      .help = "Run random hands in random scenes for a night, and check every tick",
      .examples =
          "Example: onggi lab stability --ticks 1e9 --json night.json\n"
          "         onggi lab stability --ticks 1e7 --seed 7 --threads 1\n"
          "         onggi lab stability --seed 7 --trial 1234\n"
          "         onggi lab stability --check keepsakes/stability/7_1234.onggi\n"
          "If it is interrupted, run it again with the same seed to continue.",
      .options = {{.name = "--ticks",
                   .field = &a->plan.ticks,
                   .help = "Ticks to run in all [1e9]",
                   .least = 1,
                   .most = 1e15,
                   .excludes = "--check"},
                  {.name = "--seed",
                   .field = &a->plan.seed,
                   .help = "Seed of the trials [1]",
                   .excludes = "--check"},
                  {.name = "--threads",
                   .field = &a->plan.threads,
                   .help = "Threads; 0 means one per core [0]",
                   .least = 0,
                   .most = 256,
                   .excludes = "--check"},
                  {.name = "--trial",
                   .field = &a->trial,
                   .help = "Run only this trial of the seed, by its number, and keep no progress",
                   .least = 0,
                   .excludes = "--check"},
                  {.name = "--out",
                   .field = &a->out,
                   .help = "Folder for progress and replays [keepsakes/stability]",
                   .excludes = "--check"},
                  {.name = "--json",
                   .field = &a->json,
                   .help = "Write the result as JSON (- for standard output)",
                   .excludes = "--check"},
                  {"--check", &a->check, "Only check every tick of this replay"}},
      .run = [a] { return stability(*a); }};
}

struct TimingArguments {
  files::Output json{files::Output::Kind::json};
  files::Output plot{files::Output::Kind::picture};
  std::string config;
  double seconds = 101.0;
};

Result<int> timing(const TimingArguments& arguments) {
  const auto config = files::exhibit_file(arguments.config);
  if (!config) return tl::unexpected(config.error());
  const auto report = measure::measure_loop(*config, arguments.seconds);
  if (!report) return tl::unexpected(report.error());
  return drawing::put_report(measure::json_of(*report), measure::text_of(*report),
                             measure::plot_of(*report), arguments.json, arguments.plot)
      .map([&report] { return report->fit ? 0 : 1; });
}

cli::Command timing_command() {
  const auto a = std::make_shared<TimingArguments>();
  return {.name = "timing",
          .help = "Measure how well the 1 kHz loop keeps time, alone and while drawing",
          .examples =
              "Example: onggi lab timing --json timing.json --plot timing.svg\n"
              "Exit: 0 fit for force feedback, 1 not fit; the text says what to change.",
          .options = {{.name = "--seconds",
                       .field = &a->seconds,
                       .help = "Seconds for each of the two; 101 or more for the tail [101]",
                       .least = 1.0,
                       .most = 3600.0},
                      {"--json", &a->json, "Write the figures as JSON (- for standard output)"},
                      {"--plot", &a->plot, "Draw them into this PNG or SVG"},
                      {"--config", &a->config, "The exhibit's TOML [config/exhibit.toml]"}},
          .run = [a] { return timing(*a); }};
}

}  // namespace

cli::Command lab_command() {
  return {
      .name = "onggi-lab",
      .help = "Onggi's laboratory: measure accuracy, effects and hard cases on this machine.",
      .examples =
          "Example: onggi lab accuracy\n         onggi lab effects\n         onggi lab stability "
          "--ticks 1e7\n"
          "         onggi lab witness\n         onggi lab timing\n         onggi lab loop\n"
          "         onggi lab frames\n"
          "         onggi lab sound\n         onggi lab access\n         onggi lab soak --minutes "
          "10\n"
          "onggi lab X starts onggi-lab X. onggi lab tune belongs to onggi itself.",
      .commands = {accuracy_command(), effects_command(), stability_command(), timing_command(),
                   lab_loop_command(), lab_frames_command(), lab_scenes_command(),
                   lab_sound_command(), lab_access_command(), lab_witness_command(),
                   soak_command()}};
}

}  // namespace onggi::laboratory
