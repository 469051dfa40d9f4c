#include "kiosk/visit/screens/lesson_line.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kiosk/visit/screens/fire_button.h"
#include "kiosk/visit/screens/target_line.h"

namespace onggi::screens {

using content::DoneWhen;
using content::LessonStep;

namespace {
constexpr double kTouch = 1.0;        // s on the clay until it counts as touched
constexpr double kRimShare = 0.9;     // of the pot's height: above it is the rim
constexpr double kRaised = 1.0 / 3;   // of the pot's height, in one stroke
constexpr double kStrokeEnds = 0.4;   // s off the clay
constexpr double kShapedShare = 0.5;  // of the heights are on the line
constexpr double kOpened = 0.25;      // of the most that it must become wider
constexpr double kLook = 0.25;        // s between two checks of the outline
constexpr double kCut = 0.99;         // of the section

double share_on_line(const Profile& made, const Profile& target) {
  constexpr int kHeights = 48;
  int near = 0;
  for (int n = 1; n < kHeights; ++n) {
    const double h = target.height() * n / kHeights;
    near += std::abs(made.outer_at(h) - target.outer_at(h)) < tolerance(target);
  }
  return static_cast<double>(near) / (kHeights - 1);
}
/// How much the line asks the hollow part of `pot` to become wider, at most, m; and how much the
/// inside of `made` is wider than that of `pot` there, at most.
struct Opening {
  double asked = 0, done = 0;
};
Opening opening(const Profile& pot, const Profile& made, const Profile& target) {
  Opening most;
  const double height = std::min({target.height(), pot.height(), made.height()});
  constexpr int kHeights = 48;
  for (int n = 1; n < kHeights; ++n) {
    const double h = height * n / kHeights;
    const double lacks = target.outer_at(h) - pot.outer_at(h);
    if (h <= pot.floor_height() || lacks <= tolerance(target)) continue;
    most.asked = std::max(most.asked, lacks);
    most.done = std::max(most.done, made.inner_at(h) - pot.inner_at(h));
  }
  return most;
}
bool needs_a_wall(DoneWhen what) {
  return what == DoneWhen::dried || what == DoneWhen::ringing || what == DoneWhen::beaten;
}
/// True where the line asks for it, and the scene has it. To open a lump that is wider than its
/// vessel everywhere would be wrong.
bool asked_for(DoneWhen what, const Desk& desk, const Profile* target, const Profile& made) {
  if (needs_a_wall(what)) return desk.wheel().beating.has_value();
  if (what != DoneWhen::opened || target == nullptr || made.points.empty()) return true;
  return opening(made, made, *target).asked > 0;
}
bool has_a_ring(const Desk& desk, const Profile& made) {
  return made.height() > desk.wheel().floor + 0.5 * desk.wheel().coil.value_or(0.0);
}
/// To the step that asks for `what`, if there was one.
const LessonStep* led_back(Desk& desk, DoneWhen what) {
  const auto& steps = *desk.lesson();
  for (std::size_t n = 0; n < desk.lesson_step(); ++n)
    if (steps[n].until == what) desk.lesson_step() = n;
  return &steps[desk.lesson_step()];
}
}  // namespace

const LessonStep* LessonLine::shown(const Desk& desk) {
  // It needs a visible outline and both hands of one visitor.
  if (desk.on() != nullptr && desk.on()->kind != settings::Mission::Kind::today) return nullptr;
  const auto* lesson = desk.lesson();
  return lesson != nullptr && desk.lesson_step() < lesson->size() ? &(*lesson)[desk.lesson_step()]
                                                                  : nullptr;
}

std::string LessonLine::by_keys(const Desk& desk, DoneWhen until) {
  // Left hands work on the left of the pot.
  const bool left = desk.screen().left_handed;
  const std::string_view done = content::kDoneWhen[static_cast<std::size_t>(until)];
  return desk.say("lesson_keys." + std::string(done),
                  {{"out", left ? "←" : "→"}, {"in", left ? "→" : "←"}});
}

bool LessonLine::leaves_off(const Desk& desk) {
  const LessonStep* step = shown(desk);
  return step == nullptr || step->until == DoneWhen::cut;
}

void LessonLine::skip(Desk& desk) {
  if (desk.lesson() != nullptr) desk.lesson_step() = desk.lesson()->size();
}

void LessonLine::begin(const Profile& made) {
  done_ = 0;
  touched_ = at_rim_ = 0;
  lowest_ = -1;
  began_with_ = made;
}

void LessonLine::watch_built(const Desk& desk, const BuiltPot& built, const Profile& made) {
  if (made.points.empty()) return;
  note(DoneWhen::laid, has_a_ring(desk, made));
  note(DoneWhen::built, !built.lacks_a_ring);
  if (!built.lacks_a_ring && !built.to_beat) note(DoneWhen::beaten);
  const Feedback& felt = desk.status.feedback;
  if (FireButton::wet(desk)) return;
  if (!built.lacks_a_ring) note(DoneWhen::dried);
  for (const HandFeedback& hand : felt.hand)
    if (hand.blow > 0.0) note(DoneWhen::ringing);
}

void LessonLine::watch(const Desk& desk, double dt, const Profile* target, const Profile& made) {
  const loop::LoopStatus& status = desk.status;
  if (!desk.touched || began_with_.points.empty()) begin(made);
  const double height = std::max(made.points.empty() ? 0.0 : made.height(), 0.01);
  bool contact = false;
  double at = 0;
  for (std::size_t n = 0; n < status.feedback.hand.size(); ++n) {
    if (!status.feedback.hand[n].contact) continue;
    contact = true;
    at = std::max(at, status.hand[n].at.y);
  }
  apart_ = contact ? 0 : apart_ + dt;
  if (contact) {
    touched_ += dt;
    lowest_ = lowest_ < 0 ? at : std::min(lowest_, at);
    highest_ = std::max(highest_, at);
    rose_ = std::max(rose_, at - lowest_);
    if (at > kRimShare * height) at_rim_ += dt;
  }
  // A stroke has raised the wall when it arrives at the rim or ends, not on its way.
  const bool arrived = highest_ > kRimShare * height || apart_ > kStrokeEnds;
  if (rose_ > kRaised * height && arrived) note(DoneWhen::raised);
  if (apart_ > kStrokeEnds) lowest_ = -1, highest_ = rose_ = 0;
  if (touched_ > kTouch) note(DoneWhen::touched);
  if (at_rim_ > kTouch) note(DoneWhen::rim);
  if (status.feedback.cut_free > kCut) note(DoneWhen::cut);
  looked_ += dt;
  if (looked_ < kLook || target == nullptr || made.points.empty()) return;
  looked_ = 0;
  if (share_on_line(made, *target) > kShapedShare) note(DoneWhen::shaped);
  const Opening so_far = opening(began_with_, made, *target);
  if (so_far.asked > 0 && so_far.done > kOpened * so_far.asked) note(DoneWhen::opened);
}

void LessonLine::update(Desk& desk, double dt, const Profile* target, const Profile& made,
                        bool alone, const std::optional<BuiltPot>& built) {
  if (std::exchange(step_, desk.lesson_step()) != desk.lesson_step()) in_step_ = 0;  // begun anew
  const LessonStep* step = shown(desk);
  if (step == nullptr) return;
  if (alone) watch(desk, dt, target, made);
  if (built) watch_built(desk, *built, made);
  // Blows need a wall, and a wall a first ring. Who has none, or took it away, is led back to it.
  // Until then no time is up: there is nothing else to do.
  const bool lacks = built && built->lacks_a_ring && !made.points.empty();
  if (lacks && needs_a_wall(step->until)) step = led_back(desk, DoneWhen::built);
  if (lacks && !has_a_ring(desk, made)) step = led_back(desk, DoneWhen::laid);
  in_step_ = lacks ? 0 : in_step_ + dt;
  const bool at_work = apart_ <= kStrokeEnds;
  while (step != nullptr && (has(step->until) || (in_step_ > step->after && !at_work) ||
                             !asked_for(step->until, desk, target, made))) {
    step_ = ++desk.lesson_step();
    in_step_ = 0;
    step = shown(desk);
  }
}

}  // namespace onggi::screens
