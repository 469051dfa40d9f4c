#include "kiosk/wheel/device/stop_forces_on_terminate.h"

#include <time.h>

#include <atomic>
#include <exception>

namespace onggi::device {

namespace {

std::atomic<bool> ends{false};
std::terminate_handler before = nullptr;

[[noreturn]] void let_go_and_end() noexcept {
  stop_all_forces();
  // Links run every 2 ms, and this thread is not one of theirs.
  const timespec wait{0, static_cast<long>(kLastWord * 1e9)};
  nanosleep(&wait, nullptr);
  if (before != nullptr) before();
  __builtin_trap();
}

}  // namespace

bool program_ends() noexcept { return ends.load(std::memory_order_relaxed); }
void stop_all_forces() noexcept { ends.store(true, std::memory_order_relaxed); }

void stop_forces_on_terminate() noexcept { before = std::set_terminate(let_go_and_end); }

}  // namespace onggi::device
