#include "kiosk/visit/screens/mishap.h"

#include <utility>

namespace onggi::screens {

namespace {

// A wall that tore when thin springs back a little when the hand leaves: in the exhibit's scenes an
// eighth of a press is elastic.
constexpr double kSprungBack = 1.25;

// Longest time for the wheel to undo a step, s: 8192 elements a tick for each face, twice
// (engine/scene/scene.cpp), plus the settling of the clay.
double patience(const ClayView& clay) { return 0.1 + 4e-3 * clay.rows() * clay.sectors() / 8192.0; }

}  // namespace

Mishap MishapWatch::seen(const Desk& desk) const {
  if (!desk.pot_ready()) return Mishap::none;
  const Feedback& felt = desk.status.feedback;
  if (felt.fallen) return Mishap::fell;
  if (!felt.torn) return Mishap::none;
  // Keep the cause of a tear as it was first found.
  if (now_ == Mishap::tore_thin || now_ == Mishap::tore_wide) return now_;
  // The status may be newer than the rows.
  const auto wall = desk.world.wheel->clay.torn_wall();
  if (!wall) return Mishap::none;
  return *wall < kSprungBack * desk.wheel().tear_thickness ? Mishap::tore_thin : Mishap::tore_wide;
}

bool MishapWatch::update(Desk& desk) {
  const Mishap was = std::exchange(now_, seen(desk));
  if (now_ != Mishap::tore_thin && now_ != Mishap::tore_wide) going_back_ = false;
  if (going_back_ && desk.status.can_restore &&
      desk.status.time - asked_at_ > patience(desk.world.wheel->clay))
    go_back(desk);
  return now_ != was;
}

void MishapWatch::go_back(Desk& desk) {
  desk.world.wheel_commands->restore();
  going_back_ = now_ != Mishap::none;
  asked_at_ = desk.status.time;
}

}  // namespace onggi::screens
