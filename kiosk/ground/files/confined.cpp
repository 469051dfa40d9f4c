#include "kiosk/ground/files/confined.h"

#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace onggi::files {

namespace {

// gcc and clang announce sanitizers in different ways.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#elif defined(__has_feature)
constexpr bool kSanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
constexpr bool kSanitized = false;
#endif

const char* farewell = "";
std::size_t farewell_length = 0;  // a signal handler must not call strlen

void say_that_time_is_over(int) {
  const ssize_t written = write(STDERR_FILENO, farewell, farewell_length);
  _exit(written < 0 ? 2 : 1);
}

bool limit(int what, rlim_t most, rlim_t after = 0) {
  const rlimit both{most, most + after};
  return setrlimit(static_cast<__rlimit_resource>(what), &both) == 0;
}

}  // namespace

void confine(unsigned long memory_mib, unsigned long seconds, const char* words) {
  farewell = words;
  farewell_length = std::strlen(words);
  std::signal(SIGXCPU, say_that_time_is_over);
  bool good = limit(RLIMIT_CPU, seconds, 1) && limit(RLIMIT_CORE, 0) && limit(RLIMIT_FSIZE, 0);
  if (!kSanitized)
    good = good && limit(RLIMIT_NOFILE, 3) && limit(RLIMIT_AS, rlim_t{memory_mib} << 20);
  if (good) return;
  std::fputs("the memory and time limits could not be set", stderr);
  std::exit(1);
}

std::vector<std::uint8_t> standard_input() {
  std::vector<std::uint8_t> bytes;
  std::array<std::uint8_t, 1 << 16> block;
  for (std::size_t n; (n = std::fread(block.data(), 1, block.size(), stdin)) > 0;)
    bytes.insert(bytes.end(), block.data(), block.data() + n);
  return bytes;
}

}  // namespace onggi::files
