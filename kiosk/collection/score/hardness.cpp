#include "kiosk/collection/score/hardness.h"

#include <algorithm>
#include <cmath>

#include "engine/math/portable.h"

namespace onggi::score {

namespace {
constexpr int kPieces = 24;    // of the height, as long as a fingertip feels
constexpr double kFlat = 0.2;  // for each time that the width is e times the height
}  // namespace

double hardness(const Profile& vessel) {
  const double piece = vessel.height() / kPieces;
  double most = 0.0;
  for (int i = 0; i < kPieces; ++i) {
    const double out = std::abs(vessel.outer_at((i + 1) * piece) - vessel.outer_at(i * piece));
    most = std::max(most, out / std::sqrt(out * out + piece * piece));
  }
  return most + kFlat * std::max(0.0, portable::log(2.0 * vessel.max_radius() / vessel.height()));
}

std::optional<std::size_t> next_in_hardness(const Profile& of, bool harder,
                                            std::span<const Profile* const> among) {
  const double own = hardness(of);
  std::optional<std::size_t> next;
  double least = 0.0;
  for (std::size_t i = 0; i < among.size(); ++i) {
    if (among[i] == nullptr || among[i] == &of || among[i]->points.empty()) continue;
    const double away = (hardness(*among[i]) - own) * (harder ? 1.0 : -1.0);
    if (away <= 0.0 || (next && away >= least)) continue;
    next = i;
    least = away;
  }
  return next;
}

}  // namespace onggi::score
