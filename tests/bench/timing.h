#pragma once

#include <time.h>

#include <chrono>
#include <cstdint>
#include <vector>

#include "tests/support/tick_scripts.h"

namespace onggi::bench {

/// Of many ticks' times, ns, wall clock.
struct Times {
  double median = 0, p99 = 0, p999 = 0, worst = 0;
};
/// Nearest rank. Sorts `ns`; must not be empty.
Times times_of(std::vector<double>& ns);

/// How long `work` takes, ns, with the clock's own clock_ns().
template <class Work>
double timed(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
}

/// What timed() gives for no work at all: the median, about 25 ns.
double clock_ns();

/// Time that this thread had a processor for since it began, ns: what others take is not in it.
inline double thread_ns() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

/// Ticks of a script in a whole Scene.
struct ScriptTimes {
  Times wall;              ///< Of every tick.
  Times cpu;               ///< The same in the thread's own time, with about 0.5 us of the clock.
  double visited = 0;      ///< Elements a tick.
  double touched = 0;      ///< Elements a tick.
  std::uint64_t hash = 0;  ///< After the script's first kHashTicks ticks, however many follow.
};
inline constexpr int kHashTicks = 200;
inline constexpr double kTickNs = 1e9 * kTickSeconds;  ///< What a tick has.

/// How many ticks are timed, each alone: at least `ticks`, and more until they took `seconds` or
/// are `most`. All of them count.
struct Patience {
  int ticks, most;
  double seconds;
};

ScriptTimes measure_script(const TickScript& script, int rows, int sectors,
                           const Patience& patience);

/// Medians of two or more works done in turns, `batch` ticks of each, so that all meet the same
/// weather; less clock_ns(), which would draw ratios towards 1. A work is called with the tick's
/// number within a pass of `pass` ticks.
struct Work {
  virtual ~Work() = default;
  virtual void tick(int n) noexcept = 0;
  virtual void freshen() = 0;  ///< Before tick 0; not timed.
};
std::vector<double> medians_in_turns(const std::vector<Work*>& works, int pass, int ticks,
                                     int batch);

}  // namespace onggi::bench
