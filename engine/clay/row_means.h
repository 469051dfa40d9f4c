#pragma once

#include <span>

#include "engine/profile/profile.h"

namespace onggi::clay {

/// Mean of a row's radii, metres: summed from sector 0 on, in double, and divided once. All code
/// takes a row's mean from here, so that a pot has one outline, to the bit.
double row_mean(std::span<const float> radii) noexcept;

/// Sum of squares of a row's radii about their mean, m^2.
double row_spread(std::span<const float> radii, double mean) noexcept;

/// The outline of rows with middles `middle` (metres, at least one row) and mean radii `outer` and
/// `inner` (0 if solid), up to `rim`. It stands on the wheel head and ends at the rim, half a row
/// beyond the outermost middles. Rows out of order or above the rim are left out: a view may have
/// them while rows are in transit. Allocates.
Profile outline_of(std::span<const double> middle, std::span<const double> outer,
                   std::span<const double> inner, double rim);

}  // namespace onggi::clay
