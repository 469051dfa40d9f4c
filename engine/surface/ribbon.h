#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "engine/surface/station.h"

namespace onggi::surface {

/// A point on the surface. um along the outline, kParts of a sector round.
struct Corner {
  std::int64_t along = 0, round = 0;
};
using Quad = std::array<Corner, 4>;  ///< In order round it.

/// The row of `along`, or the nearest one.
inline int row_of(const Surface& surface, std::int64_t along) {
  return static_cast<int>(
      std::clamp<std::int64_t>(floor_div(along, kRowHeight), 0, surface.rows() - 1));
}

/// The point beside a station, `offset` um to its left. Neighbouring tracks, and the pieces before
/// and behind a station, share such points to the bit: so they share no cell and leave none out.
Corner beside(const Surface& surface, const Station& at, std::int64_t offset);

/// The quad from one station to the next, between two offsets (um) at each.
inline Quad piece(const Surface& surface, const Station& a, const Station& b, std::int64_t a_low,
                  std::int64_t a_high, std::int64_t b_low, std::int64_t b_high) {
  return {beside(surface, a, a_low), beside(surface, a, a_high), beside(surface, b, b_high),
          beside(surface, b, b_low)};
}

/// Of the edge from `a` to `b`, the first sector whose middle lies beyond it in the row with its
/// middle at `y`; nothing where the edge does not cross that row.
inline std::optional<std::int64_t> crossing_of(Corner a, Corner b, std::int64_t y) {
  if (a.along > b.along) std::swap(a, b);
  if (y < a.along || y >= b.along) return std::nullopt;
  const std::int64_t rise = b.along - a.along;
  return ceil_div((a.round - kParts / 2) * rise + (y - a.along) * (b.round - a.round),
                  kParts * rise);
}

/// Calls `visit(row, sector)` for each cell whose middle lies in `quad`: of two quads with a common
/// edge exactly one has it. A quad that crosses itself has both its lobes.
template <class Visit>
void each_cell_in(const Surface& surface, const Quad& quad, Visit&& visit) {
  std::int64_t low = quad[0].along, high = low;
  for (const Corner& corner : quad)
    low = std::min(low, corner.along), high = std::max(high, corner.along);
  const std::int64_t half = kRowHeight / 2;
  const std::int64_t first = std::max<std::int64_t>(ceil_div(low - half, kRowHeight), 0);
  const std::int64_t last =
      std::min<std::int64_t>(floor_div(high - half, kRowHeight), surface.rows() - 1);
  for (std::int64_t row = first; row <= last; ++row) {
    std::array<std::int64_t, 4> crossings{};
    std::size_t count = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto found = crossing_of(quad[k], quad[(k + 1) % 4], row * kRowHeight + half);
      if (!found) continue;
      std::int64_t at = *found;
      for (std::size_t n = 0; n < count; ++n)  // in order
        if (crossings[n] > at) std::swap(crossings[n], at);
      crossings[count++] = at;
    }
    for (std::size_t k = 0; k + 1 < count; k += 2)
      for (std::int64_t i = crossings[k]; i < crossings[k + 1]; ++i)
        visit(static_cast<int>(row), wrapped(i));
  }
}

/// Calls `visit(row, sector, distance, left)` for each cell whose middle is within `reach` um of
/// the straight way from `a` to `b`: its distance from it in um, and whether it lies to the left.
template <class Visit>
void each_cell_near(const Surface& surface, Corner a, Corner b, std::int64_t reach, Visit&& visit) {
  const int first = row_of(surface, std::min(a.along, b.along) - reach);
  const int last = row_of(surface, std::max(a.along, b.along) + reach);
  for (int row = first; row <= last; ++row) {
    const std::int64_t width = surface.row(row).width;
    // Round, in um of this row.
    const auto um = [&](std::int64_t parts) {
      return floor_div(parts * width + kParts * kNanometres / 2, kParts * kNanometres);
    };
    const std::int64_t up = b.along - a.along, on = um(b.round - a.round);
    const std::int64_t square = up * up + on * on;
    const double length = std::sqrt(static_cast<double>(square));
    const std::int64_t y = std::int64_t{row} * kRowHeight + kRowHeight / 2 - a.along;
    const std::int64_t parts = reach * kParts * kNanometres / width + kParts;
    const std::int64_t begin = floor_div(std::min(a.round, b.round) - parts, kParts);
    const std::int64_t end = std::min(floor_div(std::max(a.round, b.round) + parts, kParts),
                                      begin + kSectors - 1);  // each cell once
    for (std::int64_t i = begin; i <= end; ++i) {
      const std::int64_t x = um(i * kParts + kParts / 2 - a.round);
      const std::int64_t ahead = x * on + y * up, left = x * up - y * on;
      std::int64_t far = 0;  // squared
      if (ahead <= 0) {
        far = x * x + y * y;
      } else if (ahead >= square) {
        far = (x - on) * (x - on) + (y - up) * (y - up);
      } else {
        far = left * left / square;
      }
      if (far > reach * reach) continue;
      const double across = square == 0 ? 0.0 : static_cast<double>(left) / length;
      visit(row, wrapped(i), static_cast<std::int64_t>(std::sqrt(static_cast<double>(far))),
            static_cast<std::int64_t>(std::floor(across)));
    }
  }
}

}  // namespace onggi::surface
