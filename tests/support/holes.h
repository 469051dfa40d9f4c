#pragma once

#include <unistd.h>

#include <array>
#include <cstddef>
#include <fstream>
#include <memory>
#include <vector>

namespace onggi::test {

/// Of this process, MiB.
inline double resident_mib() {
  long all = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return static_cast<double>(resident * sysconf(_SC_PAGESIZE)) / 1048576.0;
}

/// 128 MiB of the heap in blocks of 64 KiB, of which every 16th stays: the others leave holes.
class Holes {
 public:
  static constexpr double kMib = 120.0;  ///< Free, and resident until the heap is trimmed.

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

}  // namespace onggi::test
