#pragma once

#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "kiosk/ground/files/descriptor.h"
#include "kiosk/program/watch/kiosk_state.h"

namespace onggi::watch {

/// Where the running kiosk's state is posted for staff (look_at_kiosk()): a file in the folder of
/// its keepsakes, written in place, so that it can be written on a full disk too, and locked while
/// the process lives, so that a kiosk that was killed does not look alive. Where another kiosk has
/// the lock, or the folder is not there yet, nothing is written, and it is tried again. The disk
/// has a thread of its own; a state is soon lost in a power cut, and nobody needs it then.
class StateBoard {
 public:
  /// Time between two writes, s, where nothing but counts has changed. A new doing, device or
  /// trouble is written at once.
  static constexpr double kEvery = 10.0;

  explicit StateBoard(std::filesystem::path keepsakes);
  /// Writes that the kiosk has ended.
  ~StateBoard();

  /// Main thread, about once a second. Never waits for the disk.
  void show(KioskState state);

 private:
  void attend();
  bool hold_file();
  bool write(const KioskState& state);

  const std::filesystem::path keepsakes_;
  std::mutex mutex_;  // guards the members below
  std::condition_variable wake_;
  std::optional<KioskState> state_;
  bool ending_ = false;

  // The thread's own members.
  files::Descriptor file_;
  std::size_t written_ = 0;  // bytes of the file
  std::thread thread_;
};

}  // namespace onggi::watch
