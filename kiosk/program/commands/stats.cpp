#include <memory>

#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/keepsake/store/figures_report.h"
#include "kiosk/keepsake/store/statistics.h"
#include "kiosk/picture/drawing/put_report.h"
#include "kiosk/program/commands/commands.h"
#include "kiosk/program/desk/published.h"

namespace onggi::commands {

namespace {

struct StatsArguments {
  std::string config, store, from, to;
  files::Output csv{files::Output::Kind::csv}, json{files::Output::Kind::json},
      plot{files::Output::Kind::picture};
};

Result<void> check_day(const std::string& option, const std::string& day) {
  if (desk::is_day(day)) return {};
  return problem(option + " " + day, "This is not a valid date.", "Write it as 2026-05-31.");
}

Result<std::string> store_of(const StatsArguments& arguments) {
  if (!arguments.store.empty()) return arguments.store;
  const auto config = files::exhibit_file(arguments.config);
  if (!config) return tl::unexpected(config.error());
  return files::store_file(settings::read_exhibit(*config).exhibit.keepsake.folder).string();
}

Result<int> stats(const StatsArguments& arguments) {
  if (auto good = check_day("--from", arguments.from); !good) return tl::unexpected(good.error());
  if (auto good = check_day("--to", arguments.to); !good) return tl::unexpected(good.error());
  if (!arguments.to.empty() && arguments.to < arguments.from)
    return problem("--from " + arguments.from + " --to " + arguments.to,
                   "The last day is before the first.", "Swap them.");
  const auto file = store_of(arguments);
  if (!file) return tl::unexpected(file.error());
  const auto counted = store::read_statistics(*file, arguments.from, arguments.to);
  if (!counted) return tl::unexpected(counted.error());
  const store::AnonymisedStatistics told = store::publish(*counted);
  // Write files before printing, so that an error comes first.
  if (auto good = arguments.csv.write(store::csv_of(told)); !good)
    return tl::unexpected(good.error());
  const std::string words =
      arguments.csv.wanted() && arguments.csv.to_stdout() ? std::string() : store::words_of(told);
  const auto put = drawing::put_report(store::json_of(told), words, desk::plot_of(told),
                                       arguments.json, arguments.plot);
  if (!put) return tl::unexpected(put.error());
  return 0;
}

}  // namespace

cli::Command stats_command() {
  const auto a = std::make_shared<StatsArguments>();
  return {
      .name = "stats",
      .help = "Show what visitors did: how many, how long, which vessels, where they left",
      .examples =
          "Example: onggi stats --from 2026-05-01 --to 2026-05-31 --csv may.csv --plot may.svg\n"
          "Counts below five are not shown: kiosk/docs/store.md says why.",
      .options = {{"--from", &a->from, "First day to count, as 2026-05-01 [all]"},
                  {"--to", &a->to, "Last day to count [all]"},
                  {"--csv", &a->csv, "Write the tables as CSV (- for standard output)"},
                  {"--json", &a->json, "Write everything as JSON (- for standard output)"},
                  {"--plot", &a->plot,
                   "Draw visits per day or month, as PNG or SVG (- for standard output)"},
                  {.name = "--store",
                   .field = &a->store,
                   .help = "Use this store instead of the exhibit's",
                   .excludes = "--config"},
                  {"--config", &a->config, "The exhibit's TOML [config/exhibit.toml]"}},
      .run = [a] { return stats(*a); }};
}

}  // namespace onggi::commands
