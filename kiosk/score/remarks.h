#pragma once

#include "kiosk/score/score.h"

namespace onggi::score {

/// The length that differences are judged against: the height, or for vessels wider than tall the
/// geometric mean of height and width. Metres.
double size_of(const Dimensions& target);

/// What is alike, best first; one to three.
std::vector<Remark> alike(const Measures& m, bool scale_free);

/// What to try, largest difference first; at most three.
std::vector<Remark> try_next(const Measures& m, bool scale_free, double true_scale);

}  // namespace onggi::score
