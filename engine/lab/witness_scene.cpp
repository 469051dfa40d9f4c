#include "engine/lab/witness_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/math/portable.h"

namespace onggi::lab {
namespace {

double element_angle(const Clay& clay) { return 2.0 * portable::kPi / clay.sectors(); }

// Calls `each(j, i, n, end)` with the elements whose rays the ball meets: the normal, and the
// radius at which the ray meets its near face (outside) or its far one.
template <class Each>
void each_under(const Clay& clay, WallSide side, Vec3 ball, double radius, Each&& each) {
  for (int j = 0; j < clay.rows(); ++j) {
    const double above = ball.y - clay.row_height(j);
    const double section = radius * radius - above * above;
    if (section <= 0.0) continue;
    for (int i = 0; i < clay.sectors(); ++i) {
      const double angle = (i + 0.5) * element_angle(clay);
      const double c = portable::cos(angle), s = portable::sin(angle);
      const double along = ball.x * c + ball.z * s;
      const double off = ball.z * c - ball.x * s;
      if (along <= 0.0 || off * off >= section) continue;
      const double chord = std::sqrt(section - off * off);
      const double end = side == WallSide::outside ? along - chord : along + chord;
      each(j, static_cast<std::size_t>(i),
           (1.0 / radius) * Vec3{ball.x - end * c, above, ball.z - end * s}, end);
    }
  }
}

}  // namespace

SceneDef lone_lump(int rows, int sectors) {
  SceneDef def;
  def.clay.rows = rows;
  def.clay.sectors = sectors;
  def.clay.keep_undo = false;
  def.moisture.reset();
  def.friction.reset();
  def.wheel.acceleration = 1000.0;
  def.guard = {22.2, 1e5, 0.05};
  return def;
}

SceneDef lone_wall(int rows, int sectors, double inner, double outer) {
  SceneDef def = lone_lump(rows, sectors);
  def.clay.inner_radius = inner;
  def.clay.outer_radius = outer;
  return def;
}

Scene scene_of(const SceneDef& def) { return std::move(*Scene::create(def)); }

Hands ball_at(Vec3 at, SideWish side) {
  Hands hands;
  hands.hand[0].position = at;
  hands.hand[0].active = true;
  hands.hand[0].side = side;
  return hands;
}

Vec3 on_first_ray(const Clay& clay, int row, double out) {
  const double angle = 0.5 * element_angle(clay);
  return {out * portable::cos(angle), clay.row_height(row), out * portable::sin(angle)};
}

std::uint8_t tool_of(const SceneDef& def, std::string_view name) {
  for (std::size_t n = 0; n < def.tools.size(); ++n)
    if (def.tools[n].name == name) return static_cast<std::uint8_t>(n + 1);
  return 0;
}

double share_apart(double is, double should) { return std::fabs(is / should - 1.0); }

ElementSum fresh_press(const Clay& clay, WallSide side, Vec3 ball, double radius,
                       double stiffness) {
  ElementSum sum;
  each_under(clay, side, ball, radius, [&](int j, std::size_t i, Vec3 normal, double end) {
    const double face = double{side == WallSide::outside ? clay.outer(j)[i] : clay.inner(j)[i]};
    const double press = side == WallSide::outside ? face - end : end - face;
    if (press <= 0.0) return;
    const double area = face * element_angle(clay) * clay.row_thickness(j);
    sum.force += (stiffness * area * press) * normal;
    sum.normal += stiffness * area * press;
  });
  return sum;
}

ElementSum taken_press(const Clay& before, const Clay& now, WallSide side, Vec3 ball, double radius,
                       double stiffness, double steps_of_tau) {
  ElementSum sum;
  each_under(now, side, ball, radius, [&](int j, std::size_t i, Vec3 normal, double) {
    const bool outside = side == WallSide::outside;
    const double was = double{outside ? before.outer(j)[i] : before.inner(j)[i]};
    const double is = double{outside ? now.outer(j)[i] : now.inner(j)[i]};
    // S of A = S dtheta dh, and the change of S: half the change of its square.
    const double swept = 0.5 * std::fabs(was * was - is * is) * element_angle(now);
    const double pushed = stiffness * steps_of_tau * swept * now.row_thickness(j);
    sum.force += pushed * normal;
    sum.normal += pushed;
  });
  return sum;
}

double row_area_of(const Clay& clay, int j) {
  double sum = 0.0;
  for (std::size_t i = 0; i < clay.outer(j).size(); ++i) {
    const double outer = double{clay.outer(j)[i]}, inner = double{clay.inner(j)[i]};
    sum += (outer - inner) * (outer + inner);
  }
  return 0.5 * element_angle(clay) * sum;
}

double volume_of(const Clay& clay) {
  double sum = 0.0;
  for (int j = 0; j < clay.rows(); ++j) sum += row_area_of(clay, j) * clay.row_thickness(j);
  return sum;
}

FrozenClay::FrozenClay(const ClayDef& def, double radius, double stiffness)
    : clay_(std::move(*Clay::create(def))), radius_(radius), stiffness_(stiffness) {}

Vec3 FrozenClay::push(Vec3 at) {
  ToolSweep still;
  still.shape = find_tool_shape("sphere");
  still.size.radius = radius_;
  still.from = still.to = at;
  still.seconds = 0.001;
  contact_.begin_tick();
  contact_.step(clay_, still, 0, 1, {1e6, stiffness_});
  return contact_.reaction().force;
}

}  // namespace onggi::lab
