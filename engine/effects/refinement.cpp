#include "engine/effects/refinement.h"

#include <algorithm>

#include "engine/clay/row_division.h"

namespace onggi::effects {
namespace {

// Below this share of the scene's spare rows, rows are joined to free more.
constexpr double kFew = 0.125;

}  // namespace

// The first pair, from the last one on, that may be joined. Examines a few pairs; pairs take turns.
Refinement::Change Refinement::joined(const Clay& clay) noexcept {
  const double first = clay.first_thickness();
  for (int n = 0; n < clay.rows(); ++n) {
    const int j = join_from_ = (join_from_ + 1) % clay.rows();
    if (!clay::may_join(clay, j)) continue;
    const double low = clay.row_thickness(j);
    const double high = clay.row_thickness(j + 1);
    if (low + high > kJoined * first) continue;
    const bool alike = clay::join_error(clay, j) <= kJoinError * std::min(low, high);
    return {alike ? Change::Kind::join : Change::Kind::none, j};
  }
  return {};
}

Refinement::Change Refinement::next(const Clay& clay, Volume& volume) noexcept {
  const int j = volume.take_thick(clay, kDivided, divide_from_);
  if (j >= 0) {
    divide_from_ = j + 1;
    if (clay::may_divide(clay, j)) return {Change::Kind::divide, j};
    volume.ask_again(j);
  }
  if (clay.spare_rows() >= kFew * spare_rows(clay.def())) return {};
  return joined(clay);
}

void Refinement::add_to(StateHash& hash) const {
  if (divide_from_ == 0 && join_from_ == 0) return;
  hash.add(static_cast<std::uint64_t>(divide_from_) << 32 | static_cast<std::uint64_t>(join_from_));
}

}  // namespace onggi::effects
