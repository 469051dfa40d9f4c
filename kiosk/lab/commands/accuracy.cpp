#include <cstdio>
#include <memory>
#include <string>

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
};

Result<int> accuracy(const AccuracyArguments& arguments) {
  auto report = measure::measure_accuracy(arguments.plan, stderr);
  if (!report) return tl::unexpected(report.error());
  report->command = arguments.plan.quick ? "onggi lab accuracy --quick" : "onggi lab accuracy";
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
          "time is the thread's own.",
      .options = {{"--quick", &a->plan.quick, "Fewer combinations: a minute or so"},
                  {"--json", &a->json,
                   "Write everything as JSON (- for standard output, here and below)"},
                  {"--csv", &a->csv, "Write the rows as CSV"},
                  {"--plot", &a->plot, "Draw the picture into this PNG or SVG"},
                  {"--seed", &a->plan.seed, "Seed of the random hands that try to break it [1]"}},
      .run = [a] { return accuracy(*a); }};
}

}  // namespace onggi::laboratory
