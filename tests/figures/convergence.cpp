// The table of engine/docs/convergence.md: with which order shape, force and impulse draw together
// as ticks get shorter and grids finer, for each effect alone and each scene of config/scenes.
// usage: onggi_figure_convergence OUT.csv   in the project's root
#include <cstdio>

#include "kiosk/collection/settings/scene_file.h"
#include "tests/support/convergence.h"

namespace {

using namespace onggi;
using namespace onggi::refinement;

std::FILE* out = nullptr;

// In brackets where the finest two differ by less than anybody could tell.
void order(double p, double finest, double floor) {
  std::fprintf(out, finest < floor ? ",(%.1f)" : ",%.1f", p);
}

void line(const Work& work, const char* of, const Refined& r) {
  std::fprintf(out, "\"%s\",%s", work.name.c_str(), of);
  order(r.order.shape, r.finest.shape, kFloor.shape);
  order(r.order.force, r.finest.force, kFloor.force);
  order(r.order.impulse, r.finest.impulse, kFloor.impulse);
  std::fprintf(out, ",%.2f\n", 1e2 * r.impulse_off);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 || (out = std::fopen(argv[1], "w")) == nullptr) {
    std::fprintf(stderr, "usage: onggi_figure_convergence OUT.csv\n");
    return 2;
  }
  std::vector<Work> works = effect_works();
  for (const char* name : {"paper", "first_touch", "studio", "master"}) {
    settings::SceneRead read = settings::read_scene("config/scenes/" + std::string(name) + ".toml");
    for (Work& work : scene_works(name, std::move(read.def))) works.push_back(std::move(work));
  }
  std::fprintf(out, "work,refined,shape_order,force_order,impulse_order,impulse_off_percent\n");
  for (const Work& work : works) {
    line(work, "ticks", refine_ticks(work));
    line(work, "grids", refine_grids(work));
  }
  return std::fclose(out) == 0 ? 0 : 1;
}
