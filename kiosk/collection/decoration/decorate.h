#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/profile/profile.h"
#include "engine/surface/surface.h"
#include "kiosk/collection/decoration/decoration.h"

namespace onggi::decoration {

/// Pots on the wheel are no taller. m.
inline constexpr double kWheelHeight = 0.2;

/// The size at which a vessel of `profile`'s size is decorated, over its own: 1, or less for one
/// taller than kWheelHeight. Widths along the surface scale by it, coats and cuts' least depth do
/// not.
double wheel_scale(const Profile& profile);

/// A bare pot of `profile` (m, as the real vessel) at the wheel's size, with all steps of
/// `decoration` done in their order. `name` goes into the Problem of the first step that cannot be
/// done. Allocates some MB; any thread; tens of milliseconds.
Result<surface::Surface> decorated(const Profile& profile, const Decoration& decoration,
                                   const std::string& name);

/// Where the outline turns from outside to inside: the middle of the lip, um along it.
int lip_of(const surface::Surface& surface);

}  // namespace onggi::decoration
