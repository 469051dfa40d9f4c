#pragma once

#include "engine/clay/clay.h"
#include "engine/clay/wall_side.h"
#include "engine/math/vec.h"

namespace onggi::contact {

/// What clay pushes a ball by near an edge of it: of a pot's rim, or of a solid top. Each point of
/// the ball's surface bears a pressure that is a figure of its place in the clay alone, of how far
/// that is from the clay's surface. So the push is the gradient of an energy: a tool that is led
/// round in clay that keeps its shape gets back what it gave, wherever it comes in and goes out,
/// and nothing has a step. On a flat face, far from edges, it is the wall's law
/// (engine/docs/contact.md).
struct EdgePush {
  Vec3 face, top;  ///< On the ball, for each N/m^3 of stiffness: of points nearer to a face of the
                   ///< wall, and of those nearer to the top. Clay frame, m^3.
  double face_normal = 0, top_normal = 0;  ///< Their sums without direction.
};

/// Of a ball of `radius` (m) at `at` (clay frame), which works the face `side`. `top` is the height
/// of the clay's upper end there, which is flat but for the lip, m; `hollow`: it has an inner face.
/// No allocation; O(1).
EdgePush push_at_edge(const Clay& clay, WallSide side, Vec3 at, double radius, double top,
                      bool hollow) noexcept;

/// The pressure at `deep` (m, >= 0) within clay that presses a ball, over the stiffness, m: k_A
/// times that adds up to the wall's law, k_A sum of l n A, on any flat face. `deep` to first order.
double pressure_at(double deep, double radius) noexcept;

/// The same on an endless flat top that the ball's lowest point is `depth` (m) below: upward, m^3.
double push_on_flat(double depth, double radius) noexcept;

}  // namespace onggi::contact
