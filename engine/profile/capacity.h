#pragma once

#include "engine/profile/profile.h"

namespace onggi {

/// The capacity of `profile`, filled to its rim, m^3: between its floor (the lowest point with an
/// inner radius) and its rim, by its inner radii, linear between points. 0 if it is solid. No
/// allocation.
double capacity(const Profile& profile);

}  // namespace onggi
