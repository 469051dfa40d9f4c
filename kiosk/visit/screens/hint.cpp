#include "kiosk/visit/screens/hint.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "kiosk/collection/score/in_words.h"
#include "kiosk/visit/screens/measured_pot.h"
#include "kiosk/visit/screens/target_line.h"
#include "kiosk/visit/screens/tool_tray.h"

namespace onggi::screens {

using device::Grip;

namespace {

constexpr const char* kPlaces[] = {"place.foot", "place.low",  "place.belly", "place.middle",
                                   "place.neck", "place.high", "place.rim"};

constexpr double kFromEnds = 0.04;  // an arrow this near foot or rim points at nothing

/// Remarks of the score without a place on the wall, as they are said at the wheel.
constexpr std::pair<const char*, const char*> kWithoutPlace[] = {
    {"plain.taller", "mission.taller"},
    {"plain.lower", "mission.lower"},
    {"plain.opening", "hint.opening"},
    {"plain.even", "hint.even"},
    {"remark.not_round", "hint.not_round"},
    {"remark.rippled", "hint.rippled"},
    {"remark.opening_shut", "remark.opening_shut"}};

Hint press_hint(const HintInput& in, std::string place, double share, bool inward) {
  const double height = std::min(in.target->height(), in.made->height());
  Hint hint{"", std::move(place),
            Hint::Press{height * std::clamp(share, kFromEnds, 1 - kFromEnds), inward}};
  if (inward)
    hint.key = in.grip == Grip::inside ? "hint.go_outside"
               : in.touched            ? "hint.press_in"
                                       : "hint.first_in";
  else
    hint.key = in.grip == Grip::outside ? "hint.go_inside" : "hint.press_out";
  return hint;
}

/// What the hands can do about `remark` now; nothing if they cannot.
std::optional<Hint> hint_of(const score::Remark& remark, const HintInput& in) {
  const score::Remark plain = score::in_words(remark);
  for (const auto& [said, key] : kWithoutPlace)
    if (plain.key == said) return Hint{key, {}, {}};
  const bool belly = plain.key == "plain.belly_higher" || plain.key == "plain.belly_lower";
  if (!plain.seen || (!belly && !plain.places.contains("place"))) return std::nullopt;
  const Measures& m = in.score->measures;
  if (!belly && m.common_firm * m.target.height <= tolerance(*in.target)) return std::nullopt;
  // The widest place moves as the wall swells where the vessel has it.
  const bool inward = !belly && plain.key.ends_with("narrower");
  const double floor = in.made->floor_height() + in.tool_radius;
  // Below this the pot is solid, so no tool can press it outwards.
  const double height = std::min(in.target->height(), in.made->height());
  if (!inward && plain.seen->wanted * height < floor) return std::nullopt;
  return press_hint(in, "place." + (belly ? "belly" : plain.places.at("place")), plain.seen->wanted,
                    inward);
}

}  // namespace

Hint next_hint(const HintInput& in) {
  if (!in.wheel_turns) return {"hint.wheel_still", {}, {}};
  if (in.target == nullptr || in.made == nullptr || in.made->points.empty())
    return {"hint.begin", {}, {}};
  if (in.dry_too_long) return {"hint.dry", {}, {}};
  // The wall comes first: what is not there yet can be neither beaten nor shaped.
  const BuiltPot built = in.built.value_or(BuiltPot{});
  if (built.lacks_a_ring)
    return in.coil_held ? Hint{"hint.lay_coil", {}, {}} : Hint{"hint.take_coil", in.tools_way, {}};
  if (in.paddle_held && built.to_beat && built.wet) return {"hint.wet", {}, {}};
  if (in.paddle_held && !in.built) return {"hint.beat_freely", {}, {}};
  if (in.paddle_held && built.to_beat) return {"hint.beat", {}, built.worst};
  if (in.paddle_held && built.beaten) return {"hint.beaten", {}, {}};
  if (built.to_beat) return {"hint.take_paddle", in.tools_way, {}};
  if (in.coil_held) return {"hint.high_enough", {}, {}};
  if (!in.described.empty()) return {in.described, {}, {}};
  if (in.score == nullptr) return {"hint.begin", {}, {}};
  for (const score::Remark& remark : in.score->try_next)
    if (std::optional<Hint> hint = hint_of(remark, in)) return *std::move(hint);
  return {"hint.close", {}, {}};
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
  if (desk.wheel().coil) {
    for (const char* key : {"hint.lay_coil", "hint.lay_ring", "hint.high_enough", "stroke.lays"})
      all.push_back(desk.say(key));
    for (std::size_t held = 0; held <= desk.wheel().tools.size(); ++held)
      for (const char* key : {"hint.take_coil", "hint.take_paddle"})
        all.push_back(words_of({key, ToolTray::way_in(desk, held), {}}, desk));
  }
  if (desk.wheel().beating)
    for (const char* key : {"hint.beat", "hint.wet", "hint.beat_freely", "hint.beaten",
                            "hint.beat_all", "stroke.beats"})
      all.push_back(desk.say(key));
  for (const auto& said : kWithoutPlace) all.push_back(desk.say(said.second));
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
