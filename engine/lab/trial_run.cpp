#include "engine/lab/trial_run.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace onggi::lab {
namespace {

constexpr std::uint64_t kAsk = 1024;  // ticks between two calls of give_up

Breach difference(Invariant invariant, std::uint64_t tick, const char* form, double value) {
  char text[128];
  std::snprintf(text, sizeof text, form, value);
  return {invariant, tick, text};
}

Vectors other_vectors() {
  const auto here = vectors_here();
  return here.size() > 1 ? here[here.size() - 2] : here.front();
}

}  // namespace

double mirror_difference(const Clay& clay, const Clay& image) {
  double most = 0.0;
  for (int j = 0; j < clay.rows(); ++j) {
    most = std::max(most, std::fabs(clay.row_height(j) - image.row_height(j)));
    const std::size_t last = clay.outer(j).size() - 1;
    double outer = 0.0;
    double inner = 0.0;
    for (std::size_t i = 0; i <= last; ++i) {
      outer += std::fabs(static_cast<double>(clay.outer(j)[i]) -
                         static_cast<double>(image.outer(j)[last - i]));
      inner += std::fabs(static_cast<double>(clay.inner(j)[i]) -
                         static_cast<double>(image.inner(j)[last - i]));
    }
    most = std::max(most, std::max(outer, inner) / clay.sectors());
  }
  return most;
}

TrialResult run_trial(const Trial& trial, const TrialChecks& checks) {
  TrialResult result;
  Result<Scene> scene = Scene::create(trial.def);
  if (!scene) return result;
  InvariantChecker watch(*scene);
  bool given_up = false;
  const auto go_on = [&] {
    ++result.ticks;
    if (checks.give_up && result.ticks % kAsk == 0) given_up = checks.give_up();
    return !given_up;
  };
  trial.play([&](const TickRecord& record) {
    const Feedback felt = scene->step(record.hands, record.dt);
    result.breach = watch.after(*scene, record.dt, felt);
    return go_on() && !result.breach;
  });
  if (!result.breach && !given_up) result.breach = watch.whole(*scene);
  result.touched = scene->counters().touched_elements;
  const std::uint64_t ticks = scene->counters().ticks;
  if (result.breach || given_up) return result;

  if (checks.twice) {
    result.hash = scene->state_hash();
    Scene again = std::move(*Scene::create(trial.def, other_vectors()));
    trial.play([&](const TickRecord& record) {
      again.step(record.hands, record.dt);
      return go_on();
    });
    if (!given_up && again.state_hash() != result.hash)
      result.breach =
          Breach{Invariant::same_hash, ticks, "The same hands gave a different result."};
  }
  if (checks.mirror && !given_up && !result.breach) {
    Scene image = std::move(*Scene::create(trial.def));
    trial.play([&](const TickRecord& record) {
      image.step(mirrored(record.hands), record.dt);
      return go_on();
    });
    const double off = mirror_difference(scene->clay(), image.clay());
    if (!given_up && !(off <= kMirrorAllowed))
      result.breach =
          difference(Invariant::mirror, ticks, "The mirrored pot is %.9g m from the pot.", off);
  }
  return result;
}

}  // namespace onggi::lab
