#include "kiosk/visit/screens/lesson_line.h"

#include <algorithm>
#include <cmath>

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
/// True where the line asks for it. To open a lump that is wider than its vessel everywhere would
/// be wrong.
bool asked_for(DoneWhen what, const Profile* target, const Profile& made) {
  if (what != DoneWhen::opened || target == nullptr || made.points.empty()) return true;
  const double height = std::min(target->height(), made.height());
  constexpr int kHeights = 48;
  for (int n = 1; n < kHeights; ++n) {
    const double h = height * n / kHeights;
    const bool hollow = h > made.floor_height();
    if (hollow && target->outer_at(h) > made.outer_at(h) + tolerance(*target)) return true;
  }
  return false;
}
}  // namespace

const LessonStep* LessonLine::shown(const Desk& desk) {
  // It needs a visible outline and both hands of one visitor.
  if (desk.on() != nullptr && desk.on()->kind != settings::Mission::Kind::today) return nullptr;
  const auto* lesson = desk.world.lesson;
  return lesson != nullptr && desk.lesson_step < lesson->size() ? &(*lesson)[desk.lesson_step]
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
  if (desk.world.lesson != nullptr) desk.lesson_step = desk.world.lesson->size();
}

void LessonLine::watch(const Desk& desk, double dt, const Profile* target, const Profile& made) {
  const loop::LoopStatus& status = desk.status;
  const double height = std::max(made.points.empty() ? 0.0 : made.height(), 0.01);
  bool contact = false;
  double highest = 0;
  for (std::size_t n = 0; n < status.feedback.hand.size(); ++n) {
    if (!status.feedback.hand[n].contact) continue;
    contact = true;
    if (status.feedback.hand[n].side == WallSide::inside) inside_ += dt;
    highest = std::max(highest, status.hand[n].at.y);
  }
  apart_ = contact ? 0 : apart_ + dt;
  if (apart_ > kStrokeEnds) lowest_ = -1;
  if (contact) {
    touched_ += dt;
    lowest_ = lowest_ < 0 ? highest : std::min(lowest_, highest);
    if (highest - lowest_ > kRaised * height) note(DoneWhen::raised);
    if (highest > kRimShare * height) at_rim_ += dt;
  }
  if (touched_ > kTouch) note(DoneWhen::touched);
  if (inside_ > kTouch) note(DoneWhen::opened);
  if (at_rim_ > kTouch) note(DoneWhen::rim);
  if (status.feedback.cut_free > kCut) note(DoneWhen::cut);
  looked_ += dt;
  if (looked_ < kLook || target == nullptr || made.points.empty()) return;
  looked_ = 0;
  if (share_on_line(made, *target) > kShapedShare) note(DoneWhen::shaped);
}

void LessonLine::update(Desk& desk, double dt, const Profile* target, const Profile& made,
                        bool alone) {
  const LessonStep* step = shown(desk);
  if (step == nullptr) return;
  if (alone) watch(desk, dt, target, made);
  in_step_ += dt;
  while (step != nullptr &&
         (has(step->until) || in_step_ > step->after || !asked_for(step->until, target, made))) {
    ++desk.lesson_step;
    in_step_ = 0;
    step = shown(desk);
  }
}

}  // namespace onggi::screens
