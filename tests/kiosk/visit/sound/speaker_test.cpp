#include "kiosk/visit/sound/speaker.h"

#include <gtest/gtest.h>
#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <thread>
#include <vector>

#include "tests/kiosk/ground/files/disk.h"

namespace onggi::sound::speaker_test {
namespace {

// SDL's own drivers that need no card: one writes what would be played into a file.
class Card : public testing::Test {
 protected:
  ~Card() override {
    for (const char* name : {"SDL_AUDIODRIVER", "SDL_DISKAUDIOFILE"}) ::unsetenv(name);
  }
  void driver(const char* name) {
    ::setenv("SDL_AUDIODRIVER", name, 1);
    ::setenv("SDL_DISKAUDIOFILE", (scratch_.path() / "played").c_str(), 1);
  }
  std::vector<float> played() const {
    std::ifstream in(scratch_.path() / "played", std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(in), {});
    std::vector<float> out(bytes.size() / sizeof(float));
    std::memcpy(out.data(), bytes.data(), out.size() * sizeof(float));
    return out;
  }
  static void wait_for_blocks(const Speaker& speaker, std::uint64_t more) {
    const std::uint64_t wanted = speaker.status().blocks + more;
    for (int n = 0; n < 20'000 && speaker.status().blocks < wanted; ++n)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ASSERT_GE(speaker.status().blocks, wanted);
  }
  files::test::ScratchFolder scratch_;
};

TEST_F(Card, IsAskedForByAThreadThatNoDrawingKeepsFromItsTurnWhereTheSystemPermits) {
  std::thread trial([] {
    sched_param parameter{};
    parameter.sched_priority = Speaker::kPriority;
    if (pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameter) != 0)
      GTEST_SKIP() << "this user's threads may not run before others";
  });
  trial.join();
  if (IsSkipped()) return;
  driver("dummy");
  std::atomic<int> policy{-1}, priority{-1};
  Speaker speaker([&] {
    sched_param parameter{};
    int own = -1;
    pthread_getschedparam(pthread_self(), &own, &parameter);
    policy = own;
    priority = parameter.sched_priority;
    return Heard{};
  });
  ASSERT_TRUE(speaker.playing()) << speaker.remark();
  wait_for_blocks(speaker, 3);
  EXPECT_EQ(policy, SCHED_FIFO);
  EXPECT_EQ(priority, Speaker::kPriority);
}

TEST_F(Card, PlaysWhatIsHeardAtTheVolumeThatIsSet) {
  driver("disk");
  {
    Heard heard;
    heard.rub[0] = {Rub::Kind::hand, 0.6, 2.0};
    Speaker speaker([&] { return heard; });
    ASSERT_TRUE(speaker.playing()) << speaker.remark();
    EXPECT_NE(speaker.remark().find("disk"), std::string::npos);
    EXPECT_EQ(speaker.remark(), "") << "said once";
    wait_for_blocks(speaker, 10);
    speaker.volume(1.0);
    wait_for_blocks(speaker, 30);
  }
  const auto sound = played();
  ASSERT_GT(sound.size(), 30u * Speaker::kBlock);
  for (std::size_t n = 0; n < 5 * Speaker::kBlock; ++n) ASSERT_EQ(sound[n], 0.0f) << n;
  float loudest = 0.0f;
  for (const float x : sound) loudest = std::max(loudest, std::abs(x));
  EXPECT_GT(loudest, 0.05f);
}

TEST_F(Card, CountsTouchesOnceEachAndSaysWhenTheyCameOut) {
  driver("dummy");
  std::atomic<bool> touches{false};
  Speaker speaker([&] {
    Heard heard;
    if (touches) heard.rub[1] = {Rub::Kind::hand, 0.6, 2.0};
    return heard;
  });
  ASSERT_TRUE(speaker.playing()) << speaker.remark();
  wait_for_blocks(speaker, 2);
  EXPECT_EQ(speaker.status().touches, 0u);
  for (std::uint64_t n = 1; n <= 3; ++n) {
    touches = true;
    wait_for_blocks(speaker, 3);
    EXPECT_EQ(speaker.status().touches, n);
    EXPECT_GT(speaker.status().touched_ns, 0);
    touches = false;
    wait_for_blocks(speaker, 3);
  }
}

TEST_F(Card, AMachineWithoutOneIsSilentSaysSoOnceAndLooksAgainNowAndThen) {
  driver("no_such_driver");
  Speaker speaker([] { return Heard{}; });
  EXPECT_FALSE(speaker.playing());
  const std::string said = speaker.remark();
  EXPECT_NE(said.find("no sound"), std::string::npos) << said;
  EXPECT_NE(said.find("goes on"), std::string::npos) << said;
  speaker.look(100.0);
  EXPECT_EQ(speaker.remark(), "") << "nothing new";
  driver("dummy");
  speaker.look(100.0 + 0.9 * Speaker::kLookAgain);
  EXPECT_FALSE(speaker.playing());
  speaker.look(100.0 + Speaker::kLookAgain);
  EXPECT_TRUE(speaker.playing());
  EXPECT_NE(speaker.remark().find("dummy"), std::string::npos);
}

}  // namespace
}  // namespace onggi::sound::speaker_test
