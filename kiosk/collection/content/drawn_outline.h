#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/math/vec.h"

namespace onggi::content {

/// A drawn outline as a fine chain of straight lines; `drawn[i]` is the drawn point that chain
/// point i came from or follows.
struct Outline {
  std::vector<Vec2> points;
  std::vector<std::size_t> drawn;
};

/// A drawn point, and whether the line turns sharply there.
struct Knot {
  Vec2 at;
  bool corner = false;
};

/// A smooth line through `knots` (two or more, no two neighbours equal), in chain links no longer
/// than `link`. Both coordinates are monotone cubics of the chord length (Fritsch and Butland
/// 1984), so between two drawn points the line never leaves the rectangle they span. `level_end`
/// makes it arrive level at the last point, as a floor does on the axis.
Outline smooth_outline(const std::vector<Knot>& knots, double link, bool level_end);

/// The same points joined by straight lines.
Outline straight_outline(const std::vector<Knot>& knots);

/// The chain point of `b` where it comes nearer to chain `a` than `least`, or crosses it, and the
/// distance there (0 = crossing). Points of `b` nearer than `skip` along b to its start are
/// ignored, because the walls meet at the rim.
struct Narrow {
  std::size_t point = 0;
  double distance = 0.0;
};
std::optional<Narrow> too_near(const std::vector<Vec2>& a, const std::vector<Vec2>& b, double least,
                               double skip);

/// The chain point after which `chain` first crosses itself.
std::optional<std::size_t> self_crossing(const std::vector<Vec2>& chain);

/// Cuts `amount` off the end of `chain` (never all of it) and returns the new end.
Vec2 shorten(std::vector<Vec2>& chain, double amount);

/// A quarter round from `from` to `to`, ends included, that would have met at `corner`.
std::vector<Vec2> arc(Vec2 from, Vec2 corner, Vec2 to);

}  // namespace onggi::content
