#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "engine/base/plain_text.h"
#include "kiosk/collection/settings/scene_file.h"
#include "kiosk/exhibit/tuning/machine.h"
#include "kiosk/exhibit/tuning/scene_writer.h"
#include "kiosk/exhibit/tuning/tuner.h"
#include "kiosk/picture/drawing/put_report.h"
#include "kiosk/program/commands/commands.h"

namespace onggi::commands {

namespace {

struct TuneArguments {
  std::string scene, write;
  files::Output json{files::Output::Kind::json};
};

files::Json json_of(const tuning::TunedGrid& grid) {
  return files::Json::object({{"machine", tuning::machine_name()},
                              {"rows", grid.rows},
                              {"sectors", grid.sectors},
                              {"shape_mm_rms", grid.shape_mm},
                              {"shape_mm_max", grid.worst_mm},
                              {"force_pct", grid.force_pct},
                              {"tick_share_pct", grid.tick_pct},
                              {"fine_enough", grid.fine_enough},
                              {"in_time", grid.in_time}});
}

Result<int> tune(const TuneArguments& arguments) {
  const std::filesystem::path file = arguments.write.empty() ? arguments.scene : arguments.write;
  if (file.empty())
    return problem("onggi lab tune", "No scene is named.",
                   "Name one: onggi lab tune --write config/scenes/first_touch.toml.");
  const settings::SceneRead read = settings::read_scene(file);
  if (!read.problems.empty()) return tl::unexpected(read.problems.front());
  const auto grid = tuning::tune(file.stem().string(), read.def);
  if (!grid) return tl::unexpected(grid.error());
  if (!arguments.write.empty()) {
    char note[160];
    std::snprintf(note, sizeof note, "%.80s: %.3f mm off at most (rms), %.0f %% of a tick",
                  tuning::machine_name().c_str(), grid->shape_mm, grid->tick_pct);
    if (const auto done = tuning::write_grid(file, grid->rows, grid->sectors, note); !done)
      return tl::unexpected(done.error());
  }
  const auto put = drawing::put_report(json_of(*grid), arguments.json);
  if (!put) return tl::unexpected(put.error());
  if (*put)
    std::printf("%s: %s\n", terminal::plain(file.string()).c_str(),
                tuning::words_of(*grid).c_str());
  return grid->in_time ? 0 : 1;
}

}  // namespace

cli::Command tune_command() {
  const auto a = std::make_shared<TuneArguments>();
  return {.name = "tune",
          .help = "Find the finest grid that a scene can use on this machine",
          .examples =
              "Example: onggi lab tune --write config/scenes/first_touch.toml\n"
              "The printed figures include a margin. Exit: 1 if every grid is too slow.\n"
              "quality = \"auto\" in a scene does the same at the first start on a machine.",
          .options = {{.name = "--scene",
                       .field = &a->scene,
                       .help = "The scene's TOML; it is not changed",
                       .excludes = "--write"},
                      {"--write", &a->write, "The scene's TOML; the grid is written into it"},
                      {"--json", &a->json, "Write the figures as JSON (- for standard output)"}},
          .run = [a] { return tune(*a); }};
}

}  // namespace onggi::commands
