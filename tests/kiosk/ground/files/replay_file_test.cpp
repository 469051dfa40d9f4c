#include "kiosk/ground/files/replay_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

#include "engine/math/random.h"
#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/zstandard.h"
#include "tests/kiosk/ground/files/disk.h"

namespace onggi::files::replay_file_test {
namespace {

using test::ScratchFolder;

std::vector<std::byte> some_replay() {
  ReplayWriter writer(SceneDef{}, "moon_jar", 7);
  for (int n = 0; n < 3000; ++n) {
    TickRecord tick;
    tick.hands.hand[0].position = {0.05 + 1e-6 * n, 0.1, 0.0};
    tick.hands.hand[0].active = true;
    writer.tick(tick);
  }
  return writer.finish(42, "celadon");
}

TEST(ReplayFile, OneThatIsPackedAndOneOfBeforeAreReadAlike) {
  const ScratchFolder scratch;
  const auto bytes = some_replay();
  ASSERT_TRUE(write_durably(scratch.path() / "old.onggi", bytes));
  ASSERT_TRUE(write_durably(scratch.path() / "new.onggi", packed(bytes)));
  EXPECT_LT(std::filesystem::file_size(scratch.path() / "new.onggi"), bytes.size() / 2);
  for (const char* name : {"old.onggi", "new.onggi"}) {
    const auto replay = read_replay(scratch.path() / name);
    ASSERT_TRUE(replay) << to_text(replay.error());
    EXPECT_EQ(replay->ticks.size(), 3000u);
    EXPECT_EQ(replay->glaze, "celadon");
    EXPECT_EQ(replay->final_hash, 42u);
  }
}

// A mouse at 60 Hz, which a pointer's hand follows as PointerHand does. As ticks one behind the
// other it took 12.7 bytes a tick.
TEST(ReplayFile, AVisitorsHandTakesLittleRoom) {
  ReplayWriter writer(SceneDef{}, "moon_jar", 7);
  Random random(2);
  TickRecord tick;
  Vec3 target{0.08, 0.1, 0.0};
  constexpr int kTicks = 20'000;
  for (int n = 0; n < kTicks; ++n) {
    if (n % 16 == 0) target = target + Vec3{random.uniform(-3e-4, 3e-4), 5e-5, 0.0};
    tick.hands.hand[0].position += (target - tick.hands.hand[0].position) * (0.001 / 0.026);
    writer.tick(tick);
  }
  EXPECT_LT(packed(writer.finish(0)).size(), kTicks * 3 / 2);
}

TEST(ReplayFile, ADamagedFrameIsToldWithItsName) {
  const ScratchFolder scratch;
  auto frame = packed(some_replay());
  frame.resize(frame.size() / 2);
  ASSERT_TRUE(write_durably(scratch.path() / "cut.onggi", frame));
  const auto replay = read_replay(scratch.path() / "cut.onggi");
  ASSERT_FALSE(replay);
  EXPECT_NE(replay.error().where.find("cut.onggi"), std::string::npos);
  EXPECT_EQ(replay.error().exit_code, 2);
}

}  // namespace
}  // namespace onggi::files::replay_file_test
