#include <cstdio>
#include <memory>
#include <string>
#include <utility>

#include "kiosk/ground/files/local_time.h"
#include "kiosk/ground/files/read_file.h"
#include "kiosk/ground/files/wall_clock.h"
#include "kiosk/lab/commands/lab_commands.h"
#include "kiosk/lab/measure/accuracy_picture.h"
#include "kiosk/lab/measure/accuracy_report.h"
#include "kiosk/picture/drawing/put_report.h"

namespace onggi::laboratory {

namespace {

struct AccuracyArguments {
  measure::AccuracyPlan plan;
  files::Output json{files::Output::Kind::json};
  files::Output csv{files::Output::Kind::csv};
  files::Output plot{files::Output::Kind::picture};
  std::string commit, again;
};

constexpr std::size_t kLargestTable = 64u << 20;

/// The picture of an earlier run's table.
Result<int> draw_again(const AccuracyArguments& arguments) {
  if (!arguments.plot.wanted() || arguments.json.wanted() || arguments.csv.wanted())
    return problem("--again", "It draws the picture of a table, and nothing else.",
                   "Say --plot FILE, and neither --csv nor --json.");
  const auto bytes = files::read_file(arguments.again, kLargestTable);
  if (!bytes) return problem(arguments.again, "It could not be read.", "Name a table of --csv.");
  auto before = measure::report_of_csv({bytes->begin(), bytes->end()}, arguments.again);
  if (!before) return tl::unexpected(before.error());
  const auto report = measure::report_again(std::move(*before), stderr);
  const auto drawn = plots::draw_accuracy(measure::chart_of(report), arguments.plot.where());
  return arguments.plot.write(drawn).map([] { return 0; });
}

Result<int> accuracy(const AccuracyArguments& arguments) {
  if (!arguments.again.empty()) return draw_again(arguments);
  auto report = measure::measure_accuracy(arguments.plan, stderr);
  if (!report) return tl::unexpected(report.error());
  report->command = arguments.plan.quick ? "onggi lab accuracy --quick" : "onggi lab accuracy";
  report->made = files::local_time(files::wall_now(), files::kDay) +
                 (arguments.commit.empty() ? "" : ", commit " + arguments.commit);
  const auto put = drawing::put_report(measure::json_of(*report), arguments.json);
  if (!put) return tl::unexpected(put.error());
  if (*put && !arguments.csv.to_stdout() && !arguments.plot.to_stdout())
    std::fputs(measure::text_of(*report).c_str(), stdout);
  if (const auto kept = arguments.csv.write(measure::csv_of(*report)); !kept)
    return tl::unexpected(kept.error());
  if (!arguments.plot.wanted()) return 0;
  const auto drawn = plots::draw_accuracy(measure::chart_of(*report), arguments.plot.where());
  return arguments.plot.write(drawn).map([] { return 0; });
}

}  // namespace

cli::Command accuracy_command() {
  const auto a = std::make_shared<AccuracyArguments>();
  return {
      .name = "accuracy",
      .help = "Measure what accuracy costs in time here, and which setting to choose",
      .examples =
          "Example: onggi lab accuracy --quick --plot accuracy.png\n"
          "         onggi lab accuracy --json accuracy.json --csv accuracy.csv\n"
          "Shape in mm, force in N and volume in %, against a reference in doubles; "
          "time is the thread's own.\n"
          "Of throwing, of a ring of coil as it is laid, and of a wall that is beaten.",
      .options = {{"--quick", &a->plan.quick, "Fewer combinations: a minute or so"},
                  {"--json", &a->json,
                   "Write everything as JSON (- for standard output, here and below)"},
                  {"--csv", &a->csv, "Write the rows as CSV"},
                  {"--plot", &a->plot, "Draw the picture into this PNG or SVG"},
                  {"--commit", &a->commit, "The commit of this build, for the table and picture"},
                  {"--again", &a->again, "Draw --plot of this CSV, and measure nothing"},
                  {"--seed", &a->plan.seed, "Seed of the random hands that try to break it [1]"}},
      .run = [a] { return accuracy(*a); }};
}

}  // namespace onggi::laboratory
