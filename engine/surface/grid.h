#pragma once

#include <cstdint>

namespace onggi::surface {

/// Cells round the pot. Whole for repeats of 2 to 8, 10, 12, 14, 15 and 16; none for 9, 11 and 13.
inline constexpr int kSectors = 1680;
/// Height of a row of cells, um along the outline.
inline constexpr int kRowHeight = 250;
/// Parts of a sector, in which a place round the pot is told.
inline constexpr int kParts = 1024;
/// One whole turn.
inline constexpr int kTurn = kSectors * kParts;

/// Thickness is whole nanometres, area whole square micrometres: a volume is their product,
/// 1e-21 m^3, and every sum of volumes is exact. A pot of 1 m^2 under 4 mm has 4e18 of them.
using Volume = std::int64_t;
inline constexpr Volume kNanometres = 1000;  ///< In a micrometre.

/// The cell round the pot, 0..kSectors - 1, for a number that may have gone round.
constexpr int wrapped(std::int64_t sector) {
  const auto left = static_cast<int>(sector % kSectors);
  return left < 0 ? left + kSectors : left;
}

/// Towards minus infinity, by which turning changes no rounding. b > 0.
constexpr std::int64_t floor_div(std::int64_t a, std::int64_t b) {
  return a / b - (a % b < 0 ? 1 : 0);
}
constexpr std::int64_t ceil_div(std::int64_t a, std::int64_t b) { return -floor_div(-a, b); }

}  // namespace onggi::surface
