#pragma once

#include "kiosk/collection/score/score.h"

namespace onggi::score {

/// What a remark says in millimetres as a part of the length it is about: "remark.neck_wide {mm}"
/// becomes "remark_part.neck_wide {part}". `part` is in percent, one of those that languages have
/// words for ("part.20": a fifth). `true_scale` is that by which its millimetres were made. Others
/// come back as they are. Allocates.
Remark in_parts(Remark remark, const Measures& measures, double true_scale);

/// Every key that in_parts() adds, and the words of the parts themselves.
std::vector<std::string> part_keys();

}  // namespace onggi::score
