#include "kiosk/visit/screens/hint.h"

#include <algorithm>
#include <cmath>

#include "kiosk/visit/screens/measured_pot.h"
#include "kiosk/visit/screens/target_line.h"

namespace onggi::screens {

using device::Grip;

namespace {

constexpr const char* kPlaces[] = {"place.foot", "place.low",  "place.belly", "place.middle",
                                   "place.neck", "place.high", "place.rim"};

/// The potters' name for the part of `target` at `h`.
const char* place_at(const Profile& target, double h) {
  const double share = h / target.height();
  const Dimensions d = dimensions(target);
  if (share < 0.1) return "place.foot";
  if (share > 0.93) return "place.rim";
  const double belly = d.belly_height / target.height();
  if (belly > 0.2 && belly < 0.85 && std::abs(share - belly) < 0.13) return "place.belly";
  const bool necked = d.neck > 0 && d.neck < 0.75 * d.belly && belly < 0.75;
  if (necked && share > belly && 2 * target.outer_at(h) < d.neck * 1.25) return "place.neck";
  if (share < 0.36) return "place.low";
  return share > 0.64 ? "place.high" : "place.middle";
}

struct Difference {
  double height = 0, off = 0;
};

/// The height where the clay is farthest from the target and can still be changed.
Difference worst(const HintInput& in) {
  constexpr int kSteps = 48, kReach = 2;
  const double height = std::min(in.target->height(), in.made->height());
  // Below this the pot is solid, so no tool can press it outwards.
  const double floor = in.made->floor_height() + in.tool_radius;
  Difference found;
  for (int i = kReach; i <= kSteps - kReach; ++i) {
    double off = 0;
    for (int k = -kReach; k <= kReach; ++k) {
      const double h = height * (i + k) / kSteps;
      off += (in.made->outer_at(h) - in.target->outer_at(h)) / (2 * kReach + 1);
    }
    const double h = height * i / kSteps;
    if (off < 0 && h < floor) continue;
    if (std::abs(off) > std::abs(found.off)) found = {h, off};
  }
  return found;
}

}  // namespace

Hint next_hint(const HintInput& in) {
  if (!in.wheel_turns) return {"hint.wheel_still", {}, {}};
  if (in.target == nullptr || in.made == nullptr || in.made->points.empty())
    return {"hint.begin", {}, {}};
  if (in.dry_too_long) return {"hint.dry", {}, {}};
  if (!in.described.empty()) return {in.described, {}, {}};
  const Difference d = worst(in);
  if (std::abs(d.off) <= tolerance(*in.target)) return {"hint.close", {}, {}};

  const bool inward = d.off > 0;
  Hint hint{"", place_at(*in.target, d.height), Hint::Press{d.height, inward}};
  if (inward)
    hint.key = in.grip == Grip::inside ? "hint.go_outside"
               : in.touched            ? "hint.press_in"
                                       : "hint.first_in";
  else
    hint.key = in.grip == Grip::outside ? "hint.go_inside" : "hint.press_out";
  return hint;
}

std::string words_of(const Hint& hint, const Desk& desk) {
  if (hint.key.empty()) return {};
  if (hint.place.empty()) return desk.say(hint.key);
  return desk.say(hint.key, {{"place", desk.say(hint.place)}});
}

std::vector<std::string> all_hints(const Desk& desk) {
  std::vector<std::string> all;
  for (const char* key : {"hint.wheel_still", "hint.begin", "hint.dry", "hint.close"})
    all.push_back(desk.say(key));
  if (desk.described() != nullptr)
    for (const std::string& key : MeasuredPot::hints()) all.push_back(desk.say(key));
  for (const char* key :
       {"hint.first_in", "hint.press_in", "hint.press_out", "hint.go_outside", "hint.go_inside"})
    for (const char* place : kPlaces) all.push_back(desk.say(key, {{"place", desk.say(place)}}));
  return all;
}

const Hint& HintLine::update(double now, const HintInput& in) {
  if (now - looked_ < 0.25) return shown_;
  looked_ = now;
  Hint newest = next_hint(in);
  if (newest.key == shown_.key && newest.place == shown_.place) {
    shown_.press = newest.press;
    return shown_;
  }
  // Tell at once that the wheel is not turning.
  if (now - since_ < 2.0 && newest.key != "hint.wheel_still") return shown_;
  shown_ = std::move(newest);
  since_ = now;
  return shown_;
}

}  // namespace onggi::screens
