#include "kiosk/program/watch/kiosk_state.h"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/wait.h>

#include <chrono>
#include <functional>
#include <memory>
#include <thread>

#include "kiosk/program/watch/state_board.h"
#include "tests/kiosk/ground/files/disk.h"

namespace onggi::watch::kiosk_state_test {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;

KioskState busy() {
  KioskState s;
  s.health = {.version = "0.1.0",
              .safe_mode = true,
              .dark = true,
              .crashes = 3,
              .running_s = 86399.25,
              .frames = 5'184'000,
              .wakes = 86'400'000,
              .late = 12,
              .overruns = 4,
              .lost_ticks = 9,
              .worst_wake_s = 0.0031,
              .kept = 41,
              .not_kept = 2,
              .promised_bytes = 3'000'000'000,
              .quota_bytes = 5'000'000'000,
              .disk_writes = false};
  s.exhibit = "/srv/a museum/config/exhibit.toml";
  s.stands_in = s.open = s.visitor = true;
  s.said = 1'780'000'000;
  s.vessel = "moon_jar";
  s.frames_a_second = 59.875;
  s.devices = {"3Dconnexion SpaceMouse", "onggi-hid"};
  s.trouble = files::Trouble{
      {"config/exhibit.toml:3:1", "It is wrong.", "Put it right."}, 1'779'999'000, 7};
  return s;
}

/// Waits for the disk's thread; false after ten seconds.
bool soon(const std::function<bool()>& done) {
  for (int n = 0; n < 1000; ++n) {
    if (done()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

bool shows(const fs::path& folder, const std::string& vessel) {
  const SeenKiosk seen = look_at_kiosk(folder);
  return seen.runs && seen.state && seen.state->vessel == vessel;
}

KioskState with(const std::string& vessel) {
  KioskState s;
  s.vessel = vessel;
  return s;
}

TEST(KioskState, IsReadAsItWasWritten) {
  const auto s = state_of(text_of(busy()));
  ASSERT_TRUE(s);
  // Each value is another one than a fresh state's, and text has a place for each.
  EXPECT_EQ(text_of(*s), text_of(busy()));
  EXPECT_EQ(s->health.lost_ticks, 9u);
  EXPECT_EQ(s->health.quota_bytes, 5'000'000'000u);
  EXPECT_DOUBLE_EQ(s->health.worst_wake_s, 0.0031);
  EXPECT_DOUBLE_EQ(s->frames_a_second, 59.875);
  EXPECT_TRUE(s->health.safe_mode && s->health.dark && s->stands_in && s->visitor && s->open);
  EXPECT_FALSE(s->ended || s->health.disk_writes);
  EXPECT_EQ(s->exhibit, "/srv/a museum/config/exhibit.toml");
  EXPECT_EQ(s->said, 1'780'000'000);
  EXPECT_THAT(s->devices, ElementsAre("3Dconnexion SpaceMouse", "onggi-hid"));
  ASSERT_TRUE(s->trouble);
  EXPECT_EQ(to_text(s->trouble->problem), to_text(busy().trouble->problem));
  EXPECT_EQ(s->trouble->count, 7u);
}

TEST(KioskState, ThatIsHalfWrittenIsNone) {
  const std::string whole = text_of(busy());
  for (std::size_t n = 0; n < whole.size(); ++n) EXPECT_FALSE(state_of(whole.substr(0, n))) << n;
  EXPECT_TRUE(state_of(whole + "\n\nframes 1\nanything"));
}

TEST(KioskState, StaysSmallAndALineAValueWhateverAProblemSays) {
  KioskState s = busy();
  const std::string nasty = "end\nended true\nvessel \x1b[2J" + std::string(100'000, 'x');
  s.trouble->problem = {nasty, nasty, nasty};
  s.exhibit = s.vessel = s.health.version = nasty;
  s.devices.assign(100, nasty);
  const std::string text = text_of(s);
  EXPECT_LE(text.size(), kMostOfAState);
  const auto back = state_of(text);
  ASSERT_TRUE(back);
  EXPECT_FALSE(back->ended);
  EXPECT_TRUE(back->vessel.starts_with("end?ended true?vessel ?[2J"));
}

TEST(StateBoard, IsSeenWhileTheKioskRunsAndSaysWhenItEnded) {
  const files::test::ScratchFolder folder;
  EXPECT_FALSE(look_at_kiosk(folder.path()).state);
  EXPECT_FALSE(look_at_kiosk(folder.path()).runs);
  auto board = std::make_unique<StateBoard>(folder.path());
  board->show(with("moon_jar"));
  EXPECT_TRUE(soon([&] { return shows(folder.path(), "moon_jar"); }));
  board->show(with("olla"));  // news is written at once
  EXPECT_TRUE(soon([&] { return shows(folder.path(), "olla"); }));
  board.reset();
  const SeenKiosk seen = look_at_kiosk(folder.path());
  EXPECT_FALSE(seen.runs);
  ASSERT_TRUE(seen.state);
  EXPECT_TRUE(seen.state->ended);
}

TEST(StateBoard, OfAKioskThatWasKilledDoesNotLookAlive) {
  const files::test::ScratchFolder folder;
  const pid_t kiosk = ::fork();
  if (kiosk == 0) {
    StateBoard board(folder.path());
    board.show(with("moon_jar"));
    for (;;) ::pause();
  }
  EXPECT_TRUE(soon([&] { return shows(folder.path(), "moon_jar"); }));
  ::kill(kiosk, SIGKILL);
  ::waitpid(kiosk, nullptr, 0);
  const SeenKiosk seen = look_at_kiosk(folder.path());
  EXPECT_FALSE(seen.runs);
  ASSERT_TRUE(seen.state);
  EXPECT_FALSE(seen.state->ended);
}

TEST(StateBoard, OfTheFirstOfTwoKiosksIsKeptUntilItEnds) {
  const files::test::ScratchFolder folder;
  auto first = std::make_unique<StateBoard>(folder.path());
  first->show(with("moon_jar"));
  EXPECT_TRUE(soon([&] { return shows(folder.path(), "moon_jar"); }));
  StateBoard second(folder.path());
  second.show(with("olla"));
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  EXPECT_TRUE(shows(folder.path(), "moon_jar"));
  first.reset();
  second.show(with("tea_bowl"));
  EXPECT_TRUE(soon([&] { return shows(folder.path(), "tea_bowl"); }));
}

TEST(StateBoard, ComesToAFolderThatIsMadeLaterOrWasEmptied) {
  const files::test::ScratchFolder folder;
  const fs::path later = folder / "keepsakes";
  StateBoard board(later);
  board.show(with("moon_jar"));
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  fs::create_directory(later);
  board.show(with("olla"));
  EXPECT_TRUE(soon([&] { return shows(later, "olla"); }));
  fs::remove(later / kStateFile);
  board.show(with("tea_bowl"));
  EXPECT_TRUE(soon([&] { return shows(later, "tea_bowl"); }));
}

TEST(StateBoard, AFileOfAnotherThatIsHugeOrNoneOfOursIsPutRight) {
  const files::test::ScratchFolder folder;
  std::ofstream(folder / kStateFile) << "not ours";
  fs::resize_file(folder / kStateFile, std::uintmax_t{1} << 40);  // without a block on the disk
  StateBoard board(folder.path());
  board.show(with("moon_jar"));
  EXPECT_TRUE(soon([&] { return shows(folder.path(), "moon_jar"); }));
  EXPECT_LE(fs::file_size(folder / kStateFile), kMostOfAState);
}

TEST(StateBoard, GoesOnInAFileThatWasReplaced) {
  const files::test::ScratchFolder folder;
  StateBoard board(folder.path());
  board.show(with("moon_jar"));
  EXPECT_TRUE(soon([&] { return shows(folder.path(), "moon_jar"); }));
  std::ofstream(folder / "restored") << "from a backup";
  fs::rename(folder / "restored", folder / kStateFile);
  board.show(with("olla"));
  EXPECT_TRUE(soon([&] { return shows(folder.path(), "olla"); }));
}

TEST(KioskState, WhateverIsWrittenThereCanBeCountedWith) {
  for (const char* value :
       {"inf", "nan", "-5", "1e308", "99999999999999999999", "-9223372036854775808", "x", ""}) {
    const auto s = state_of(std::string("frames_a_second ") + value + "\nsaid " + value +
                            "\ntrouble_at " + value + "\nrunning_s " + value + "\nend\n");
    ASSERT_TRUE(s) << value;
    for (const double n : {s->frames_a_second, s->health.running_s, static_cast<double>(s->said),
                           static_cast<double>(s->trouble->at)}) {
      EXPECT_GE(n, 0.0) << value;
      EXPECT_LE(n, 1e12) << value;
    }
  }
}

TEST(StateBoard, IsWrittenOnADiskThatHasBecomeFull) {
  const files::test::ScratchFolder folder;
  const int status = files::test::on_a_disk(folder.path(), 0, "size=64k", [&] {
    StateBoard board(folder.path());
    KioskState long_one = with("moon_jar");
    long_one.exhibit = std::string(900, 'x');
    board.show(long_one);
    if (!soon([&] { return shows(folder.path(), "moon_jar"); })) return false;
    std::ofstream filler(folder / "filler", std::ios::binary);
    filler << std::string(200'000, 'f');
    filler.flush();
    if (filler.good()) return false;  // it is not full
    board.show(with("olla"));
    return soon([&] { return shows(folder.path(), "olla"); });
  });
  if (WEXITSTATUS(status) == files::test::kNoMounts)
    GTEST_SKIP() << "a disk of our own is not allowed here";
  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace onggi::watch::kiosk_state_test
