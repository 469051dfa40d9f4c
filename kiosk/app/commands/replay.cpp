#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "engine/scene/replay.h"
#include "kiosk/app/commands/commands.h"
#include "kiosk/app/log.h"
#include "kiosk/app/visit_report.h"
#include "kiosk/souvenir/durable_file.h"

namespace fs = std::filesystem;

namespace onggi::app {

namespace {

constexpr std::uintmax_t kLargest = 1u << 30;  // Over ten hours of restless hands.

Result<std::vector<char>> read_file(const std::string& name) {
  std::error_code error;
  if (!fs::is_regular_file(name, error))
    return problem(name, "There is no such file.", "Name a visit.onggi that a visit left.");
  if (fs::file_size(name, error) > kLargest)
    return problem(name, "It is over 1 GiB, larger than any visit.", "Name a visit.onggi.");
  std::ifstream file(name, std::ios::binary);
  std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  if (file.bad())
    return problem(name, "It could not be read.", "Check its permissions and disk.", 1);
  return bytes;
}

Result<int> replay(const std::string& name, const std::string& json_file) {
  const auto bytes = read_file(name);
  if (!bytes) return tl::unexpected(bytes.error());
  const auto read = Replay::read(std::as_bytes(std::span(*bytes)), name);
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
      if (auto good = souvenir::write_durably(json_file, std::as_bytes(std::span(text))); !good)
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
