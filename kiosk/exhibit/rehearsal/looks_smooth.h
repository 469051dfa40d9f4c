#pragma once

#include "engine/profile/profile.h"

namespace onggi::rehearsal {

/// How smooth a pot's outline feels to a passing hand. Metres.
struct Smoothness {
  double roughness = 0;  ///< RMS of the outer radius around its mean over 10 mm of height.
  double ledge = 0;      ///< Largest change within a millimetre, beyond its slope over 10 mm.
};

/// For a profile at least 20 mm high. The five millimetres at foot and rim, where a mean lacks
/// neighbours, count only for the ledge. Sampled every half millimetre. Allocates.
Smoothness smoothness(const Profile& made);

/// A pot that people would show to others: roughness under 0.3 mm and no ledge over 2 mm.
bool looks_smooth(const Smoothness& s);

/// Distance of two outlines: RMS of the outer radius over the height of the lower one, sampled
/// every half millimetre, metres; or the difference of their heights if that is more.
double outline_distance(const Profile& a, const Profile& b);

}  // namespace onggi::rehearsal
