#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "engine/profile/profile.h"

namespace onggi::score {

/// How far apart two vessels' outlines run, radians, 0..pi: the L2 distance of their turning
/// functions, after Arkin, Chew, Huttenlocher, Kedem and Mitchell, "An efficiently computable
/// metric for comparing polygonal shapes", IEEE PAMI 13(3), 1991. The outline goes from the axis
/// under the foot along foot, outer wall and mouth to the axis again; its turning function is the
/// direction it runs in, over the share of its length that is behind. Vessels stand upright and
/// begin at the axis, so neither rotation nor starting point is sought for. A metric: 0 for the
/// same shape only, the same both ways, and no detour is shorter. Size does not count. Both valid.
/// Allocates; the same bits on every machine.
double turning_apart(const Profile& a, const Profile& b);

/// The same as a likeness of two vessels, 0..100: 100 for the same shape, 50 if the outlines run 45
/// degrees apart. It never levels off, so that unlike vessels can still be ranked. A visitor's
/// points (judge()) measure how near an answer came; they are 0 for most pairs.
double likeness(const Profile& a, const Profile& b);

/// The vessel of `among` that is most like `to`, at least kAlikeEnough; the first of equals; none
/// if no vessel is. Null and `to` itself are skipped. Allocates.
inline constexpr double kAlikeEnough = 65.0;
std::optional<std::size_t> most_alike(const Profile& to, std::span<const Profile* const> among);

}  // namespace onggi::score
