#include <cstdio>
#include <ctime>
#include <memory>
#include <span>
#include <string>

#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/lab/commands/lab_commands.h"
#include "kiosk/lab/measure/scene_page.h"

namespace onggi::laboratory {

namespace {

struct ScenesArguments {
  std::string config, out, commit;
  int seeds = 2;
  int threads = 1;
};

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[16];
  return {text, std::strftime(text, sizeof text, "%Y-%m-%d", &utc)};
}

Result<int> scenes(const ScenesArguments& arguments) {
  const auto config = files::exhibit_file(arguments.config);
  if (!config) return tl::unexpected(config.error());
  measure::NaivePlan plan;
  plan.exhibit_file = config->string();
  plan.seeds = arguments.seeds;
  plan.threads = arguments.threads;
  plan.moments = {90};
  const auto entries = measure::measure_scenes(plan, stderr);
  if (!entries) return tl::unexpected(entries.error());
  const std::string page = measure::page_of(
      *entries,
      {"onggi lab scenes --seeds " + std::to_string(arguments.seeds), today(), arguments.commit});
  if (arguments.out.empty()) {
    std::fputs(page.c_str(), stdout);
    return 0;
  }
  return files::write_durably(arguments.out, std::as_bytes(std::span(page))).map([] { return 0; });
}

}  // namespace

cli::Command lab_scenes_command() {
  const auto a = std::make_shared<ScenesArguments>();
  return {.name = "scenes",
          .help = "Write the curators' page: what each scene simulates, costs and gives",
          .examples =
              "Example: onggi lab scenes --commit $(git rev-parse --short HEAD) -o scenes.md\n"
              "Naive hands for 90 s and the script's hand throw the whole shelf in each.",
          .options = {{.name = "--seeds",
                       .field = &a->seeds,
                       .help = "Naive visits for each vessel [2]",
                       .least = 1,
                       .most = 1000},
                      {.name = "--threads",
                       .field = &a->threads,
                       .help = "Visits at a time [1]",
                       .least = 1,
                       .most = 256},
                      {"--commit", &a->commit, "The commit of this build, for the page"},
                      {"-o", &a->out, "Write the page there [standard output]"},
                      {"--config", &a->config, "The exhibit with the shelf to throw"}},
          .run = [a] { return scenes(*a); }};
}

}  // namespace onggi::laboratory
