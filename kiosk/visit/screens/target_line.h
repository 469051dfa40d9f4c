#pragma once

#include "kiosk/picture/view/camera.h"
#include "kiosk/visit/screens/page.h"

namespace onggi::screens {

/// The target as a thin line at both silhouettes, in the plane through the axis that faces the
/// camera. Where `made` is too wide: warm, solid and stronger; too narrow: cool and dashed; close
/// enough: thin. `made` may be empty.
void draw_ghost(Page& page, const view::Camera& camera, const Profile& target, const Profile& made);

/// An arrow at `height` on the right of `target`'s outline: with `inward` from outside towards the
/// axis, else from inside outwards.
void draw_press(Page& page, const view::Camera& camera, const Profile& target, double height,
                bool inward);

/// How far `made` may be from `target`'s outer radius and still count as alike, metres.
double tolerance(const Profile& target);

}  // namespace onggi::screens
