#pragma once

#include <array>
#include <span>
#include <vector>

#include "engine/surface/surface.h"

namespace onggi::surface {

/// Height of clay and slip over the reference body, without the grain of the codes. A slip's
/// thickness is kept in steps of a fifth (strata.h), and what rounding leaves goes on to the next
/// cell: cells of an even coat differ by one step or two, which shows under a gloss. This is the
/// mean of the 5 x 5 cells round a cell that differ from it by half of its slip at the most, the
/// sigma filter (Lee 1983): the edge of a coat stays an edge, and bare clay is as it is. A coat's
/// streaks finer than a millimetre go with the grain. Whole numbers, the same bits on every
/// machine. Not safe across threads.
class EvenBase {
 public:
  /// Of `count` sectors (1..kSectors) from `first` on, which may go round. `surface` must not
  /// change. Allocates.
  EvenBase(const Surface& surface, int first, int count);
  /// Row j, nm; valid until the next call. Rows beyond the ends are the first and the last. Cheap
  /// if rows are asked for in turn: some 20 ns a cell.
  std::span<const int> row(int j);

 private:
  static constexpr int kReach = 2, kKept = 2 * kReach + 1;
  struct Read {
    int row = -1;
    bool slip = false;       ///< Somewhere.
    std::vector<int> base;   ///< kReach sectors more at both ends.
    std::vector<int> apart;  ///< By how much others may differ.
  };
  const Read& read(int j);

  const Surface* surface_;
  int first_, count_;
  std::array<Read, kKept> read_;
  std::vector<int> out_, sum_, cells_;
};

}  // namespace onggi::surface
