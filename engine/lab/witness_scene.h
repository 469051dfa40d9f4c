#pragma once

#include <utility>

#include "engine/contact/tool_contact.h"
#include "engine/scene/scene.h"

namespace onggi::lab {

/// The lump alone on `rows` x `sectors`: no effect, no undo, a wheel that is at its speed at once,
/// and forces as they are.
SceneDef lone_lump(int rows, int sectors);
/// The same with a wall: `inner` and `outer` radius, m.
SceneDef lone_wall(int rows, int sectors, double inner, double outer);
/// A scene of a good `def`. Allocates.
Scene scene_of(const SceneDef& def);
/// One ball in hand 0.
Hands ball_at(Vec3 at, SideWish side);
/// In front of the first element of row `row`, `out` m from the axis.
Vec3 on_first_ray(const Clay& clay, int row, double out);
/// Number of the tool `name` for HandInput::tool, 0 if the scene has none.
std::uint8_t tool_of(const SceneDef& def, std::string_view name);

/// |is / should - 1|.
double share_apart(double is, double should);

/// The press of a ball on one face, added up here, element by element, in doubles.
struct ElementSum {
  Vec3 force;           ///< N
  double normal = 0.0;  ///< Sum of normal forces, N.
};
/// k_A A l n over a fresh face (contact.md): A = S dtheta dh, n = (H - E) / |H - E|.
ElementSum fresh_press(const Clay& clay, WallSide side, Vec3 ball, double radius, double stiffness);
/// The same from what a step took away of each element, k_A tau/dt A (change of the face) n.
/// `before`: the clay as it was, turned by no more than `ball` is.
ElementSum taken_press(const Clay& before, const Clay& now, WallSide side, Vec3 ball, double radius,
                       double stiffness, double steps_of_tau);
/// Area of row `j`'s section, m^2, and the volume of all, m^3: plain sums.
double row_area_of(const Clay& clay, int j);
double volume_of(const Clay& clay);

/// A ball that is set down anywhere, in clay that keeps its shape (it gives way in eleven days).
class FrozenClay {
 public:
  /// `def` is good. Allocates.
  FrozenClay(const ClayDef& def, double radius, double stiffness);
  FrozenClay(Clay clay, double radius, double stiffness)
      : clay_(std::move(clay)), radius_(radius), stiffness_(stiffness) {}
  /// N. No allocation.
  Vec3 push(Vec3 at);
  /// From now on it is stiffer by this share.
  void stiffen(double by) { stiffness_ *= 1.0 + by; }

 private:
  Clay clay_;
  ToolContact contact_;
  double radius_, stiffness_;
};

}  // namespace onggi::lab
