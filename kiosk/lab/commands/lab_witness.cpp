#include <cstdio>
#include <memory>

#include "kiosk/lab/commands/lab_commands.h"
#include "kiosk/lab/measure/witness_report.h"
#include "kiosk/picture/drawing/put_report.h"

namespace onggi::laboratory {

namespace {

struct WitnessArguments {
  measure::WitnessPlan plan;
  files::Output json{files::Output::Kind::json};
};

Result<int> witness(const WitnessArguments& arguments) {
  const auto report = measure::measure_witnesses(arguments.plan, stderr);
  if (!report) return tl::unexpected(report.error());
  const auto put = drawing::put_report(measure::json_of(*report), arguments.json);
  if (!put) return tl::unexpected(put.error());
  if (*put) std::fputs(measure::text_of(*report).c_str(), stdout);
  return report->failed() == 0 ? 0 : 1;
}

}  // namespace

cli::Command lab_witness_command() {
  const auto a = std::make_shared<WitnessArguments>();
  return {.name = "witness",
          .help = "Compare each law of the clay with a witness that is not the engine",
          .examples =
              "Example: onggi lab witness\n"
              "         onggi lab witness --only rim\n"
              "         onggi lab witness --only walls --json walls.json\n"
              "         onggi lab witness --alter 0.05\n"
              "Exit: 0 if all hold, 1 if one does not. With --alter they should not.",
          .options = {{"--only", &a->plan.only,
                       "Only laws with this in their name, or a family: contact, effects, walls, "
                       "force, clay"},
                      {.name = "--alter",
                       .field = &a->plan.altered,
                       .help = "Alter the engine's side of each law by this share [0]",
                       .least = 0.0,
                       .most = 0.2},
                      {"--json", &a->json, "Write the rows as JSON (- for standard output)"}},
          .run = [a] { return witness(*a); }};
}

}  // namespace onggi::laboratory
