// A scripted potter throws a cylinder; its measures are printed.
#include <cstdio>

#include "engine/profile/measures.h"
#include "engine/scene/lump.h"
#include "engine/scene/scene.h"
#include "engine/script/script.h"

int main() {
  // 150 mm high, 80 mm wide, a wall of 5 mm on a floor of 10 mm. All lengths in metres.
  const onggi::Profile cylinder{
      {{0.0, 0.040, 0.0}, {0.010, 0.040, 0.0}, {0.0101, 0.040, 0.035}, {0.150, 0.040, 0.035}}};
  onggi::SceneDef def;  // every field has a default
  def.clay = onggi::lump_for(cylinder, def);
  auto scene = onggi::Scene::create(def);
  auto potter = onggi::make_script("follow", {.scene = def, .target = &cylinder});
  if (!scene || !potter) {
    const onggi::Problem& problem = scene ? potter.error() : scene.error();
    std::fprintf(stderr, "%s\n", onggi::to_text(problem).c_str());
    return problem.exit_code;
  }
  double most_force = 0.0;
  while (scene->time() < (*potter)->duration()) {
    const onggi::Hands hands = (*potter)->at(scene->time(), scene->clay());
    const onggi::Feedback felt = scene->step(hands, 0.001);
    const double force = length(felt.hand[0].force);
    if (force > most_force) most_force = force;
  }
  const onggi::Measures m = onggi::compare(cylinder, scene->clay().profile(), false);
  std::printf("height %.1f mm\nfoot %.1f mm\nbelly %.1f mm\nmouth %.1f mm\nwall %.1f mm\n",
              1e3 * m.made.height, 1e3 * m.made.foot, 1e3 * m.made.belly, 1e3 * m.made.mouth,
              1e3 * m.made.wall_mean);
  std::printf("outline off by %.2f mm\nmost force %.2f N\nhash %016llx\n",
              1e3 * m.outline_rms * cylinder.height(), most_force,
              static_cast<unsigned long long>(scene->state_hash()));
}
