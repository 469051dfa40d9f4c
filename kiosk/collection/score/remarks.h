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

/// What a pot has lost of its points, as shares of those that are left without it, 0..1.
struct Lost {
  double round = 0, wall = 0;
  double shape = 0;  ///< All else.
};

/// How a pot is spoken of.
struct Asked {
  bool scale_free = true;
  double true_scale = 1.0;
  /// The hands followed the vessel's line at its own size. Where the pot ends below the line, its
  /// widths are not too wide only because it is scaled up: it is too short.
  bool by_line = false;
  Lost lost{};
  double ripples = 0;  ///< ripples(), metres.
};

/// Advice, largest difference first; at most three. A wall that does not run true or is uneven
/// comes before the shape where it cost more.
std::vector<Remark> try_next(const Measures& m, const Asked& asked);

}  // namespace onggi::score
