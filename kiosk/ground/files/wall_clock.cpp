#include "kiosk/ground/files/wall_clock.h"

#include <atomic>

namespace onggi::files {

namespace {
std::atomic<std::int64_t> ahead_s{0};
}  // namespace

std::time_t wall_now() {
  return std::time(nullptr) + static_cast<std::time_t>(ahead_s.load(std::memory_order_relaxed));
}

void set_wall_ahead(std::int64_t seconds) { ahead_s.store(seconds, std::memory_order_relaxed); }

}  // namespace onggi::files
