#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "engine/scene/scene_def.h"

namespace onggi {

/// What it takes to try each effect alone. All of them come from each_effect().
struct EffectTrial {
  std::string name;
  std::function<void(SceneDef&)> add;  ///< Puts it there, and what it needs.
  /// Leaves it absent, with a Def full of NaN where it would be.
  std::function<void(SceneDef&)> leave_out_full_of_nan;
};

/// `def` without any effect.
inline SceneDef bare(SceneDef def = {}) {
  each_effect(def, [](auto& effect) { effect.reset(); });
  return def;
}

inline std::vector<EffectTrial> effect_trials() {
  // The effect that stands at place `n` of the list.
  const auto at = [](SceneDef& def, int n, const auto& visit) {
    each_effect(def, [&, k = 0](auto& effect) mutable {
      if (k++ == n) visit(effect);
    });
  };
  std::vector<EffectTrial> trials;
  SceneDef all;
  each_effect(all, [&]<class Def>(std::optional<Def>&) {
    const int n = static_cast<int>(trials.size());
    trials.push_back({Def::kName,
                      [at, n](SceneDef& def) {
                        at(def, n, [](auto& effect) { effect.emplace(); });
                        if (def.prints && !def.beating) def.beating.emplace();
                        if ((def.slump || def.building || def.beating) && !def.volume)
                          def.volume.emplace();
                      },
                      [at, n](SceneDef& def) {
                        at(def, n, []<class One>(std::optional<One>& effect) {
                          effect.emplace();
                          for (const DefField<One>& field : One::fields())
                            (*effect).*(field.value) = std::numeric_limits<double>::quiet_NaN();
                          effect.reset();
                        });
                      }});
  });
  return trials;
}

}  // namespace onggi
