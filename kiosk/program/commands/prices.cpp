#include <sched.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "engine/base/plain_text.h"
#include "kiosk/collection/settings/scene_file.h"
#include "kiosk/exhibit/tuning/scene_bill.h"
#include "kiosk/picture/drawing/put_report.h"
#include "kiosk/program/commands/commands.h"

namespace onggi::commands {

namespace {

constexpr int kPasses = 8;  // seconds on the finest shipped scene

struct PricesArguments {
  std::string scene;
  bool idle = false;
  files::Output json{files::Output::Kind::json};
};

Result<int> prices(const PricesArguments& arguments) {
  if (arguments.idle) {
    // Times are the thread's own, so that waiting does not count.
    const sched_param none{};
    ::sched_setscheduler(0, SCHED_IDLE, &none);
  }
  const settings::SceneRead read = settings::read_scene(arguments.scene);
  if (!read.problems.empty()) return tl::unexpected(read.problems.front());
  auto bill =
      tuning::bill_of(terminal::plain(std::filesystem::path(arguments.scene).stem().string()),
                      read.def, kPasses, true);
  if (!bill) return tl::unexpected(bill.error());
  bill->command = "onggi lab prices " + arguments.scene;
  const auto put = drawing::put_report(tuning::json_of(*bill), arguments.json);
  if (!put) return tl::unexpected(put.error());
  if (*put) std::cout << tuning::text_of(*bill);
  return 0;
}

}  // namespace

cli::Command prices_command() {
  const auto a = std::make_shared<PricesArguments>();
  return {.name = "prices",
          .help = "Tell what each effect of a scene costs on this machine, and what others would",
          .examples =
              "Example: onggi lab prices config/scenes/studio.toml\n"
              "Shape and force: by how much a pot, and what the hand feels, would be another.",
          .options =
              {{.name = "scene", .field = &a->scene, .help = "The scene's TOML", .required = true},
               {"--json", &a->json, "Write the figures as JSON (- for standard output)"},
               {.name = "--idle",
                .field = &a->idle,
                .help = "Only while nothing else wants the processor",
                .hidden = true}},
          .run = [a] { return prices(*a); }};
}

}  // namespace onggi::commands
