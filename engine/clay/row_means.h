#pragma once

#include <span>

#include "engine/profile/profile.h"

namespace onggi::clay {

/// Mean of a row's radii, metres: summed from sector 0 on, in double, and divided once. All code
/// takes a row's mean from here, so that a pot has one outline, to the bit.
double row_mean(std::span<const float> radii) noexcept;

/// The outline of rows whose middles are at `middle` (metres, one a row, at least one), and whose
/// mean radii are `outer` and `inner` (0 where solid), up to `rim`: it stands on the wheel head and
/// ends at the rim, half a row beyond the outermost middles. A row that is not above those before
/// it, or not below the rim, is left out: of a clay there is none, of one seen while rows are on
/// their way some lie where others were. Allocates.
Profile outline_of(std::span<const double> middle, std::span<const double> outer,
                   std::span<const double> inner, double rim);

}  // namespace onggi::clay
