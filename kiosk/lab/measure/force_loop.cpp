#include "kiosk/lab/measure/force_loop.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <span>
#include <utility>

#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/monotonic.h"
#include "kiosk/ground/files/read_file.h"
#include "kiosk/lab/measure/price_list.h"
#include "kiosk/wheel/device/device_file.h"

namespace onggi::measure {

namespace {

using lab::LoopRow;
using lab::LoopWall;

constexpr const char* kKey = "stiffness_limit";

__attribute__((format(printf, 1, 2))) std::string words(const char* format, ...) {
  char text[400];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return text;
}

bool holds(const DeviceLoops& device) {
  const lab::StiffnessLimit& limit = device.limit;
  bool good = limit.at_margin && limit.margin() >= 0.999 * lab::kLoopMargin &&
              limit.swing < lab::LoopResult::kMostSwing && limit.force_step < lab::kQuietStep;
  for (const LoopRow& row : device.rows)
    if (row.wall == LoopWall::rendered)
      good = good && row.rests && row.margin() >= 0.999 * lab::kLoopMargin;
  return good;
}

/// The smallest value over a device's hands.
double least(const DeviceLoops& device, LoopWall wall, double LoopRow::*which) {
  double most = lab::kStiffestCoupling;
  for (const LoopRow& row : device.rows)
    if (row.wall == wall) most = std::min(most, row.*which);
  return most;
}

std::string stiffness(double value) {
  if (value >= lab::kStiffestCoupling) return "any";
  return value > 0.0 ? words("%.0f", value) : "none";
}

/// Number of a device's hands in which a wall does not come to rest.
int howling(const DeviceLoops& device, LoopWall wall) {
  return static_cast<int>(std::ranges::count_if(
      device.rows, [&](const LoopRow& row) { return row.wall == wall && !row.rests; }));
}

files::Json json_of_device(const lab::DeviceModel& device) {
  return files::Json::object({{"mass_kg", device.mass},
                              {"damping_ns_m", device.damping},
                              {"friction_n", device.friction},
                              {"step_mm", 1e3 * device.step},
                              {"delay_ticks", device.delay}});
}

lab::DeviceModel model_of(const device::DeviceDef& def) {
  return {def.body.mass, def.own_damping(), def.body.friction, def.body.step, def.body.delay};
}

/// `text` with the limit's line renewed, or inserted below [force].
std::string with_limit(const std::string& text, const std::string& line) {
  std::string out;
  bool in_force = false, put = false;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
    const std::string one = text.substr(at, end - at);
    at = end;
    const std::size_t begins = one.find_first_not_of(" \t");
    const std::string bare = begins == std::string::npos ? "" : one.substr(begins);
    if (bare.rfind("[", 0) == 0) in_force = bare.rfind("[force]", 0) == 0;
    if (in_force && bare.rfind(kKey, 0) == 0) continue;  // the old line
    out += one;
    if (out.back() != '\n') out += '\n';
    if (!put && in_force && bare.rfind("[force]", 0) == 0) {
      out += line;
      put = true;
    }
  }
  if (!put) out += "\n[force]\n" + line;
  return out;
}

}  // namespace

bool ForceLoopReport::good() const {
  const auto rests = [](const ScenesLoops& scene) {
    return std::ranges::all_of(scene.loops, &lab::SceneLoop::rests);
  };
  return !devices.empty() && std::ranges::all_of(devices, holds) &&
         std::ranges::all_of(scenes, rests);
}

Result<ForceLoopReport> measure_force_loop(std::FILE* progress) {
  ForceLoopReport report;
  const auto scenes = scenes_with_presets(96, 96);
  if (!scenes) return tl::unexpected(scenes.error());
  const std::vector<lab::DeviceModel> list = lab::device_list();
  const double begun = files::monotonic_seconds();
  const std::size_t steps = list.size() + scenes->size();
  std::size_t done = 0;
  const auto tell = [&] {
    ++done;
    if (progress == nullptr) return;
    const double took = files::monotonic_seconds() - begun;
    std::fprintf(progress, "\r%zu of %zu, %.0f s to go ", done, steps,
                 took / static_cast<double>(done) * static_cast<double>(steps - done));
    std::fflush(progress);
  };
  for (const lab::DeviceModel& device : list) {
    DeviceLoops loops{device, lab::derive_stiffness_limit(device), {}};
    loops.rows = lab::sweep_device(device, loops.limit);
    report.devices.push_back(std::move(loops));
    tell();
  }
  // The weakest device, and the best.
  for (const PricedScene& scene : *scenes) {
    for (const DeviceLoops& device : {report.devices.front(), report.devices.back()})
      report.scenes.push_back({scene.name, device.device,
                               lab::try_scene(scene.def, device.device, device.limit.allowed)});
    tell();
  }
  report.seconds = files::monotonic_seconds() - begun;
  if (progress != nullptr) std::fprintf(progress, "\n");
  return report;
}

files::Json json_of(const ForceLoopReport& report) {
  files::Json devices = files::Json::list(), scenes = files::Json::list();
  for (const DeviceLoops& one : report.devices) {
    files::Json rows = files::Json::list();
    for (const LoopRow& row : one.rows)
      rows.push_back(
          files::Json::object({{"hand", row.hand},
                               {"wall", lab::name_of(row.wall)},
                               {"given_n_m", row.given},
                               {"stable_n_m", row.stable},
                               {"passive_n_m", row.passive},
                               {"eigenvalues_n_m", row.eigenvalues},
                               {"colgate_n_m", row.colgate},
                               {"margin", row.margin()},
                               {"rests", row.rests},
                               {"swing_mm", std::isfinite(row.swing) ? 1e3 * row.swing : 1e6},
                               {"force_step_n", row.force_step}}));
    files::Json device = json_of_device(one.device);
    device["allowed_n_m"] = one.limit.allowed;
    device["stable_n_m"] = one.limit.stable;
    device["passive_n_m"] = one.limit.passive;
    device["colgate_n_m"] = one.limit.colgate;
    device["quiet_n_m"] = one.limit.quiet;
    device["margin"] = one.limit.margin();
    device["swing_mm"] = 1e3 * one.limit.swing;
    device["force_step_n"] = one.limit.force_step;
    device["good"] = holds(one);
    device["loops"] = std::move(rows);
    devices.push_back(std::move(device));
  }
  for (const ScenesLoops& one : report.scenes) {
    files::Json loops = files::Json::list();
    for (const lab::SceneLoop& loop : one.loops)
      loops.push_back(files::Json::object({{"hand", loop.hand},
                                           {"turning", loop.turning},
                                           {"rests", loop.rests},
                                           {"swing_mm", 1e3 * loop.swing},
                                           {"force_step_n", loop.force_step}}));
    files::Json scene = json_of_device(one.device);
    scene["scene"] = one.scene;
    scene["loops"] = std::move(loops);
    scenes.push_back(std::move(scene));
  }
  return files::Json::object({{"good", report.good()},
                              {"seconds", report.seconds},
                              {"devices", std::move(devices)},
                              {"scenes", std::move(scenes)}});
}

std::string text_of(const ForceLoopReport& report) {
  std::string text =
      "N/m, the least of three hands; 45 g, an encoder of 0.055 mm. Colgate: b / (T / 2 + delay)\n"
      "   b  friction delay |   a spring            | 10 Hz of  | a scene's | through the "
      "coupling\n"
      " N s/m   N    ticks  | stable passive Colgate| the paper | own force | allowed stable "
      "passive "
      " swing mm  step N\n";
  for (const DeviceLoops& one : report.devices) {
    const auto& d = one.device;
    const int paper = howling(one, LoopWall::filtered_engine);
    const int own = howling(one, LoopWall::engine);
    text += words("%5.1f  %5.2f %5d    | %6s %6s %7.0f | %s | %s | %7.1f %6s %7s  %8.4f %7.4f%s\n",
                  d.damping, d.friction, d.delay,
                  stiffness(least(one, LoopWall::spring, &LoopRow::stable)).c_str(),
                  stiffness(least(one, LoopWall::spring, &LoopRow::passive)).c_str(),
                  one.limit.colgate, paper > 0 ? "UNSTABLE " : "stable   ",
                  own > 0 ? "UNSTABLE " : "stable   ", one.limit.allowed,
                  stiffness(one.limit.stable).c_str(), stiffness(one.limit.passive).c_str(),
                  1e3 * one.limit.swing, one.limit.force_step, holds(one) ? "" : "  NOT GOOD");
  }
  std::size_t loops = 0, still = 0;
  for (const ScenesLoops& scene : report.scenes)
    for (const lab::SceneLoop& loop : scene.loops) {
      ++loops;
      still += loop.rests ? 1 : 0;
      if (!loop.rests)
        text += words("%s, %s hand, %s: does not come to rest (%.3f mm)\n", scene.scene.c_str(),
                      loop.hand, loop.turning ? "turning" : "still", 1e3 * loop.swing);
    }
  text +=
      words("Scenes on the least and the best of these devices: %zu of %zu loops come to rest.\n",
            still, loops);
  text +=
      report.good()
          ? "What ships is stable and passive on every device in every hand, with 1.5 to spare.\n"
          : "What ships is NOT stable and passive on every device: see above.\n";
  return text;
}

drawing::Plot plot_of(const ForceLoopReport& report) {
  drawing::Plot plot;
  plot.title = "How stiff a wall a device bears at 1 kHz";
  plot.subtitle =
      "onggi lab loop: 45 g, no friction, an encoder of 0.055 mm; the least of three hands. Above "
      "a line of "
      "its colour a spring gives energy";
  plot.x.label = "ticks from a place to its force";
  plot.x.low = -0.2;
  plot.x.high = 3.2;
  plot.y.label = "stiffness, N/m";
  plot.y.log = true;
  std::vector<double> dampings;
  for (const DeviceLoops& one : report.devices)
    if (std::ranges::find(dampings, one.device.damping) == dampings.end())
      dampings.push_back(one.device.damping);
  drawing::PlotSeries filtered;
  filtered.name = "stable behind the paper's 10 Hz";
  filtered.kind = drawing::PlotSeries::Kind::points;
  // Colours that colour-blind readers can distinguish.
  constexpr view::Color kColors[] = {
      {0.835F, 0.369F, 0.0F}, {0.0F, 0.447F, 0.698F}, {0.0F, 0.62F, 0.451F}};
  std::size_t at = 0;
  for (const double damping : dampings) {
    drawing::PlotSeries passive, allowed;
    passive.color = allowed.color = kColors[at++ % std::size(kColors)];
    passive.name = words("passive, %.1f N s/m", damping);
    passive.dashed = true;
    allowed.name = words("what is given, %.1f N s/m", damping);
    allowed.kind = drawing::PlotSeries::Kind::line_and_points;
    for (const DeviceLoops& one : report.devices) {
      if (one.device.damping != damping || one.device.friction > 0.0) continue;
      const double delay = one.device.delay;
      for (auto* series : {&passive, &allowed, &filtered}) series->x.push_back(delay);
      passive.y.push_back(one.limit.colgate);
      allowed.y.push_back(one.limit.allowed);
      filtered.y.push_back(least(one, LoopWall::filtered_spring, &LoopRow::stable));
    }
    plot.series.push_back(passive);
    plot.series.push_back(allowed);
  }
  plot.series.push_back(filtered);
  if (!report.devices.empty()) {
    double head = 0.0;
    for (const LoopRow& row : report.devices.front().rows)
      if (row.wall == LoopWall::engine) head = row.given;
    drawing::PlotSeries hard;
    hard.name = "the wheel head under 0.5 N";
    hard.color = view::Color{0.45F, 0.45F, 0.45F};
    hard.x = {0.0, 3.0};
    hard.y = {head, head};
    plot.series.push_back(hard);
  }
  return plot;
}

Result<lab::StiffnessLimit> write_stiffness_limit(const std::filesystem::path& file) {
  const auto kinds = device::device_kinds();
  const auto kind = std::ranges::find_if(
      kinds, [&](const device::KindInfo& info) { return info.id == file.stem().string(); });
  if (kind == kinds.end() || !kind->force)
    return problem(file.string(), "Its name is not that of a force device.",
                   "Name config/devices/onggi_hid.toml or config/devices/polhem.toml.");
  const auto bytes = files::read_file(file, std::size_t{1} << 20);
  if (!bytes)
    return problem(file.string(), "It cannot be read. " + bytes.error().reason,
                   "Name a file of config/devices.");
  const device::DeviceRead read = device::read_device(file, device::default_def(kind->kind));
  // Ignore a wrong limit, because this command replaces it.
  for (const Problem& one : read.problems)
    if (one.what.find(kKey) == std::string::npos) return tl::unexpected(one);
  const lab::StiffnessLimit limit = lab::derive_stiffness_limit(model_of(read.def));
  if (!(limit.allowed >= lab::kSoftestCoupling))
    return problem(
        file.string(),
        words("A device with this [body] can render only %.1f N/m, too little to feel.",
              limit.allowed),
        "Give it more damping, or a shorter way to the wire, and measure its [body] again.");
  const std::string text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
  const std::string made = with_limit(
      text, words("%s = %-12.1f # N/m, derived from [body] by onggi lab loop --write; run it again "
                  "when that changes\n",
                  kKey, std::floor(10.0 * limit.allowed) / 10.0));
  const auto kept = files::write_durably(file, std::as_bytes(std::span(made)));
  if (!kept) return tl::unexpected(kept.error());
  return limit;
}

}  // namespace onggi::measure
