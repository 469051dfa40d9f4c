#pragma once

#include <cstdint>
#include <string>

namespace onggi::watch {

/// What has to go on while the exhibit is open, as counts that only grow.
struct Moves {
  std::uint64_t frames = 0;   ///< Pictures made.
  std::uint64_t ticks = 0;    ///< Times that the wheel's loop woke.
  std::uint64_t devices = 0;  ///< Turns of the hand devices' threads: the least of them.
};

/// Whether all of them go on. A process whose threads stand must not look alive.
class Pulse {
 public:
  /// A part that has not moved for `patience` seconds stands.
  explicit Pulse(double patience) : patience_(patience) {}

  /// `now` in seconds on a clock that never goes back. True while every part moves. No allocation.
  bool beats(const Moves& moves, double now);
  /// "the wheel's loop", "the picture", "a hand device", or "" while all move: as of the last
  /// beats().
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
