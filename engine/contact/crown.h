#pragma once

#include "engine/clay/clay.h"
#include "engine/clay/wall_side.h"
#include "engine/math/vec.h"

namespace onggi::contact {

/// The push of clay on a ball near an edge: a pot's rim, or a solid top. Each point of the ball's
/// surface bears a pressure that depends only on its distance from the clay's surface. So the push
/// is the gradient of an energy, and has no steps. A tool led round in clay that keeps its shape
/// gets back the work it did, wherever it enters and leaves. On a flat face, far from edges, it is
/// the wall's law (engine/docs/contact.md).
struct EdgePush {
  Vec3 face, top;  ///< On the ball, per N/m^3 of stiffness, m^3, clay frame: from points nearer to
                   ///< a face of the wall, and from points nearer to the top.
  double face_normal = 0, top_normal = 0;  ///< The same sums without direction.
};

/// The push on a ball of `radius` (m) at `at` (clay frame), which works the face `side`. `top` is
/// the height of the clay's upper end there, m; it is flat except for the lip. `hollow`: the clay
/// has an inner face. No allocation; O(1).
EdgePush push_at_edge(const Clay& clay, WallSide side, Vec3 at, double radius, double top,
                      bool hollow) noexcept;

/// The pressure on a ball at `deep` (m, >= 0) within clay, divided by the stiffness, m; `deep` to
/// first order. Times k_A it adds up to the wall's law, k_A sum of l n A, on any flat face.
double pressure_at(double deep, double radius) noexcept;

/// The upward push of an endless flat top on a ball whose lowest point is `depth` (m) below it, for
/// each N/m^3 of stiffness, m^3.
double push_on_flat(double depth, double radius) noexcept;

}  // namespace onggi::contact
