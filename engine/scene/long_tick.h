#pragma once

namespace onggi::scene {

/// Effects on rows come after the press and not during it, which is wrong by as much as clay moves
/// in between. Where there are any, a tick of `seconds`, 1e-6..0.005, is therefore worked in so
/// many parts of about kPart (s), 1..5, each as a tick of that length would be.
inline constexpr double kPart = 0.001;
constexpr int parts_of(double seconds) {
  const int parts = static_cast<int>(seconds / kPart + 0.5);
  return parts > 1 ? parts : 1;
}

}  // namespace onggi::scene
