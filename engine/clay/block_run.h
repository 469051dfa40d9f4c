#pragma once

namespace onggi {

/// A run of blocks of a row, [begin, end). A block is eight elements side by side.
struct BlockRun {
  int begin, end;
  bool any() const { return begin < end; }
};

}  // namespace onggi
