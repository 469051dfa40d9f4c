#include "kiosk/docs/example/pipe_hand.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <string>
#include <thread>

namespace onggi::example::pipe_hand_test {
namespace {

/// A laboratory's program at the other ends of the pipes.
class Laboratory {
 public:
  Laboratory() {
    EXPECT_EQ(pipe(poses_), 0);
    EXPECT_EQ(pipe(forces_), 0);
    hand = std::make_unique<PipeHand>(poses_[0], forces_[1], device::ForceLimits{2.0, 600.0, 0.05});
  }
  ~Laboratory() {
    hand.reset();
    close(poses_[1]);
    close(forces_[0]);
  }
  void say(const std::string& line) {
    EXPECT_EQ(write(poses_[1], line.data(), line.size()), static_cast<ssize_t>(line.size()));
  }
  /// A millisecond of the loop and of the laboratory.
  HandInput tick(Vec3 force) {
    say("0.06 0.1 0.02 1\n");
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const HandInput in = hand->read(1e-3);
    HandFeedback felt;
    felt.force = force;
    hand->feel(felt);
    return in;
  }
  /// The last line that came, once all was read.
  Vec3 last() {
    char text[65536];
    const ssize_t size = read(forces_[0], text, sizeof text - 1);
    Vec3 force{99, 99, 99};
    if (size <= 0) return force;
    text[size] = '\0';
    std::string all(text, static_cast<std::size_t>(size) - 1);
    const std::size_t line = all.rfind('\n');
    std::sscanf(all.c_str() + (line == std::string::npos ? 0 : line + 1), "%lf %lf %lf", &force.x,
                &force.y, &force.z);
    return force;
  }
  /// Pushes with all it may. A machine that stands still for 10 ms now and then only costs a try.
  bool pushes() {
    for (int tries = 0; tries < 30; ++tries) {
      for (int n = 0; n < 50; ++n) tick({});
      for (int n = 0; n < 150; ++n) tick({9.0, 0.0, 0.0});
      const double force = last().x;
      EXPECT_LE(force, 2.0) << "never above the cap";
      if (force > 1.9) return true;
    }
    return false;
  }
  std::unique_ptr<PipeHand> hand;

 private:
  int poses_[2], forces_[2];
};

TEST(PipeHand, PosesComeInAndForcesGoOutUnderTheGate) {
  Laboratory lab;
  ASSERT_TRUE(lab.pushes());
  HandInput in = lab.tick({});
  EXPECT_TRUE(in.active);
  EXPECT_EQ(in.position, (Vec3{0.06, 0.1, 0.02}));
  // The laboratory falls silent: no hand, and no force.
  ASSERT_TRUE(lab.pushes());
  // Poses age from when the hand's thread reads them, which a busy machine does late.
  bool active = true;
  for (int n = 0; n < 200 && active; ++n) {
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
    active = lab.hand->read(1e-3).active;
  }
  EXPECT_FALSE(active);
  EXPECT_EQ(lab.last(), Vec3{});
}

TEST(PipeHand, ALoopThatStandsStillOrALineThatIsNoneEndsTheForce) {
  Laboratory lab;
  ASSERT_TRUE(lab.pushes());
  for (int n = 0; n < 30; ++n) {  // Poses still come, but no tick.
    lab.say("0.06 0.1 0.02 1\n");
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_EQ(lab.last(), Vec3{});
  ASSERT_TRUE(lab.pushes());
  lab.say("what?\n");
  std::this_thread::sleep_for(std::chrono::milliseconds(8));
  EXPECT_EQ(lab.last(), Vec3{});
}

}  // namespace
}  // namespace onggi::example::pipe_hand_test
