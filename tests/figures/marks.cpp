// The data of the figure of engine/docs/tools.md: what the scripts that carve leave on the lump.
// Equal bits on every machine.
// usage: onggi_figure_marks OUT.csv
#include <cstdio>

#include "engine/math/portable.h"
#include "engine/scene/scene.h"
#include "engine/script/carving.h"

namespace {

namespace portable = onggi::portable;
using onggi::Clay;

constexpr double kTick = 0.001;         // s
constexpr double kFacetsAt = 0.11;      // m: the height of the level sections
constexpr std::size_t kProfileRay = 0;  // the upright sections' ray

// Runs the script and gives what it leaves; the section is level or upright.
bool draw(std::FILE* out, const char* name, bool level) {
  const onggi::SceneDef def;
  auto scene = onggi::Scene::create(def);
  auto script = onggi::make_script(name, {.scene = def});
  if (!scene || !script) return false;
  const long ticks = static_cast<long>((*script)->duration() / kTick) + 10;
  for (long n = 0; n < ticks; ++n)
    scene->step((*script)->at(static_cast<double>(n) * kTick, scene->clay()), kTick);
  const Clay& clay = scene->clay();
  if (level) {
    const int j = clay.first_row_above(kFacetsAt);
    for (int i = 0; i <= clay.sectors(); ++i) {
      const double angle = (i + 0.5) * 2.0 * portable::kPi / clay.sectors();
      const double r = 1e3 * double{clay.outer(j)[static_cast<std::size_t>(i % clay.sectors())]};
      std::fprintf(out, "%s,%.3f,%.3f\n", name, r * portable::cos(angle), r * portable::sin(angle));
    }
    return true;
  }
  for (int j = 0; j < clay.rows(); ++j)
    std::fprintf(out, "%s,%.4f,%.3f\n", name, 1e3 * double{clay.outer(j)[kProfileRay]},
                 1e3 * clay.row_height(j));
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  std::FILE* out = argc == 2 ? std::fopen(argv[1], "w") : nullptr;
  if (out == nullptr) {
    std::fprintf(stderr, "usage: onggi_figure_marks OUT.csv (a file that can be written)\n");
    return 2;
  }
  std::fprintf(out,
               "# What the carving scripts leave on a lump of 55 mm radius, 400 x 360 elements:"
               " level sections at %.0f mm\n"
               "# (across, mm; along, mm) and upright ones (radius, mm; height, mm).\n"
               "mark,a_mm,b_mm\n",
               1e3 * kFacetsAt);
  const bool good = draw(out, "facet", true) && draw(out, "flute", true) &&
                    draw(out, "incise", false) && draw(out, "trim_foot", false);
  return std::fclose(out) == 0 && good ? 0 : 1;
}
