#include <iostream>
#include <memory>
#include <string>

#include "engine/base/plain_text.h"
#include "kiosk/exhibit/rehearsal/visit_report.h"
#include "kiosk/ground/files/replay_file.h"
#include "kiosk/picture/drawing/put_report.h"
#include "kiosk/program/commands/commands.h"

namespace onggi::commands {

namespace {

Result<int> replay(const std::string& name, const files::Output& json_file) {
  const auto read = files::read_replay(name);
  if (!read) return tl::unexpected(read.error());
  const auto outcome = run_replay(*read);
  if (!outcome) return tl::unexpected(outcome.error());

  const bool same =
      outcome->first_difference_tick < 0 && outcome->recorded_hash == outcome->replayed_hash;
  const auto free = drawing::put_report(
      files::Json::object({{"file", name},
                           {"vessel", outcome->vessel_id},
                           {"glaze", outcome->glaze},
                           {"seed", outcome->seed},
                           {"ticks", outcome->ticks},
                           {"state_hash", rehearsal::hash_text(outcome->replayed_hash)},
                           {"recorded_hash", rehearsal::hash_text(outcome->recorded_hash)},
                           {"hashes_checked", outcome->hashes_checked},
                           {"first_difference_tick", outcome->first_difference_tick},
                           {"earlier_laws", outcome->earlier_laws},
                           {"same", same}}),
      json_file);
  if (!free) return tl::unexpected(free.error());
  if (*free)
    std::cout << terminal::plain(name) << ": " << outcome->ticks << " ticks of "
              << terminal::plain(outcome->vessel_id) << ", "
              << (outcome->glaze.empty() ? "" : "glaze " + terminal::plain(outcome->glaze) + ", ")
              << (same ? "the same pot, bit for bit (" : "a different pot from the recorded one (")
              << rehearsal::hash_text(outcome->replayed_hash) << ")\n";
  if (!same && outcome->earlier_laws)
    std::cerr << terminal::plain(name)
              << ": This visit was recorded when clay sagged and soaked by other laws, so the same "
                 "hands now make a slightly different pot; the keepsake shows the pot as it was.\n";
  else if (!same && outcome->first_difference_tick >= 0)
    std::cerr << terminal::plain(name) << ": first different at tick "
              << outcome->first_difference_tick << "\n";
  return same ? 0 : 1;
}

}  // namespace

cli::Command replay_command() {
  struct Arguments {
    std::string file;
    files::Output json{files::Output::Kind::json};
  };
  const auto a = std::make_shared<Arguments>();
  return {
      .name = "replay",
      .help = "Throw a recorded pot again and compare it bit for bit",
      .examples = "Example: onggi replay keepsakes/2026-05-04_141503_moon_jar/visit.onggi --json -",
      .options = {{.name = "file", .field = &a->file, .help = "A visit.onggi", .required = true},
                  {"--json", &a->json, "Write the result as JSON (- for standard output)"}},
      .run = [a] { return replay(a->file, a->json); }};
}

}  // namespace onggi::commands
