#include "engine/lab/invariant_checker.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/effects/volume.h"
#include "engine/math/hash.h"
#include "engine/math/portable.h"
#include "engine/scene/long_tick.h"

namespace onggi::lab {
namespace {

constexpr double kSameVolume = 1e-6;
constexpr double kSettled = 1e-9;  // m: tolerance of summed heights

template <class... Values>
std::string said(const char* form, Values... values) {
  char text[256];
  std::snprintf(text, sizeof text, form, values...);
  return text;
}

double seconds_of(double dt) { return dt >= 1e-6 ? std::min(dt, 0.005) : 1e-6; }

std::uint64_t content_of(const Clay& clay, int j) {
  StateHash hash;
  hash.add(clay.outer(j));
  hash.add(clay.inner(j));
  return hash.value();
}

}  // namespace

const char* name_of(Invariant invariant) {
  static constexpr const char* kNames[kInvariants] = {
      "finite", "range", "stacked", "volume", "force", "depth", "marks", "same hash", "mirror"};
  return kNames[static_cast<std::size_t>(invariant)];
}

double InvariantChecker::rounding(double radius) {
  int exponent = 0;
  std::frexp(radius, &exponent);
  return 16.0 * std::ldexp(1.0, exponent - 24);
}

InvariantChecker::InvariantChecker(Scene& scene) {
  const Clay& clay = scene.clay();
  area_.resize(static_cast<std::size_t>(clay.room()));  // rows may divide
  content_.resize(area_.size());
  resume(scene);
  lump_ = clay.volume();
}

void InvariantChecker::resume(Scene& scene) {
  const Clay& clay = scene.clay();
  for (int j = 0; j < clay.rows(); ++j) {
    area_[static_cast<std::size_t>(j)] = clay.measured_area(j);
    content_[static_cast<std::size_t>(j)] = content_of(clay, j);
  }
  rim_ = clay.rim_height();
  force_ = {};
  off_ = 0;
  off_seconds_ = 0.0;
  laying_ = scene.laying();
  while (scene.take_dirty_row(0) >= 0) {
  }
  while (scene.take_moved_row(0) >= 0) {
  }
}

std::optional<Breach> InvariantChecker::breach(Invariant invariant, std::string what) const {
  return Breach{invariant, tick_, std::move(what)};
}

std::optional<Breach> InvariantChecker::look_at_feedback(const Scene& scene, double dt,
                                                         const Feedback& felt) {
  const SceneDef& def = scene.def();
  for (const double v : {felt.wheel_angle, felt.wheel_speed, felt.clay_angle, felt.cut_free,
                         felt.wetness, felt.sinking, scene.time()})
    if (!std::isfinite(v))
      return breach(Invariant::finite, "The tick returned a value that is not a number.");
  if (felt.wheel_angle < 0.0 || felt.wheel_angle >= 2.0 * portable::kPi)
    return breach(Invariant::range, said("The wheel stands at %.17g rad.", felt.wheel_angle));
  if (std::fabs(felt.wheel_speed) > def.wheel.max_speed)
    return breach(Invariant::range, said("The wheel turns at %.9g rad/s.", felt.wheel_speed));
  if (felt.wetness < 0.0 || felt.wetness > 1.0 || felt.cut_free < 0.0 || felt.cut_free > 1.0 ||
      felt.sinking < 0.0)
    return breach(Invariant::range, said("Wetness %.9g, cut free %.9g, sinking %.9g.", felt.wetness,
                                         felt.cut_free, felt.sinking));
  if ((felt.faults & kFaultForce) != 0)
    return breach(Invariant::force, "A force came out non-finite and was set to zero.");
  for (std::size_t n = 0; n < felt.hand.size(); ++n) {
    const HandFeedback& hand = felt.hand[n];
    if (!is_finite(hand.force) || !std::isfinite(hand.depth))
      return breach(Invariant::finite, "A hand's force is not a number.");
    const double strength = length(hand.force);
    if (strength > def.guard.max_force * (1.0 + 1e-12))
      return breach(Invariant::force,
                    said("A hand feels %.9g N of at most %.9g.", strength, def.guard.max_force));
    const double change = length(hand.force - force_[n]);
    const double most = def.guard.max_slew * seconds_of(dt) * (1.0 + 1e-9) + 1e-12;
    if (change > most)
      return breach(Invariant::force,
                    said("The force changed by %.9g N in a tick that allows %.9g.", change, most));
    force_[n] = hand.force;
    double large = std::max({def.clay.radius_max, rim_, scene.clay().rim_height()});
    // Within a long tick clay may rise and sag again between two parts.
    if (def.volume && scene::parts_of(seconds_of(dt)) > 1)
      large = std::max(large, def.building ? def.building->tallest
                                           : effects::Volume::kTallest * def.clay.height);
    if (hand.depth < 0.0 || hand.depth > large + kSettled)
      return breach(Invariant::depth,
                    said("A press of %.9g m in clay of %.9g m.", hand.depth, large));
  }
  return {};
}

std::optional<Breach> InvariantChecker::look_at_row(const Clay& clay, int j) {
  const ClayDef& def = clay.def();
  const auto outer = clay.outer(j), inner = clay.inner(j);
  // While steps are taken back, some rows and the floor are still as they were.
  const bool solid = j < clay.floor_rows();
  const bool settled = !laying_;
  float least = outer[0] - inner[0], most = outer[0], hole = inner[0], widest = inner[0];
  bool good = true;
  for (std::size_t i = 0; i < outer.size(); ++i) {
    good = good && std::isfinite(outer[i]) && std::isfinite(inner[i]);
    least = std::min(least, outer[i] - inner[i]);
    most = std::max(most, outer[i]);
    hole = std::min(hole, inner[i]);
    widest = std::max(widest, inner[i]);
  }
  if (!good) return breach(Invariant::finite, said("Row %d has a radius that is not a number.", j));
  const double rounding = InvariantChecker::rounding(static_cast<double>(most));
  if (settled && solid && (hole != 0.0f || widest != 0.0f))
    return breach(Invariant::range, said("Row %d of the floor has a hole of %.9g m.", j,
                                         static_cast<double>(hole != 0.0f ? hole : widest)));
  if (settled && !solid && static_cast<double>(hole) < def.radius_min - rounding)
    return breach(Invariant::range, said("Row %d has an inner radius of %.9g m, under %.9g.", j,
                                         static_cast<double>(hole), def.radius_min));
  if (static_cast<double>(least) < def.wall_min - rounding)
    return breach(Invariant::range, said("Row %d has a wall of %.9g m, under its least of %.9g.", j,
                                         static_cast<double>(least), def.wall_min));
  if (static_cast<double>(most) > def.radius_max + rounding)
    return breach(Invariant::range, said("Row %d has an outer radius of %.9g m, over %.9g.", j,
                                         static_cast<double>(most), def.radius_max));
  area_[static_cast<std::size_t>(j)] = clay.measured_area(j);
  content_[static_cast<std::size_t>(j)] = content_of(clay, j);
  return {};
}

std::optional<Breach> InvariantChecker::look_at_stack(const Clay& clay) const {
  double edge = 0.0;
  for (int j = 0; j < clay.rows(); ++j) {
    const double thick = clay.row_thickness(j);
    if (!std::isfinite(thick) || !std::isfinite(clay.row_height(j)))
      return breach(Invariant::finite, said("Row %d has a height that is not a number.", j));
    if (!(thick > 0.0))
      return breach(Invariant::stacked, said("Row %d is %.9g m thick.", j, thick));
    if (clay.areas() != nullptr && thick > effects::Volume::kThickest * clay.first_thickness())
      return breach(Invariant::stacked, said("Row %d is %.3g times as thick as a fresh one.", j,
                                             thick / clay.first_thickness()));
    const double gap = clay.row_height(j) - 0.5 * thick - edge;
    if (std::fabs(gap) > kSettled * std::max(1.0, edge))
      return breach(Invariant::stacked,
                    said("Row %d begins %.9g m off the top of the one below.", j, gap));
    edge += thick;
  }
  const int floor = clay.floor_rows();
  const double top = clay.floor_top();
  if (!std::isfinite(top)) return breach(Invariant::finite, "The floor's height is not a number.");
  const double low = floor > 0 ? clay.row_height(floor - 1) : 0.0;
  const double high = floor < clay.rows() ? clay.row_height(floor) : clay.rim_height();
  if (top < low - kSettled || top > high + kSettled)
    return breach(Invariant::stacked,
                  said("The floor's top is at %.9g m, outside %.9g to %.9g m.", top, low, high));
  return {};
}

std::optional<Breach> InvariantChecker::look_at_volume(const Scene& scene, double seconds) {
  if (!scene.def().volume) return {};
  for (const int n : {0, 1}) {
    const HandView view = scene.hand(n);
    const ToolShape* shape = find_tool_shape(view.name);
    cut_ = cut_ || (view.present && shape != nullptr && shape->cuts);
  }
  const Clay& clay = scene.clay();
  if (laying_) return {};
  double sum = 0.0;
  for (int j = 0; j < clay.rows(); ++j)
    sum += area_[static_cast<std::size_t>(j)] * clay.row_thickness(j);
  const double off = sum / (lump_ + scene.coil().added) - 1.0;
  const bool good = off < kSameVolume && (cut_ || off > -kSameVolume);
  // A pressed rim gets its girth at a bounded pace. In ticks, or parts of a long tick, shorter than
  // that pace, girth is late while the rim is pressed and for one more round.
  constexpr double kElementsPerSecond = 16384e3;
  constexpr double kLongestWait = 0.1;  // s
  const double late = std::min(kLongestWait, clay.rows() * clay.stride() / kElementsPerSecond);
  const bool waits = !good && !(pressed_ && seconds / scene::parts_of(seconds) < late);
  off_ = waits ? off_ + 1 : 0;
  off_seconds_ = waits ? off_seconds_ + seconds : 0.0;
  if (off_ > 2 && off_seconds_ > 2.0 * late)
    return breach(Invariant::volume, said("The clay grew by %.9g of the lump.", off));
  return {};
}

std::optional<Breach> InvariantChecker::after(Scene& scene, double dt, const Feedback& felt) {
  ++tick_;
  if (auto found = look_at_feedback(scene, dt, felt)) return found;
  const Clay& clay = scene.clay();
  rim_ = clay.rim_height();
  laying_ = scene.laying();
  pressed_ = std::ranges::any_of(felt.hand, &HandFeedback::contact);
  for (int j = scene.take_dirty_row(0); j >= 0; j = scene.take_dirty_row(j))
    if (auto found = look_at_row(clay, j)) return found;
  for (int j = scene.take_moved_row(0); j >= 0; j = scene.take_moved_row(j))
    if (j < clay.floor_rows())
      if (auto found = look_at_row(clay, j)) return found;
  if (clay.rows() <= kWhole || tick_ % 64 == 0) {
    if (auto found = look_at_volume(scene, seconds_of(dt))) return found;
    if (!laying_)
      if (auto found = look_at_stack(clay)) return found;
  }
  return tick_ % kWhole == 0 ? whole(scene) : std::nullopt;
}

std::optional<Breach> InvariantChecker::whole(Scene& scene) {
  const Clay& clay = scene.clay();
  for (int j = 0; j < clay.rows(); ++j) {
    if (content_[static_cast<std::size_t>(j)] != content_of(clay, j))
      return breach(Invariant::marks, said("Row %d changed but is not marked.", j));
    if (auto found = look_at_row(clay, j)) return found;
  }
  return !laying_ ? look_at_stack(clay) : std::nullopt;
}

}  // namespace onggi::lab
