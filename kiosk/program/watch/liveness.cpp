#include "kiosk/program/watch/liveness.h"

namespace onggi::watch {

bool Liveness::Part::moves(std::uint64_t to, double now, double patience) {
  if (to != count || moved_at < 0.0) {
    count = to;
    moved_at = now;
  }
  return now - moved_at < patience;
}

bool Liveness::beats(const Moves& moves, double now) {
  frames_move_ = frames_.moves(moves.frames, now, patience_);
  ticks_move_ = ticks_.moves(moves.ticks, now, patience_);
  devices_move_ = devices_.moves(moves.devices, now, patience_);
  return frames_move_ && ticks_move_ && devices_move_;
}

std::string Liveness::standing() const {
  if (!ticks_move_) return "the wheel's loop";
  if (!frames_move_) return "the picture";
  return devices_move_ ? "" : "a hand device";
}

}  // namespace onggi::watch
