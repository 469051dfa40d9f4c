#include "kiosk/ground/files/replay_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/zstandard.h"
#include "tests/kiosk/ground/files/disk.h"

namespace onggi::files {
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
}  // namespace onggi::files
