#include "kiosk/wheel/loop/status_block.h"

#include <gtest/gtest.h>

#include <array>
#include <thread>

namespace onggi::loop::status_block_test {
namespace {

TEST(StatusBlock, AReaderNeverSeesHalfAStatus) {
  struct Wide {
    std::array<std::uint64_t, 40> same;
  };
  StatusBlock<Wide> block;
  std::atomic<bool> stop{false};
  std::thread writer([&] {
    for (std::uint64_t n = 1; !stop; ++n) {
      Wide wide{};
      wide.same.fill(n);
      block.write(wide);
    }
  });
  std::uint64_t last = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Wide wide = block.read();
    for (const std::uint64_t v : wide.same) ASSERT_EQ(v, wide.same[0]);
    ASSERT_GE(wide.same[0], last);
    last = wide.same[0];
  }
  stop = true;
  writer.join();
}

}  // namespace
}  // namespace onggi::loop::status_block_test
