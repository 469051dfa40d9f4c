// The data of figure 7: how long one tick takes on the paper's four grids, at distances of the tool
// from the axis, for both models. Each tick's time is the least of several runs of the same visit,
// so that it is the model's and not the machine's other work.
// usage: onggi_figure_times OUT.csv [--quick]
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "engine/scene/scene.h"

namespace {

struct Grid {
  int rows, sectors;
};
constexpr Grid kGrids[] = {{200, 180}, {200, 360}, {400, 360}, {800, 360}};  // section 5
constexpr double kDistances[] = {0.002, 0.003, 0.004, 0.006, 0.008, 0.012,
                                 0.016, 0.024, 0.032, 0.048, 0.060};  // m
constexpr double kWithin = 0.014;      // nearer the axis the tool works from inside
constexpr double kPress = 0.002;       // m that the surface lies within the sphere's reach
constexpr double kWheel = 6.28318530;  // rad/s, 60 rpm
constexpr double kRise = 0.00008;      // m a tick

#ifdef __clang__
constexpr const char* kCompiler = __VERSION__;
#else
constexpr const char* kCompiler = "g++ " __VERSION__;
#endif

// A pot of the paper's height whose surface the tool, at `distance`, presses by kPress.
onggi::SceneDef pot(bool as_printed, Grid grid, double distance) {
  onggi::SceneDef def;
  onggi::ClayDef& clay = def.clay;
  clay.rows = grid.rows;
  clay.sectors = grid.sectors;
  clay.height = 0.072;
  clay.floor_thickness = 0.0;
  clay.wall_min = 0.0005;
  clay.inner_radius = clay.radius_min = 0.0001;
  clay.keep_undo = false;
  const double reach = def.tool.radius - kPress;
  if (distance > kWithin) {
    clay.outer_radius = distance - reach;
  } else if (as_printed) {
    clay.outer_radius = distance + reach;
  } else {
    clay.inner_radius = distance + reach;
    clay.outer_radius = clay.inner_radius + 0.01;
  }
  def.guard = {22.2, 1e5, 0.05};
  if (as_printed) {
    def.friction.reset();
    def.moisture.reset();
    def.paper.emplace();
  }
  return def;
}

struct Visit {
  std::vector<double> tick_us;
  double visited = 0.0;  // elements a tick
};

// The tool goes up the turning wall.
bool go(const onggi::SceneDef& def, double distance, int ticks, Visit& visit) {
  auto scene = onggi::Scene::create(def);
  if (!scene) return false;
  onggi::Hands hands;
  hands.wheel_speed = kWheel;
  for (int n = 0; n < 400; ++n) scene->step(hands, 0.001);  // the wheel comes up to its speed
  hands.hand[0].active = true;
  hands.hand[0].side = distance > kWithin ? onggi::SideWish::outside : onggi::SideWish::inside;
  const auto before = scene->counters().visited_elements;
  for (int n = 0; n < ticks; ++n) {
    hands.hand[0].position = {distance, 0.012 + kRise * n, 0.0};
    const auto start = std::chrono::steady_clock::now();
    const onggi::Feedback felt = scene->step(hands, 0.001);
    const auto end = std::chrono::steady_clock::now();
    if (!felt.hand[0].contact) return false;
    const double us = std::chrono::duration<double, std::micro>(end - start).count();
    double& least = visit.tick_us[static_cast<std::size_t>(n)];
    least = std::min(least, us);
  }
  visit.visited = static_cast<double>(scene->counters().visited_elements - before) / ticks;
  return true;
}

struct Span {
  double sum = 0.0, least = 1e300, most = 0.0;
  int count = 0;
  void add(double us) {
    sum += us;
    least = std::min(least, us);
    most = std::max(most, us);
    ++count;
  }
};

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "processor unknown";
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  char text[16];
  std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&now));
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  const bool quick = argc == 3 && std::strcmp(argv[2], "--quick") == 0;
  std::FILE* out = argc == 2 || quick ? std::fopen(argv[1], "w") : nullptr;
  if (out == nullptr) {
    std::fprintf(stderr,
                 "usage: onggi_figure_times OUT.csv [--quick] (a file that can be written)\n");
    return 2;
  }
  const int runs = quick ? 1 : 9;
  const int ticks = quick ? 20 : 600;
  std::fprintf(out, "# machine: %s, %u cores; %s, %s\n", processor().c_str(),
               std::thread::hardware_concurrency(), kCompiler, today().c_str());
  std::fprintf(out,
               "# %d ticks a line, each the least of %d runs; 'all' is all distances together\n",
               ticks, runs);
  std::fprintf(out, "model,rows,sectors,distance_mm,visited,mean_us,least_us,most_us\n");
  for (const bool as_printed : {true, false}) {
    const char* model = as_printed ? "paper" : "corrected";
    for (const Grid grid : kGrids) {
      Span all;
      double visited = 0.0;
      for (const double distance : kDistances) {
        const onggi::SceneDef def = pot(as_printed, grid, distance);
        Visit visit{std::vector<double>(static_cast<std::size_t>(ticks), 1e300)};
        for (int run = 0; run < runs; ++run) {
          if (go(def, distance, ticks, visit)) continue;
          std::fprintf(stderr, "%s, %d x %d, %g mm: the tool does not touch the pot\n", model,
                       grid.rows, grid.sectors, 1e3 * distance);
          return 1;
        }
        Span here;
        for (const double us : visit.tick_us) {
          here.add(us);
          all.add(us);
        }
        visited += visit.visited / std::size(kDistances);
        std::fprintf(out, "%s,%d,%d,%.0f,%.0f,%.2f,%.2f,%.2f\n", model, grid.rows, grid.sectors,
                     1e3 * distance, visit.visited, here.sum / here.count, here.least, here.most);
      }
      std::fprintf(out, "%s,%d,%d,all,%.0f,%.2f,%.2f,%.2f\n", model, grid.rows, grid.sectors,
                   visited, all.sum / all.count, all.least, all.most);
    }
  }
  return std::fclose(out) == 0 ? 0 : 1;
}
