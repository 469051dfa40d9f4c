#include "kiosk/wheel/device/mailbox.h"

#include <gtest/gtest.h>

#include <array>
#include <thread>

namespace onggi::device::mailbox_test {
namespace {

TEST(Mailbox, TheNewestIsTakenOnceAndWhatWasBeforeItIsGone) {
  Mailbox<int> box;
  int value = -1;
  EXPECT_FALSE(box.take(value));
  EXPECT_EQ(value, -1);
  box.put(1);
  box.put(2);
  box.put(3);
  EXPECT_TRUE(box.take(value));
  EXPECT_EQ(value, 3);
  EXPECT_FALSE(box.take(value));
  box.put(4);
  EXPECT_TRUE(box.take(value));
  EXPECT_EQ(value, 4);
}

TEST(Mailbox, NoValueIsEverHalfOldHoweverFastBothSidesAre) {
  struct Wide {
    std::array<std::uint64_t, 40> words{};
  };
  Mailbox<Wide> box;
  constexpr std::uint64_t kLast = 200000;
  std::thread writer([&box] {
    for (std::uint64_t n = 1; n <= kLast; ++n) {
      Wide wide;
      wide.words.fill(n);
      box.put(wide);
    }
  });
  Wide seen;
  std::uint64_t before = 0;
  while (before < kLast) {
    if (!box.take(seen)) continue;
    for (const std::uint64_t word : seen.words) ASSERT_EQ(word, seen.words[0]);
    ASSERT_GT(seen.words[0], before);
    before = seen.words[0];
  }
  writer.join();
}

}  // namespace
}  // namespace onggi::device::mailbox_test
