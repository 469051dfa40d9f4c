#pragma once

#include <string>
#include <utility>
#include <vector>

namespace onggi::bench {

/// A figure by name, as Google Benchmark's counters and the CSV carry it.
using Figures = std::vector<std::pair<std::string, double>>;

/// A tail as p999_us_NAME, and as p999_of_tick_NAME: its share of the 1 ms that a
/// tick has.
void add_tail(Figures& figures, const std::string& name, double p999_ns);

/// How many ticks a figure is made of: all for a measurement, few to see that it works.
struct Effort {
  bool few = false;
  int ticks(int all) const { return few ? (all < 400 ? 4 : 40) : all; }
};

/// Each gives the goal's counter first, then what it is made of. tests/bench/README.md says what
/// every name means.
Figures paper_ratio(int rows, int sectors, Effort effort);
Figures floor_ratio(Effort effort);
Figures untouched_rows_ratio(Effort effort);
Figures bytes_in_the_papers_scene();

#ifdef ONGGI_WITH_OPENVDB
Figures openvdb_ratio(Effort effort);
#endif

}  // namespace onggi::bench
