#pragma once

#include <optional>

#include "engine/profile/profile.h"
#include "kiosk/picture/view/frame.h"
#include "kiosk/picture/view/image.h"

namespace onggi::exhibit {

/// The pot alone, for the gallery. Without its pot: the plaster behind it.
view::Frame small_picture(const Profile& made, const std::optional<view::Glazing>& glazing);
view::Frame without_pot(view::Frame picture);

/// `picture`, drawn of `made` by `camera`, with its shadow fading out into `plaster` all round, so
/// that no edge of the picture cuts it off. The pot itself stays as it is.
view::Image with_soft_shadow(view::Image picture, const view::Image& plaster,
                             const view::Camera& camera, const Profile& made);

}  // namespace onggi::exhibit
