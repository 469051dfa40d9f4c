#pragma once

#include "engine/clay/clay.h"
#include "engine/math/vec.h"

namespace onggi {

/// Blocks of eight elements of a row, [begin, end) in blocks.
struct BlockRange {
  int begin = 0;
  int end = 0;
};

/// Which elements a sphere going from one place to another can reach: rows by height, and in each
/// row one or two ranges of blocks round the tool's angle. Never leaves a reachable element out.
class Window {
 public:
  /// Clay frame, metres.
  Window(const Clay& clay, Vec3 from, Vec3 to, double radius) noexcept;

  int first_row() const { return first_row_; }
  int end_row() const { return end_row_; }  ///< One past the last.

  /// Ranges for a row where the sphere's cross-section has radius `section` (m). Gives how many of
  /// `ranges` are used: 0 where there is no section, 1, or 2 where the window passes angle 0. They
  /// never share a block.
  int blocks(double section, BlockRange (&ranges)[2]) const noexcept;

 private:
  double nearest_, per_radian_, middle_, turn_, half_per_section_;
  int sectors_, all_blocks_, first_row_, end_row_;
};

/// Radius of the sphere's cross-section `dy` from its centre; -1 where there is none. Factored, so
/// that nothing cancels near the poles.
double cross_section(double radius, double dy) noexcept;

}  // namespace onggi
