// The data of the figure of engine/docs/effects.md about rows that follow the clay: the same pull
// of a wall between two fingers, on a grid whose rows only grow and on one whose rows divide. Equal
// bits on every machine. usage: onggi_figure_rows OUT.csv
#include <algorithm>
#include <cstdio>
#include <optional>

#include "engine/clay/row_division.h"
#include "engine/contact/tool_contact.h"
#include "engine/effects/refinement.h"

namespace {

using onggi::Clay;
using onggi::SideWish;
using onggi::ToolContact;
using onggi::ToolSweep;
using onggi::Vec3;
using onggi::effects::Refinement;
using onggi::effects::Volume;

constexpr double kTick = 0.001;     // s
constexpr double kSpeed = 18.0;     // rad/s
constexpr double kMiddle = 0.0465;  // m: of the wall
constexpr double kRadius = 0.008;   // m: of the fingers
constexpr double kFrom = 0.03;      // m: the pulls go from there
constexpr double kTo = 0.042;       // and so far
constexpr double kSeconds = 1.5;    // each pull
constexpr double kGaps[] = {0.014, 0.011,  0.0085, 0.0065, 0.005, 0.004,
                            0.003, 0.0025, 0.002,  0.002,  0.002};  // m, between the fingers
constexpr onggi::Yielding kClay{0.02, 1e7};

onggi::ClayDef lump() {
  onggi::ClayDef def;
  def.rows = 200;
  def.sectors = 96;
  def.height = 0.08;
  def.outer_radius = 0.055;
  def.inner_radius = 0.038;
  def.wall_min = 0.0015;
  return def;
}

// Rows that are thick are divided, as the engine's scenes do.
void follow(Clay& clay, Volume& volume, Refinement& refinement) {
  for (int n = 0; n < Refinement::kMostChanges; ++n) {
    const Refinement::Change change = refinement.next(clay, volume);
    if (change.kind == Refinement::Change::Kind::none) return;
    if (change.kind == Refinement::Change::Kind::divide) {
      onggi::clay::divide_row(clay, change.row, volume.of_row(change.row));
      volume.row_divided(clay, {change.row});
    } else {
      onggi::clay::join_rows(clay, change.row,
                             volume.of_row(change.row) + volume.of_row(change.row + 1));
      volume.rows_joined(clay, {change.row});
    }
  }
}

// Pulls, and tells how thick the thickest row is and, at the end, of every row its edges and faces.
bool pull(std::FILE* out, const char* name, bool divides) {
  auto made =
      Clay::create(lump(), onggi::best_vectors(), divides ? Refinement::spare_rows(lump()) : 0);
  if (!made) return false;
  Clay& clay = *made;
  constexpr double kNoLimit = 1e6;
  Volume volume(clay, divides ? Volume::Limits{} : Volume::Limits{kNoLimit, kNoLimit});
  Refinement refinement;
  ToolContact finger[2];
  ToolSweep sweep[2];
  double angle = 0.0, time = 0.0;
  for (const double gap : kGaps) {
    const int ticks = static_cast<int>(kSeconds / kTick);
    for (int hand = 0; hand < 2; ++hand) finger[hand].release();
    for (int n = 0; n < ticks; ++n, time += kTick, angle += kSpeed * kTick) {
      const double height = kFrom + (kTo - kFrom) * n / ticks;
      for (int hand = 0; hand < 2; ++hand) {
        const double off = kRadius + 0.5 * gap;
        const Vec3 at{hand == 0 ? kMiddle + off : kMiddle - off, height, 0.0};
        ToolSweep& way = sweep[hand];
        way.shape = onggi::find_tool_shape("sphere");
        way.size = {kRadius, 0.0, 0.0};
        way.from = n == 0 ? at : way.to;
        way.to = at;
        way.angle_from = angle;
        way.angle_to = angle + kSpeed * kTick;
        way.seconds = kTick;
        way.wish = hand == 0 ? SideWish::outside : SideWish::inside;
      }
      const int steps = std::max(onggi::steps_for(sweep[0], kClay.relaxation_time),
                                 onggi::steps_for(sweep[1], kClay.relaxation_time));
      for (int step = 0; step < steps; ++step)
        for (int hand = 0; hand < 2; ++hand)
          finger[hand].step(clay, sweep[hand], step, steps, kClay);
      volume.keep(clay, kTick);
      if (divides) follow(clay, volume, refinement);
      if (n % 20 != 0) continue;
      const auto thicknesses = clay.row_thicknesses();
      std::fprintf(out, "%s,thickest,%.2f,%.4f,%.2f\n", name, time,
                   1e3 * *std::ranges::max_element(thicknesses), 1e3 * clay.rim_height());
    }
  }
  for (int j = 0; j < clay.rows(); ++j)
    std::fprintf(out, "%s,row,%.4f,%.4f,%.4f\n", name,
                 1e3 * (clay.row_height(j) - 0.5 * clay.row_thickness(j)),
                 1e3 * double{clay.inner(j)[0]}, 1e3 * double{clay.outer(j)[0]});
  std::fprintf(out, "%s,row,%.4f,,\n", name, 1e3 * clay.rim_height());
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  std::FILE* out = argc == 2 ? std::fopen(argv[1], "w") : nullptr;
  if (out == nullptr) {
    std::fprintf(stderr, "usage: onggi_figure_rows OUT.csv (a file that can be written)\n");
    return 2;
  }
  std::fprintf(out,
               "# A lump of 80 mm with 200 rows of 0.4 mm, pulled up between two fingers of 8 mm:"
               " rows that only grow,\n# and rows that divide. thickest: time (s), the thickest row"
               " (mm), height of the rim (mm). row: lower edge\n# (mm), inner and outer radius (mm)"
               " at the end, along one ray.\n"
               "rows,what,a,b,c\n");
  const bool good = pull(out, "grow", false) && pull(out, "divide", true);
  return std::fclose(out) == 0 && good ? 0 : 1;
}
