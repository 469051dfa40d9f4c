#pragma once

#include "kiosk/collection/score/score.h"

namespace onggi::score {

/// The length that differences are judged against: the height, or for vessels wider than tall the
/// geometric mean of height and width. Metres.
double size_of(const Dimensions& target);

/// A way in that lacks less of the vessel's own is open enough: walls are thicker and thinner.
inline constexpr double kOpenEnough = 0.15;

/// What is alike, best first; one to three.
std::vector<Remark> alike(const Measures& m, bool scale_free);

/// Takes out of `alike` the part that `largest` is about, unless it is all there is: what is
/// called right is not called wrong in the next line.
void take_back(std::vector<Remark>& alike, const Remark& largest);

/// Where the two are furthest apart, and by how much: a part by its name, which is then out by what
/// the dimensions say, or a height of 1 to 99 percent.
std::optional<Remark> largest_difference(const Measures& m, bool scale_free, double true_scale);

/// What to try, largest difference first; at most three.
std::vector<Remark> try_next(const Measures& m, bool scale_free, double true_scale);

}  // namespace onggi::score
