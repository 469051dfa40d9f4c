#include "kiosk/ground/files/memory.h"

#include <sys/mman.h>
#include <sys/resource.h>

#include <atomic>
#include <cerrno>
#if __has_include(<malloc.h>)
#include <malloc.h>
#endif

namespace onggi::files {

namespace {

constexpr int kSpare = 32 * 1024 * 1024, kPad = 4 * 1024 * 1024;
std::atomic<bool> memory_locked = false;

int lock_all() noexcept {
  return mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) == 0 ? 0 : errno;
}

}  // namespace

void keep_heap_small() noexcept {
#if defined(M_MMAP_THRESHOLD) && defined(M_ARENA_MAX)
  mallopt(M_MMAP_THRESHOLD, 256 * 1024);
  mallopt(M_ARENA_MAX, 2);
  mallopt(M_TRIM_THRESHOLD, kSpare);
  mallopt(M_TOP_PAD, kPad);
#endif
}

int lock_memory() noexcept {
  rlimit limit{};
  // With a finite limit a later allocation anywhere would fail, so do not lock.
  if (getrlimit(RLIMIT_MEMLOCK, &limit) != 0 || limit.rlim_cur != RLIM_INFINITY) return EPERM;
  const int error = lock_all();
  memory_locked.store(error == 0);
  return error;
}

void give_back_memory() noexcept {
#if defined(M_MMAP_THRESHOLD)
  const bool locked = memory_locked.load();
  if (locked) munlockall();
  malloc_trim(0);
  if (locked) memory_locked.store(lock_all() == 0);
#endif
}

}  // namespace onggi::files
