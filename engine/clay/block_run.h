#pragma once

namespace onggi {

/// Eight elements of a row side by side: [begin, end) in blocks.
struct BlockRun {
  int begin, end;
  bool any() const { return begin < end; }
};

}  // namespace onggi
