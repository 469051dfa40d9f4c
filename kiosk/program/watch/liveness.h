#pragma once

#include <cstdint>
#include <string>

namespace onggi::watch {

/// Counts that must keep growing while the exhibit is open.
struct Moves {
  std::uint64_t frames = 0;   ///< Frames drawn.
  std::uint64_t ticks = 0;    ///< Wakes of the wheel's loop.
  std::uint64_t devices = 0;  ///< Turns of the hand devices' threads: the smallest count.
};

/// Checks that all counts grow, because a process with a stuck thread must not look alive.
class Liveness {
 public:
  /// A count that has not grown for `patience` seconds means a stuck part.
  explicit Liveness(double patience) : patience_(patience) {}

  /// `now` in seconds on a clock that never goes back. True while every part runs. No allocation.
  bool beats(const Moves& moves, double now);
  /// "the wheel's loop", "the picture", "a hand device", or "" if all ran at the last beats().
  std::string standing() const;

 private:
  struct Part {
    std::uint64_t count = 0;
    double moved_at = -1.0;
    bool moves(std::uint64_t to, double now, double patience);
  };
  double patience_;
  Part frames_, ticks_, devices_;
  bool frames_move_ = true, ticks_move_ = true, devices_move_ = true;
};

}  // namespace onggi::watch
