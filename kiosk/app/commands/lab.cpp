#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "kiosk/app/commands/commands.h"
#include "kiosk/app/effect_prices.h"
#include "kiosk/app/log.h"
#include "kiosk/app/paths.h"
#include "kiosk/drawing/plot.h"
#include "kiosk/files/durable_file.h"
#include "kiosk/files/helper_process.h"
#include "kiosk/settings/scene_file.h"

namespace onggi::app {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kPasses = 3;
constexpr double kCountedWithin_s = 1800;  // valgrind is fifty times slower

struct Arguments {
  std::string json, plot, count;
  int rows = 400, sectors = 360;
  bool quick = false;
};

// The list of priced_scenes(), and before its last the presets that lie in config/scenes.
Result<std::vector<PricedScene>> all_scenes(const Arguments& arguments) {
  std::vector<PricedScene> scenes = priced_scenes(arguments.rows, arguments.sectors);
  const auto root = program_root();
  if (!root) return tl::unexpected(root.error());
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(*root / "config/scenes"))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::ranges::sort(files);
  const PricedScene all = std::move(scenes.back());
  scenes.pop_back();
  for (const auto& file : files) {
    settings::SceneRead read = settings::read_scene(file);
    if (!read.problems.empty()) return tl::unexpected(read.problems.front());
    read.def.clay.rows = arguments.rows;
    read.def.clay.sectors = arguments.sectors;
    scenes.push_back({file.filename().string(), std::move(read.def)});
  }
  scenes.push_back(all);
  return scenes;
}

// Instructions of a tick, by this program run again under callgrind; 0 where it counted none.
std::int64_t counted(const Arguments& arguments, const std::string& scene) {
  const auto said = files::run_helper(
      {.program = "valgrind",
       .arguments = {"--tool=callgrind", "--callgrind-out-file=/dev/null", "--log-fd=1",
                     "--toggle-collect=onggi_priced_ticks",
                     std::filesystem::read_symlink("/proc/self/exe").string(), "lab", "effects",
                     "--grid",
                     std::to_string(arguments.rows) + "x" + std::to_string(arguments.sectors),
                     "--count", scene},
       .timeout_s = kCountedWithin_s});
  if (!said) return 0;
  const std::string words(reinterpret_cast<const char*>(said->data()), said->size());
  const std::string_view before = "Collected : ";
  const std::size_t at = words.find(before);
  return at == std::string::npos ? 0
                                 : std::atoll(words.c_str() + at + before.size()) / kPricedTicks;
}

Result<void> plot(const std::vector<EffectPrice>& prices, const Arguments& arguments) {
  drawing::Plot plot;
  plot.title = "What a tick costs";
  plot.subtitle = "on " + std::to_string(arguments.rows) + " × " +
                  std::to_string(arguments.sectors) + ", both hands pulling up a wall";
  plot.y.label = "microseconds";
  using Bars = drawing::PlotSeries;
  plot.series = {Bars{.name = "median", .kind = Bars::Kind::bars},
                 Bars{.name = "99.9 of 100 are quicker", .kind = Bars::Kind::bars}};
  for (const EffectPrice& price : prices) {
    plot.x.names.push_back(price.name);
    plot.series[0].y.push_back(price.median_ns / 1000.0);
    plot.series[1].y.push_back(price.p999_ns / 1000.0);
  }
  return files::write_durably(arguments.plot, drawing::draw_plot(plot, arguments.plot));
}

Json json_of(const std::vector<EffectPrice>& prices, const Arguments& arguments) {
  Json list = Json::array();
  for (const EffectPrice& p : prices) {
    Json one{{"scene", p.name},
             {"median_ns", p.median_ns},
             {"p999_ns", p.p999_ns},
             {"asleep_ns", p.asleep_ns},
             {"bytes", p.bytes}};
    one["instructions"] = p.instructions > 0 ? Json(p.instructions) : Json(nullptr);
    list.push_back(std::move(one));
  }
  return {{"rows", arguments.rows}, {"sectors", arguments.sectors}, {"prices", std::move(list)}};
}

Result<void> effects(const Arguments& arguments) {
  const auto scenes = all_scenes(arguments);
  if (!scenes) return tl::unexpected(scenes.error());
  if (!arguments.count.empty()) {
    for (const PricedScene& scene : *scenes)
      if (scene.name == arguments.count) return play_priced_ticks(scene);
    return problem("--count", "There is no scene of that name.",
                   "Choose one that onggi lab effects lists.");
  }
  const bool count =
      !arguments.quick && files::run_helper({.program = "valgrind", .arguments = {"--version"}});
  std::vector<EffectPrice> prices;
  const bool to_output = arguments.json == "-";
  FILE* table = to_output ? stderr : stdout;
  std::fprintf(table, "A tick on %d x %d, both hands pulling up a wall; asleep: nothing touched.\n",
               arguments.rows, arguments.sectors);
  std::fprintf(table, "%-22s %10s %10s %10s %12s %12s\n", "", "median", "p99.9", "asleep", "bytes",
               count ? "instructions" : "");
  for (const PricedScene& scene : *scenes) {
    auto price = price_of(scene, arguments.quick ? 1 : kPasses);
    if (!price) return tl::unexpected(price.error());
    if (count) price->instructions = counted(arguments, scene.name);
    if (!prices.empty()) price->bytes -= prices.front().bytes;
    std::fprintf(table, "%-22s %7.0f ns %7.0f ns %7.0f ns %12lld", price->name.c_str(),
                 price->median_ns, price->p999_ns, price->asleep_ns,
                 static_cast<long long>(price->bytes));
    if (price->instructions > 0)
      std::fprintf(table, " %12lld", static_cast<long long>(price->instructions));
    std::fprintf(table, "\n");
    std::fflush(table);
    prices.push_back(std::move(*price));
  }
  if (!count)
    std::fprintf(table, "Instructions are not counted: %s.\n",
                 arguments.quick ? "--quick" : "valgrind is not here");
  if (!arguments.json.empty()) {
    const std::string text = json_of(prices, arguments).dump(2) + "\n";
    if (to_output)
      std::fputs(text.c_str(), stdout);
    else if (auto good = files::write_durably(arguments.json, std::as_bytes(std::span(text)));
             !good)
      return good;
  }
  return arguments.plot.empty() ? Result<void>() : plot(prices, arguments);
}

}  // namespace

void add_lab(CLI::App& app, int& exit_code) {
  CLI::App* lab = app.add_subcommand("lab", "Measure the engine on this machine");
  lab->require_subcommand(1);
  lab->footer("Example: onggi lab effects");
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      lab->add_subcommand("effects", "The price list: what each effect and each scene costs");
  command->footer(
      "Example: onggi lab effects --json prices.json --plot prices.png\n"
      "Bytes are those beyond the base scene's. Instructions are of a tick, under valgrind.");
  command->add_option("--json", arguments->json, "Write the list as JSON (- for standard output)");
  command->add_option("--plot", arguments->plot, "Draw it into this PNG or SVG");
  auto grid = std::make_shared<std::string>("400x360");
  command->add_option("--grid", *grid, "ROWSxSECTORS")->capture_default_str();
  command->add_flag("--quick", arguments->quick, "Count no instructions");
  command->add_option("--count", arguments->count, "")->group("");
  command->callback([arguments, grid, &exit_code] {
    char rest = 0;
    if (std::sscanf(grid->c_str(), "%dx%d%c", &arguments->rows, &arguments->sectors, &rest) != 2) {
      exit_code = exit_with({"--grid", "It is not ROWSxSECTORS.", "Write 400x360.", 2});
      return;
    }
    if (auto good = effects(*arguments); !good) exit_code = exit_with(good.error());
  });
}

}  // namespace onggi::app
