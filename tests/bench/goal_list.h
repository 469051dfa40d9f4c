#pragma once

#include <span>

namespace onggi::bench {

/// What a counter of tick_bench is wanted to be, on whatever machine, in each run. The table of
/// tests/bench/README.md has the same, and says what is missed and why; bench_test.py holds the one
/// to the other.
struct Goal {
  const char* counter;
  bool at_least;  ///< Or at most.
  double bound;
};
std::span<const Goal> goals();

}  // namespace onggi::bench
