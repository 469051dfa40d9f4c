#include "tests/support/contact_tick.h"

#include <algorithm>
#include <cmath>

#include "engine/math/portable.h"
#include "tests/support/sphere.h"

namespace onggi {
namespace {

Clay made(const ClayDef& def) { return std::move(*Clay::create(def)); }

// The wheel's angle as tick `n` begins.
double angle_at(const TickScript& script, int n) { return script.wheel_speed * kTickSeconds * n; }

Vec3 in_clay(Vec3 p, double angle) {
  const double c = portable::cos(angle);
  const double s = portable::sin(angle);
  return {c * p.x + s * p.z, p.y, c * p.z - s * p.x};
}

void refill(Clay& clay) {
  const ClayDef& def = clay.def();
  for (int j = clay.take_dirty(0); j >= 0; j = clay.take_dirty(j)) {
    std::ranges::fill(clay.outer_mut(j), static_cast<float>(def.outer_radius));
    std::ranges::fill(clay.inner_mut(j),
                      j < clay.floor_rows() ? 0.0f : static_cast<float>(def.inner_radius));
    clay.set_extent(j, clay.outer(j).front(), clay.inner(j).front());
  }
}

}  // namespace

CorrectedContact::CorrectedContact(const TickScript& script, int rows, int sectors)
    : script_(script), clay_(made(script.scene(rows, sectors).clay)) {
  const SceneDef def = script.scene(rows, sectors);
  yielding_ = {def.contact.relaxation_time, def.contact.stiffness};
  radius_ = def.tool.radius;
  refill(clay_);
}

void CorrectedContact::tick(int n) noexcept {
  const HandInput now = script_.hands(n).hand[0];
  const HandInput before = script_.hands(std::max(n - 1, 0)).hand[0];
  const double angle = angle_at(script_, n);
  const ToolSweep sweep = sweep_sphere(before.position, now.position, radius_, angle,
                                       angle_at(script_, n + 1) - angle, now.side);
  contact_.begin_tick();
  const int steps = steps_for(sweep, yielding_.relaxation_time, contact_.pressed());
  for (int step = 0; step < steps; ++step) contact_.step(clay_, sweep, step, steps, yielding_);
  pressed_ = contact_.reaction();
}

void CorrectedContact::press_alone(int n) noexcept {
  const Vec3 middle = 0.5 * (place_before(script_, n) + place_after(script_, n));
  pressed_ = press_sphere(clay_, script_.side, middle, radius_, kTickSeconds, yielding_);
}

void CorrectedContact::freshen() {
  contact_.release();
  refill(clay_);
}

SceneDef printed_scene(const TickScript& script, int rows, int sectors) {
  SceneDef def = script.scene(rows, sectors);
  if (script.side == WallSide::inside) def.clay.outer_radius = script.inner_radius;
  def.clay.inner_radius = def.clay.radius_min = 0.0001;
  def.clay.wall_min = 0.0005;
  def.friction.reset();
  def.moisture.reset();
  def.paper.emplace();
  return def;
}

PrintedContact::PrintedContact(const TickScript& script, int rows, int sectors)
    : script_(script), clay_(made(printed_scene(script, rows, sectors).clay)), model_(clay_) {
  const SceneDef def = printed_scene(script, rows, sectors);
  coefficients_ = {def.paper->c_eta, def.paper->c_v, def.paper->c_r};
  radius_ = def.tool.radius;
  refill(clay_);
}

void PrintedContact::tick(int n) noexcept {
  const HandInput now = script_.hands(n).hand[0];
  const double angle = angle_at(script_, n + 1);
  const WallSide mode = PaperModel::mode(clay_, now.position, angle, now.side);
  touch_ = model_.tick(clay_, mode, now.position, radius_, angle, angle - angle_at(script_, n),
                       coefficients_);
}

void PrintedContact::freshen() { refill(clay_); }

Vec3 place_before(const TickScript& script, int n) {
  return in_clay(script.hands(std::max(n - 1, 0)).hand[0].position, angle_at(script, n));
}
Vec3 place_after(const TickScript& script, int n) {
  return in_clay(script.hands(n).hand[0].position, angle_at(script, n + 1));
}

}  // namespace onggi
