#include "kiosk/exhibit/tuning/machine.h"

#include <time.h>

#include <algorithm>
#include <fstream>
#include <thread>

namespace onggi::tuning {

std::string machine_name() {
  std::ifstream file("/proc/cpuinfo");
  std::string line, name = "an unknown processor";
  while (std::getline(file, line))
    if (line.starts_with("model name")) {
      name = line.substr(std::min(line.find(':') + 2, line.size()));
      break;
    }
  return name + ", " + std::to_string(std::max(1u, std::thread::hardware_concurrency())) + " cores";
}

double thread_us() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e6 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_nsec);
}

}  // namespace onggi::tuning
