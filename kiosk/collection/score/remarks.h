#pragma once

#include "kiosk/collection/score/score.h"

namespace onggi::score {

/// The length that differences are compared with: the height, or for wide vessels the geometric
/// mean of height and width. Metres.
double size_of(const Dimensions& target);

/// An opening that lacks a smaller share is open enough, because walls vary in thickness.
inline constexpr double kOpenEnough = 0.15;

/// What is alike, best first; one to three remarks.
std::vector<Remark> alike(const Measures& m, bool scale_free);

/// Removes from `alike` the part that `largest` is about, unless it is the only one, so that the
/// same part is not praised and criticised.
void take_back(std::vector<Remark>& alike, const Remark& largest);

/// The place where the two are furthest apart, and by how much: a named part with its difference in
/// the dimensions, or a height of 1 to 99 percent.
std::optional<Remark> largest_difference(const Measures& m, bool scale_free, double true_scale);

/// Advice, largest difference first; at most three.
std::vector<Remark> try_next(const Measures& m, bool scale_free, double true_scale);

}  // namespace onggi::score
