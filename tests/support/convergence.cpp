#include "tests/support/convergence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "tests/support/effect_scenes.h"

namespace onggi::refinement {
namespace {

// The same with a sponge, which is larger.
Work sponge_work(Work work) {
  std::size_t n = 0;
  while (work.def.tools[n].name != "sponge") ++n;
  const double larger = find_tool_shape("sponge")->usual.radius - work.def.tool.radius;
  work.hands = [n, larger, of_finger = work.hands](double t) {
    Hands hands = of_finger(t);
    hands.hand[0].tool = static_cast<std::uint8_t>(n + 1);
    hands.hand[0].position.x += larger;
    return hands;
  };
  return work;
}

double mean_order(double coarsest, double finest) {
  return finest > 0.0 && coarsest > 0.0 ? 0.5 * std::log2(coarsest / finest) : 0.0;
}

Refined refined(const std::array<Outcome, 4>& of) {
  const Apart first = apart(of[0], of[1]);
  const Apart last = apart(of[2], of[3]);
  Refined out;
  out.order = {mean_order(first.shape, last.shape), mean_order(first.force, last.force),
               mean_order(first.impulse, last.impulse)};
  out.finest = last;
  return out;
}

}  // namespace

Outcome worked(const Work& work, double tick, int rows) {
  Result<Outcome> made = lab::outcome_of(work, tick, rows);
  if (made) return std::move(*made);
  std::fprintf(stderr, "%s\n", to_text(made.error()).c_str());
  std::abort();
}

Refined refine_ticks(const Work& work) {
  const int rows = work.def.clay.rows;
  const std::array<Outcome, 4> of{worked(work, 1e-3, rows), worked(work, 5e-4, rows),
                                  worked(work, 2.5e-4, rows), worked(work, 1.25e-4, rows)};
  Refined out = refined(of);
  for (const double tick : {2e-3, 2.5e-3, 5e-3})
    out.impulse_off = std::max(out.impulse_off, apart(worked(work, tick, rows), of[3]).impulse);
  for (const int n : {0, 1})
    out.impulse_off =
        std::max(out.impulse_off, apart(of[static_cast<std::size_t>(n)], of[3]).impulse);
  return out;
}

Refined refine_grids(const Work& work) {
  const std::array<Outcome, 4> of{worked(work, 1e-3, 100), worked(work, 1e-3, 200),
                                  worked(work, 1e-3, 400), worked(work, 1e-3, 800)};
  Refined out = refined(of);
  out.impulse_off = apart(of[0], of[3]).impulse;
  return out;
}

std::vector<Work> effect_works() {
  constexpr double kDeep = 0.0015;
  SceneDef base = lab::on_a_wall(bare());
  base.clay.wall_min = 0.002;
  base.guard = {22.0, 1e5, 0.05};
  std::vector<Work> works{lab::finger_work("contact", base, false, kDeep)};
  for (const EffectTrial& effect : effect_trials()) {
    if (effect.name == "kiln") continue;  // no stage of the tick
    SceneDef def = base;
    effect.add(def);
    if (effect.name == "slump") def.slump->yield_stress = 1500.0;
    if (effect.name == "building" || effect.name == "beating") {
      works.push_back(def.building ? lab::coil_work("building, a ring", def)
                                   : lab::blow_work("beating, eight blows", def));
      continue;
    }
    works.push_back(lab::finger_work(effect.name, def, false, kDeep, effect.name == "moisture"));
    if (effect.name == "smoothing") works.back() = sponge_work(std::move(works.back()));
    if (effect.name == "walls")
      works.push_back(lab::finger_work("walls, two hands", def, true, 0.001));
  }
  return works;
}

}  // namespace onggi::refinement
