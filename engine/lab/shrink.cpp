#include "engine/lab/shrink.h"

#include <algorithm>
#include <utility>

#include "engine/lab/scene_fields.h"

namespace onggi::lab {
namespace {

void add_fewer_strokes(const Trial& trial, std::vector<Trial>& out) {
  const std::size_t count = trial.strokes.size();
  for (std::size_t size = (count + 1) / 2; size > 0; size = size > 1 ? (size + 1) / 2 : 0)
    for (std::size_t from = 0; from < count; from += size) {
      Trial less = trial;
      const auto begin = less.strokes.begin() + static_cast<std::ptrdiff_t>(from);
      less.strokes.erase(begin, begin + static_cast<std::ptrdiff_t>(std::min(size, count - from)));
      if (!less.strokes.empty()) out.push_back(std::move(less));
    }
}

// Each stroke cut short, the last one also by a single tick.
void add_fewer_ticks(const Trial& trial, std::vector<Trial>& out) {
  for (std::size_t n = trial.strokes.size(); n-- > 0;) {
    for (const double share : {0.5, 0.9}) {
      Trial less = trial;
      int& ticks = less.strokes[n].ticks;
      const int left = std::max(1, static_cast<int>(share * ticks));
      if (left < ticks) ticks = left, out.push_back(std::move(less));
    }
  }
  Trial less = trial;
  if (!less.strokes.empty() && --less.strokes.back().ticks > 0) out.push_back(std::move(less));
}

template <class Change>
void add_changed(const Trial& trial, std::vector<Trial>& out, Change change) {
  Trial less = trial;
  bool changed = false;
  for (Stroke& stroke : less.strokes) changed = change(stroke) || changed;
  if (changed) out.push_back(std::move(less));
}

template <class Value>
bool set(Value& value, Value plain) {
  if (value == plain) return false;
  value = plain;
  return true;
}

void add_plainer_hands(const Trial& trial, std::vector<Trial>& out) {
  for (const std::size_t n : {1u, 0u})
    add_changed(trial, out, [n](Stroke& s) { return set(s.hand[n].begins.active, false); });
  add_changed(trial, out, [](Stroke& s) { return set(s.ragged, false); });
  add_changed(trial, out, [](Stroke& s) { return set(s.dt, 0.001); });
  add_changed(trial, out, [](Stroke& s) { return set(s.tremble, 0.0); });
  add_changed(trial, out, [](Stroke& s) { return set(s.water, false); });
  add_changed(trial, out, [](Stroke& s) { return set(s.fire, false); });
  add_changed(trial, out, [](Stroke& s) { return set(s.renew, false); });
  add_changed(trial, out, [](Stroke& s) { return set(s.restore, false); });
  add_changed(trial, out, [](Stroke& s) { return set(s.wheel_speed, 0.0); });
  for (const std::size_t n : {0u, 1u}) {
    add_changed(trial, out, [n](Stroke& s) { return set(s.hand[n].begins.coil, false); });
    add_changed(trial, out, [n](Stroke& s) { return set(s.hand[n].beats, false); });
    add_changed(trial, out, [n](Stroke& s) { return set(s.hand[n].begins.paddle, false); });
    add_changed(trial, out, [n](Stroke& s) { return set(s.hand[n].begins.anvil, 0.0); });
    add_changed(trial, out, [n](Stroke& s) { return set(s.hand[n].begins.swing, 1.0); });
    add_changed(trial, out, [n](Stroke& s) { return set(s.hand[n].begins.roll, 0.0); });
    add_changed(trial, out, [n](Stroke& s) { return set(s.hand[n].begins.handle, Vec3{}); });
    add_changed(trial, out, [n](Stroke& s) { return set(s.hand[n].begins.tool, std::uint8_t{0}); });
    add_changed(trial, out,
                [n](Stroke& s) { return set(s.hand[n].begins.side, SideWish::by_position); });
    add_changed(trial, out,
                [n](Stroke& s) { return set(s.hand[n].ends, s.hand[n].begins.position); });
  }
}

void add_plainer_scene(const Trial& trial, std::vector<Trial>& out) {
  const auto add = [&](Trial less) {
    if (validate(less.def)) out.push_back(std::move(less));
  };
  SceneDef usual = bare({});
  const std::size_t effects = effect_names().size();
  for (std::size_t n = 0; n < effects; ++n) {
    add_effect(usual, n);
    if (!has_effect(trial.def, n)) continue;
    Trial less = trial;
    remove_effect(less.def, n);
    add(std::move(less));
  }
  for (const SceneField& field : scene_fields()) {
    if (!field.there(trial.def) || !field.there(usual)) continue;
    const double plain = field.get(usual);
    if (field.get(trial.def) == plain) continue;
    Trial less = trial;
    field.set(less.def, plain);
    add(std::move(less));
  }
}

}  // namespace

std::vector<Trial> simpler(const Trial& trial) {
  std::vector<Trial> out;
  add_fewer_strokes(trial, out);
  add_fewer_ticks(trial, out);
  add_plainer_hands(trial, out);
  add_plainer_scene(trial, out);
  return out;
}

Shrunk least_of(Trial trial, const Breach& breach, const TrialChecks& checks,
                std::uint64_t most_ticks) {
  Shrunk least{std::move(trial), breach, 0};
  for (bool smaller = true; smaller && least.ticks < most_ticks;) {
    smaller = false;
    for (Trial& less : simpler(least.trial)) {
      const TrialResult result = run_trial(less, checks);
      least.ticks += result.ticks;
      if (result.breach && result.breach->invariant == breach.invariant) {
        least.trial = std::move(less);
        least.breach = *result.breach;
        smaller = true;
        break;
      }
      if (least.ticks >= most_ticks) break;
    }
  }
  return least;
}

}  // namespace onggi::lab
