#pragma once

#include "kiosk/collection/score/score.h"

namespace onggi::score {

/// Turns millimetres in a remark into a part of the length it is about: "remark.neck_wide {mm}"
/// becomes "remark_part.neck_wide {part}". `part` is in percent, one of those that languages have
/// words for ("part.20": a fifth). `true_scale` is the scale of the remark's millimetres. Other
/// remarks are returned unchanged. Allocates.
Remark in_parts(Remark remark, const Measures& measures, double true_scale);

/// Every key that in_parts() can add, and the words for the parts.
std::vector<std::string> part_keys();

}  // namespace onggi::score
