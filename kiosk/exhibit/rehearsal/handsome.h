#pragma once

#include "engine/profile/profile.h"

namespace onggi::rehearsal {

/// How a pot's outline looks to a hand that passes over it. Metres.
struct Smoothness {
  double roughness = 0;  ///< RMS of the outer radius about its own mean over 10 mm of height.
  double ledge =
      0;  ///< The most that it changes by within a millimetre, beyond its slope over 10 mm.
};

/// Of a profile at least 20 mm high; the five millimetres at foot and rim, where a mean has no
/// neighbours, belong to the ledge alone. Sampled every half millimetre. Allocates.
Smoothness smoothness(const Profile& made);

/// What people would show to others: roughness under 0.3 mm and no ledge over 2 mm.
bool handsome(const Smoothness& s);

/// How far two outlines lie apart: RMS of the outer radius over the height of the lower, sampled
/// every half millimetre, metres; and the difference of their heights where that is more.
double apart(const Profile& a, const Profile& b);

}  // namespace onggi::rehearsal
