// The data of figure 8: what each model feels, tick by tick, while a sphere is pushed slowly and
// evenly into a turning pot. Equal bits on every machine.
// usage: onggi_figure_push OUT.csv
#include <cmath>
#include <cstdio>

#include "engine/contact/paper_model.h"
#include "engine/math/portable.h"
#include "engine/scene/scene.h"

namespace {

namespace portable = onggi::portable;
using onggi::Clay;
using onggi::Vec3;

constexpr double kTick = 0.001;        // s
constexpr double kSpeed = 0.005;       // m/s, towards the axis
constexpr double kClear = 0.001;       // m from the surface at the start
constexpr double kDeepest = 0.012;     // m within the surface at the end
constexpr double kWheel = 6.28318530;  // rad/s, 60 rpm
constexpr double kHeight = 0.036;      // m, half way up

// config/scenes/paper.toml, but for the guard: its ramp and slew are out of the way.
onggi::SceneDef papers_pot() {
  onggi::SceneDef def;
  def.clay.height = 0.072;
  def.clay.floor_thickness = 0.0;
  def.clay.wall_min = 0.0005;
  def.clay.inner_radius = def.clay.radius_min = 0.0001;
  def.clay.keep_undo = false;
  def.wheel.acceleration = 1000.0;
  def.guard = {22.2, 1e5, 0.05};
  def.moisture.reset();
  return def;
}

// The mean press over the elements that the sphere is in, m, by the corrected law l = S - E1. The
// engine keeps no such sum; this one looks at every element and is in double.
double mean_press(const Clay& clay, Vec3 at, double radius, double wheel_angle) {
  double sum = 0.0;
  int touched = 0;
  for (int j = 0; j < clay.rows(); ++j) {
    const double dy = clay.row_height(j) - at.y;
    const double square = radius * radius - dy * dy;
    if (square <= 0.0) continue;
    for (int i = 0; i < clay.sectors(); ++i) {
      const double angle = (i + 0.5) * 2.0 * portable::kPi / clay.sectors() + wheel_angle;
      const double c = portable::cos(angle);
      const double s = portable::sin(angle);
      const double along = at.x * c + at.z * s;
      const double off = at.z * c - at.x * s;
      if (along <= 0.0 || off * off >= square) continue;
      const double reach = along - std::sqrt(square - off * off);
      const double press = double{clay.outer(j)[static_cast<std::size_t>(i)]} - reach;
      if (press <= 0.0) continue;
      sum += press;
      ++touched;
    }
  }
  return touched > 0 ? sum / touched : 0.0;
}

}  // namespace

int main(int argc, char** argv) {
  std::FILE* out = argc == 2 ? std::fopen(argv[1], "w") : nullptr;
  if (out == nullptr) {
    std::fprintf(stderr, "usage: onggi_figure_push OUT.csv (a file that can be written)\n");
    return 2;
  }
  const onggi::SceneDef def = papers_pot();
  auto corrected = onggi::Scene::create(def);
  auto sheet = Clay::create(def.clay);
  if (!corrected || !sheet) return 1;
  const onggi::PaperModel printed(*sheet);
  const onggi::PaperDef coefficients;
  onggi::PaperFilter paper_filter, same_filter;

  std::fprintf(out,
               "# A sphere of 8 mm pushed at 5 mm/s into a pot of 55 mm radius, 400 x 360 elements,"
               " wheel at 60 rpm.\n"
               "# The printed model has c_eta 10, c_v 0.864 N/m, c_r 200 N/m; the corrected one the"
               " defaults of scene_def.h.\n"
               "time_s,depth_mm,paper_touched,paper_mean_mm,paper_force_N,paper_filtered_N,"
               "corrected_touched,corrected_mean_mm,corrected_force_N,corrected_filtered_N\n");
  const double surface = def.clay.outer_radius + def.tool.radius;
  const int ticks = static_cast<int>(std::lround((kClear + kDeepest) / (kSpeed * kTick)));
  double wheel_angle = 0.0;
  std::uint64_t touched_before = 0;
  for (int n = 1; n <= ticks; ++n) {
    const double depth = kSpeed * kTick * n - kClear;
    const Vec3 at{surface - depth, kHeight, 0.0};
    const double mean =
        mean_press(corrected->clay(), at, def.tool.radius, wheel_angle + kWheel * kTick);

    onggi::Hands hands;
    hands.hand[0] = {at, true, onggi::SideWish::outside};
    hands.wheel_speed = kWheel;
    const onggi::Feedback felt = corrected->step(hands, kTick);
    wheel_angle = felt.wheel_angle;
    const std::uint64_t touched = corrected->counters().touched_elements - touched_before;
    touched_before += touched;
    const Vec3 smoothed = same_filter.filter(felt.hand[0].force);

    const onggi::PaperTouch touch =
        printed.tick(*sheet, onggi::WallSide::outside, at, def.tool.radius, wheel_angle,
                     kWheel * kTick, {coefficients.c_eta, coefficients.c_v, coefficients.c_r});
    const Vec3 filtered = paper_filter.filter(touch.force);
    const double paper_mean =
        touch.touched > 0 ? touch.depth_sum / static_cast<double>(touch.touched) : 0.0;
    std::fprintf(out, "%.3f,%.3f,%lld,%.4f,%.5f,%.5f,%llu,%.4f,%.5f,%.5f\n", kTick * n, 1e3 * depth,
                 static_cast<long long>(touch.touched), 1e3 * paper_mean, length(touch.force),
                 length(filtered), static_cast<unsigned long long>(touched), 1e3 * mean,
                 length(felt.hand[0].force), length(smoothed));
  }
  return std::fclose(out) == 0 ? 0 : 1;
}
