#pragma once

#include <functional>
#include <string_view>

#include "engine/contact/tool.h"

namespace onggi::body_checks {

/// A tool's own description, told independently of its kernel: how far `p` is outside of it, m;
/// negative within. Exact near the surface.
using Distance = std::function<double(Vec3 p, const ToolPlace& place, const ToolSize& size)>;

/// What every body is held to, as a tool of its kind. Each says in a failure which pose it was.

/// Faces after a press, and the force, are those of a ray march through `distance` in double.
void agrees_with_a_ray_march(std::string_view name, const Distance& distance);
/// Every kind of vectors gives the same clay and the same force, bit for bit.
void same_bits_on_all_vectors(std::string_view name);
/// Held symmetrically to a plane through the axis, it leaves a symmetric mark and is not pushed out
/// of that plane.
void symmetric_pose_leaves_symmetric_mark(std::string_view name);
/// Whatever the pose and size: finite, never more force than the normals add up to, within limits.
void random_poses_stay_within_limits(std::string_view name);
/// Its ball's farthest point is the body's own farthest point.
void ball_reaches_as_far_as_the_body(std::string_view name, const Distance& distance);
/// As usually held, in a light press, it looks at no more than 10 times what it presses.
void looks_where_it_touches(std::string_view name);
/// What is felt agrees within `share` on four grids, from 100 x 180 to 800 x 720, pressed 1 mm
/// deep.
void force_does_not_depend_on_the_grid(std::string_view name, double share);

/// A place at which the tool as usually held presses a wall of `outer` radius `deep` (m) in, at
/// height `y` and at `angle` (rad).
ToolPlace pressing(const ToolShape& shape, const ToolSize& size, double outer, double deep,
                   double y, double angle);

/// Pressed into a fresh wall, it feels the same to `share` wherever elements lie under it.
void force_is_even(std::string_view name, double share);

}  // namespace onggi::body_checks
