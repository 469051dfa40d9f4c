#pragma once

namespace onggi::scene {

/// Effects on rows run after the press, not during it, so the error grows with the motion in
/// between. With such effects a tick of `seconds`, 1e-6..0.005, is therefore worked in 1..5 parts
/// of about kPart (s), each like a tick of that length.
inline constexpr double kPart = 0.001;
constexpr int parts_of(double seconds) {
  const int parts = static_cast<int>(seconds / kPart + 0.5);
  return parts > 1 ? parts : 1;
}

}  // namespace onggi::scene
