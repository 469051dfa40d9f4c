#include "kiosk/loop/memory.h"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <fstream>
#include <memory>
#include <vector>

#include "tests/support/sanitized.h"

namespace onggi::loop {
namespace {

double resident_mib() {
  long all = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return static_cast<double>(resident * sysconf(_SC_PAGESIZE)) / 1048576.0;
}

/// 128 MiB in blocks of 64 KiB, of which every 16th stays: the others leave holes.
class Holes {
 public:
  Holes() {
    for (int i = 0; i < 2048; ++i) {
      blocks_.push_back(std::make_unique<Block>());
      blocks_.back()->fill(static_cast<char>(i));
    }
    for (std::size_t i = 0; i < blocks_.size(); ++i)
      if (i % 16 != 0) blocks_[i].reset();
  }

 private:
  using Block = std::array<char, 65536>;
  std::vector<std::unique_ptr<Block>> blocks_;
};

constexpr double kHoles = 120.0;

TEST(Memory, HolesInTheHeapGoBackToTheSystemBetweenTwoVisitors) {
  if (ONGGI_SANITIZED) GTEST_SKIP() << "a sanitizer owns malloc";
  keep_heap_small();
  const Holes holes;
  const double before = resident_mib();
  give_back_memory();
  EXPECT_LT(resident_mib(), before - 0.9 * kHoles);
}

TEST(Memory, HolesInAHeapThatIsLockedGoBackTooAndItStaysLocked) {
  if (ONGGI_SANITIZED) GTEST_SKIP() << "a sanitizer owns malloc";
  rlimit limit{RLIM_INFINITY, RLIM_INFINITY};
  if (setrlimit(RLIMIT_MEMLOCK, &limit) != 0) GTEST_SKIP() << "only root may lift the limit";
  if (lock_memory() != 0) GTEST_SKIP() << "no memory can be locked here";
  const Holes holes;
  const double before = resident_mib();
  give_back_memory();
  const double after = resident_mib();
  // What is locked cannot be thrown out.
  std::vector<char> page(2 * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)), 'x');
  const auto whole = (reinterpret_cast<std::uintptr_t>(page.data()) +
                      static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE)) - 1) &
                     ~static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE) - 1);
  EXPECT_NE(madvise(reinterpret_cast<void*>(whole), 1, MADV_DONTNEED), 0);
  munlockall();
  EXPECT_LT(after, before - 0.9 * kHoles);
}

TEST(Memory, BelowAnInfiniteLimitNothingIsLocked) {
  rlimit was{};
  ASSERT_EQ(getrlimit(RLIMIT_MEMLOCK, &was), 0);
  rlimit little = was;
  little.rlim_cur = 65536;
  ASSERT_EQ(setrlimit(RLIMIT_MEMLOCK, &little), 0);
  EXPECT_EQ(lock_memory(), EPERM);
  setrlimit(RLIMIT_MEMLOCK, &was);
}

}  // namespace
}  // namespace onggi::loop
