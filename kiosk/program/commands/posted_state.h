#pragma once

#include <filesystem>
#include <memory>

#include "kiosk/exhibit/composition/kiosk.h"
#include "kiosk/program/watch/health.h"
#include "kiosk/program/watch/state_board.h"

namespace onggi::commands {

/// The counts of `kiosk` so far, into `health`. Call once a frame: it counts the frames.
void count_frame(exhibit::Kiosk& kiosk, watch::Health& health);

/// Tells the staff of this machine how the open kiosk is (StateBoard). Main thread.
class PostedState {
 public:
  /// A kiosk was opened, whose counts begin anew. `config`: the exhibit that it shows; `stands_in`:
  /// for the museum's.
  void shows(const exhibit::Kiosk& kiosk, const std::filesystem::path& config, bool stands_in);
  /// Call once a frame; `now` in seconds on a clock that never goes back.
  void look(exhibit::Kiosk& kiosk, double now);

 private:
  watch::KioskState state_;
  std::filesystem::path keepsakes_;
  std::unique_ptr<watch::StateBoard> board_;
  double began_ = -1.0, told_ = -1e9;
  std::uint64_t frames_told_ = 0;
};

}  // namespace onggi::commands
