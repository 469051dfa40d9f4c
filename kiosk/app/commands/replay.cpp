#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "kiosk/app/commands/commands.h"
#include "kiosk/app/log.h"
#include "kiosk/app/replay_file.h"
#include "kiosk/app/visit_report.h"
#include "kiosk/files/durable_file.h"

namespace onggi::app {

namespace {

Result<int> replay(const std::string& name, const std::string& json_file) {
  const auto read = read_replay(name);
  if (!read) return tl::unexpected(read.error());
  const auto outcome = run_replay(*read);
  if (!outcome) return tl::unexpected(outcome.error());

  const bool same =
      outcome->first_difference_tick < 0 && outcome->recorded_hash == outcome->replayed_hash;
  nlohmann::ordered_json report;
  report["file"] = name;
  report["vessel"] = outcome->vessel_id;
  report["glaze"] = outcome->glaze;
  report["seed"] = outcome->seed;
  report["ticks"] = outcome->ticks;
  report["state_hash"] = hash_text(outcome->replayed_hash);
  report["recorded_hash"] = hash_text(outcome->recorded_hash);
  report["hashes_checked"] = outcome->hashes_checked;
  report["first_difference_tick"] = outcome->first_difference_tick;
  report["same"] = same;
  const std::string text =
      report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
  if (json_file == "-") {
    std::cout << text;
  } else {
    if (!json_file.empty())
      if (auto good = files::write_durably(json_file, std::as_bytes(std::span(text))); !good)
        return tl::unexpected(good.error());
    std::cout << name << ": " << outcome->ticks << " ticks of " << outcome->vessel_id << ", "
              << (outcome->glaze.empty() ? "" : "glaze " + outcome->glaze + ", ")
              << (same ? "the same pot, bit for bit (" : "another pot than was recorded (")
              << hash_text(outcome->replayed_hash) << ")\n";
  }
  if (!same && outcome->first_difference_tick >= 0)
    std::cerr << name << ": first different at tick " << outcome->first_difference_tick << "\n";
  return same ? 0 : 1;
}

}  // namespace

void add_replay(CLI::App& app, int& exit_code) {
  struct Arguments {
    std::string file, json;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      app.add_subcommand("replay", "Throw a recorded pot again and compare it bit for bit");
  command->footer(
      "Example: onggi replay keepsakes/2026-05-04_141503_moon_jar/visit.onggi --json -");
  command->add_option("file", arguments->file, "A visit.onggi")->required();
  command->add_option("--json", arguments->json,
                      "Write what it came to as JSON (- for standard output)");
  command->callback([arguments, &exit_code] {
    const auto code = replay(arguments->file, arguments->json);
    exit_code = code ? *code : exit_with(code.error());
  });
}

}  // namespace onggi::app
