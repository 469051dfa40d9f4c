#include "kiosk/ground/web/descriptor_limit.h"

#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <string>

namespace onggi::web {

namespace {

constexpr std::size_t kUsual = 1024;

/// As /proc says it: the service's filter of system calls allows no other question.
std::size_t said_by_the_system() {
  constexpr const char* kLine = "Max open files";
  std::ifstream in("/proc/self/limits");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(kLine)) {
      const std::size_t digits = std::min(line.find_first_of("0123456789"), line.size());
      std::size_t number = 0;
      for (std::size_t n = digits; n < line.size() && line[n] >= '0' && line[n] <= '9'; ++n)
        number = 10 * number + static_cast<std::size_t>(line[n] - '0');
      if (number > 0) return number;
    }
  return kUsual;
}

}  // namespace

std::size_t descriptor_limit(std::size_t wanted) {
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) == 0 && limit.rlim_cur < wanted) {
    limit.rlim_cur = std::min<rlim_t>(wanted, limit.rlim_max);
    static_cast<void>(::setrlimit(RLIMIT_NOFILE, &limit));
  }
  return said_by_the_system();
}

}  // namespace onggi::web
