#pragma once

#include "engine/profile/profile.h"

namespace onggi::score {

/// How deep the ripples of `made` are that `vessel` has not, as a diameter: a quick hand leaves
/// ring upon ring. 0 if its outline swings in and out no more often than the vessel's, however
/// wrong its shape is. `made` is seen at the vessel's height. Metres; the same bits on every
/// machine. Both valid.
double ripples(const Profile& vessel, const Profile& made);

}  // namespace onggi::score
