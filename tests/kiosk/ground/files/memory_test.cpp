#include "kiosk/ground/files/memory.h"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <vector>

#include "tests/support/holes.h"
#include "tests/support/sanitized.h"

namespace onggi::files::memory_test {
namespace {

using onggi::test::Holes;
using onggi::test::resident_mib;

TEST(Memory, HolesInTheHeapGoBackToTheSystemBetweenTwoVisitors) {
  if (ONGGI_SANITIZED) GTEST_SKIP() << "a sanitizer owns malloc";
  keep_heap_small();
  const Holes holes;
  const double before = resident_mib();
  give_back_memory();
  EXPECT_LT(resident_mib(), before - 0.9 * Holes::kMib);
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
  EXPECT_LT(after, before - 0.9 * Holes::kMib);
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
}  // namespace onggi::files::memory_test
