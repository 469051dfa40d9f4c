#include "kiosk/lab/measure/price_list.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string_view>

#include "engine/lab/scene_work.h"
#include "kiosk/ground/files/helper_process.h"
#include "kiosk/lab/measure/scene_presets.h"

namespace onggi::measure {

namespace {

using files::Json;

constexpr double kNoise = 0.1;             // of the base's time: no less on a quiet machine
constexpr double kCountedWithin_s = 1800;  // valgrind is fifty times slower

// Instructions of a tick, from running this program again under callgrind; 0 if it counted none.
std::int64_t counted(int rows, int sectors, const std::string& scene) {
  const auto said = files::run_helper(
      {.program = "valgrind",
       .arguments = {"--tool=callgrind", "--callgrind-out-file=/dev/null", "--log-fd=1",
                     "--toggle-collect=onggi_priced_ticks",
                     std::filesystem::read_symlink("/proc/self/exe").string(), "lab", "effects",
                     "--grid", std::to_string(rows) + "x" + std::to_string(sectors), "--count",
                     scene},
       .timeout_s = kCountedWithin_s});
  if (!said) return 0;
  const std::string words(reinterpret_cast<const char*>(said->data()), said->size());
  const std::string_view before = "Collected : ";
  const std::size_t at = words.find(before);
  return at == std::string::npos ? 0
                                 : std::atoll(words.c_str() + at + before.size()) / kPricedTicks;
}

// Shape and force of one hand on a wall, because a wall that the other hand holds does not move.
Result<lab::SceneOutcome> left_by(const PricedScene& scene, int rows, int sectors) {
  SceneDef def = lab::on_a_wall(scene.def);
  def.guard = {22.0, 1e5, 0.05};  // forces as they are
  lab::SceneWork work = lab::finger_work(scene.name, def, false, 0.0015, true);
  work.def.clay.rows = rows;
  work.def.clay.sectors = sectors;
  return lab::outcome_of(work, 1e-3, rows);
}

Result<void> say_what_changes(const PricedScene& scene, const lab::SceneOutcome& base,
                              const PriceList& list, EffectPrice& price) {
  price.shape = price.shape_max = price.force = std::numeric_limits<double>::quiet_NaN();
  if (scene.def.paper) return {};
  const auto left = left_by(scene, list.rows, list.sectors);
  if (!left) return tl::unexpected(left.error());
  const lab::Apart off = lab::apart(*left, base);
  price.shape = off.shape;
  price.shape_max = off.shape_max;
  price.force = off.force;
  return {};
}

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(); }

}  // namespace

Result<std::vector<PricedScene>> scenes_with_presets(int rows, int sectors) {
  std::vector<PricedScene> scenes = priced_scenes(rows, sectors);
  auto presets = read_presets();
  if (!presets) return tl::unexpected(presets.error());
  const PricedScene all = std::move(scenes.back());
  scenes.pop_back();
  for (ScenePreset& preset : *presets) {
    preset.def.clay.rows = rows;
    preset.def.clay.sectors = sectors;
    scenes.push_back({preset.name + ".toml", std::move(preset.def)});
  }
  scenes.push_back(all);
  return scenes;
}

Result<PriceList> measure_prices(const std::vector<PricedScene>& scenes, int rows, int sectors,
                                 int passes, bool wanted, std::FILE* table) {
  const bool count =
      wanted && files::run_helper({.program = "valgrind", .arguments = {"--version"}});
  PriceList list{rows, sectors, {}};
  if (scenes.empty()) return list;
  const auto base = left_by(scenes.front(), rows, sectors);
  if (!base) return tl::unexpected(base.error());
  std::fprintf(table,
               "A tick on %d x %d, both hands pulling up a wall; asleep: nothing touched.\n"
               "Shape and force: by which what a hand leaves and feels differs from the first "
               "line's (rms).\n",
               rows, sectors);
  std::fprintf(table, "%-22s %10s %10s %10s %12s %10s %9s %12s\n", "", "median", "p99.9", "asleep",
               "bytes", "shape", "force", count ? "instructions" : "");
  for (const PricedScene& scene : scenes) {
    auto price = price_of(scene, passes);
    if (!price) return tl::unexpected(price.error());
    if (const auto said = say_what_changes(scene, *base, list, *price); !said)
      return tl::unexpected(said.error());
    if (count) price->instructions = counted(rows, sectors, scene.name);
    if (!list.prices.empty()) price->bytes -= list.prices.front().bytes;
    std::fprintf(table, "%-22s %7.0f ns %7.0f ns %7.0f ns %12lld", price->name.c_str(),
                 price->median_ns, price->p999_ns, price->asleep_ns,
                 static_cast<long long>(price->bytes));
    if (std::isfinite(price->shape))
      std::fprintf(table, " %7.4f mm %7.4f N", 1e3 * price->shape, price->force);
    else
      std::fprintf(table, " %10s %9s", "no wall", "");
    if (price->instructions > 0)
      std::fprintf(table, " %12lld", static_cast<long long>(price->instructions));
    std::fprintf(table, "\n");
    std::fflush(table);
    list.prices.push_back(std::move(*price));
  }
  std::fprintf(table, "%s", doubt_of(list).c_str());
  if (!count)
    std::fprintf(table, "Instructions are not counted: %s.\n",
                 wanted ? "valgrind is not here" : "--quick");
  return list;
}

std::string doubt_of(const PriceList& list) {
  for (const EffectPrice& price : list.prices) {
    const double base = list.prices.front().median_ns;
    if (!price.name.starts_with("+ ") || price.median_ns >= (1.0 - kNoise) * base) continue;
    char words[240];
    std::snprintf(words, sizeof words,
                  "Do not believe these times: \"%s\" took %.0f ns and no effect at all %.0f ns.\n"
                  "Something else kept this machine busy. Measure again when nothing else runs. "
                  "Instructions, bytes, shape and force hold.\n",
                  price.name.c_str(), price.median_ns, base);
    return words;
  }
  return {};
}

files::Json json_of(const PriceList& list) {
  Json prices = Json::list();
  for (const EffectPrice& p : list.prices)
    prices.push_back(
        Json::object({{"scene", p.name},
                      {"median_ns", p.median_ns},
                      {"p999_ns", p.p999_ns},
                      {"asleep_ns", p.asleep_ns},
                      {"bytes", p.bytes},
                      {"shape_mm_rms", finite(1e3 * p.shape)},
                      {"shape_mm_max", finite(1e3 * p.shape_max)},
                      {"force_n_rms", finite(p.force)},
                      {"instructions", p.instructions > 0 ? Json(p.instructions) : Json()}}));
  return Json::object({{"rows", list.rows},
                       {"sectors", list.sectors},
                       {"times_hold", doubt_of(list).empty()},
                       {"prices", prices}});
}

drawing::Plot plot_of(const PriceList& list) {
  drawing::Plot plot;
  plot.title = "What a tick costs";
  plot.subtitle = "on " + std::to_string(list.rows) + " × " + std::to_string(list.sectors) +
                  ", both hands pulling up a wall";
  plot.y.label = "microseconds";
  using Bars = drawing::PlotSeries;
  plot.series = {Bars{.name = "median", .kind = Bars::Kind::bars},
                 Bars{.name = "99.9 of 100 are quicker", .kind = Bars::Kind::bars}};
  for (const EffectPrice& price : list.prices) {
    plot.x.names.push_back(price.name);
    plot.series[0].y.push_back(price.median_ns / 1000.0);
    plot.series[1].y.push_back(price.p999_ns / 1000.0);
  }
  return plot;
}

}  // namespace onggi::measure
