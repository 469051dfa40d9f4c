#include "kiosk/exhibit/composition/keepsakes.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include <chrono>
#include <ctime>
#include <fstream>
#include <thread>

#include "kiosk/keepsake/souvenir/open_passes.h"
#include "kiosk/keepsake/souvenir/pass.h"
#include "tests/kiosk/ground/files/disk.h"

namespace onggi::exhibit::keepsakes_test {
namespace {

namespace fs = std::filesystem;
using files::test::ScratchFolder;

void put_visit(const fs::path& folder, const std::string& name) {
  fs::create_directories(folder / name);
  std::ofstream(folder / name / "postcard.png") << "x";
}

TEST(Keepsakes, AFolderThatNobodySavesIntoIsTidiedAtTheStartAndOnceADay) {
  const ScratchFolder scratch;
  const fs::path old = scratch.path() / "2026-01-04_141503_jar";
  put_visit(scratch.path(), old.filename());
  const auto wait_for = [](const auto& done) {
    for (int n = 0; n < 20'000 && !done(); ++n)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
  };
  {
    Keepsakes keepsakes(scratch.path(), {100, 30});
    keepsakes.look(1000.0);
  }
  EXPECT_FALSE(fs::exists(old)) << "it ends only when the folder is tidy";

  put_visit(scratch.path(), old.filename());
  fs::create_directories(old.string() + ".partial/in_the_way");
  Keepsakes keepsakes(scratch.path(), {100, 30});
  keepsakes.look(1000.0);
  std::optional<Problem> untidy;
  wait_for([&] { return (untidy = keepsakes.untidy()).has_value(); });
  ASSERT_TRUE(untidy);
  EXPECT_EQ(untidy->where, old.string());
  EXPECT_FALSE(keepsakes.untidy()) << "told once";
  fs::remove_all(old.string() + ".partial");
  keepsakes.look(1000.0 + Keepsakes::kTidy - 1.0);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_TRUE(fs::exists(old)) << "not before the day is over";
  keepsakes.look(1000.0 + Keepsakes::kTidy);
  wait_for([&] { return !fs::exists(old); });
  EXPECT_FALSE(fs::exists(old));
  EXPECT_FALSE(keepsakes.untidy());
}

TEST(Keepsakes, EachIsNamedByWhatTheFolderDoesNotHaveYet) {
  const ScratchFolder scratch;
  const auto count = [](std::uint64_t, const std::set<std::string>& taken) {
    for (int n = 1;; ++n)
      if (std::string name = "name-" + std::to_string(n); !taken.contains(name)) return name;
  };
  for (int n = 1; n <= 3; ++n) {
    // Another kiosk each time: the folder alone knows.
    Keepsakes keepsakes(scratch.path(), {100, 0}, 0.0, count);
    souvenir::Keepsake keepsake;
    keepsake.name = "2026-05-04_141503_jar";
    keepsake.postcard = {2, 2, std::vector<std::uint8_t>(16, 128)};
    keepsakes.save(std::move(keepsake));
    keepsakes.wait();
    const auto done = keepsakes.finished();
    ASSERT_TRUE(done && done->outcome);
    EXPECT_EQ(done->outcome->spoken, "name-" + std::to_string(n));
  }
}

TEST(Keepsakes, APassIsGivenWhilePhonesAreAnsweredAndOnlyThen) {
  const ScratchFolder scratch;
  souvenir::OpenPasses passes(scratch.path());
  Keepsakes keepsakes(scratch.path(), {100, 0}, 24.0);
  const auto kept = [&] {
    souvenir::Keepsake keepsake;
    keepsake.name = "2026-05-04_141503_jar";
    keepsake.postcard = {2, 2, std::vector<std::uint8_t>(16, 128)};
    keepsake.glb.resize(10);
    if (const std::string token = keepsakes.token(); !token.empty())
      keepsake.phone =
          souvenir::ByPhone{token, 24.0, "ar", {3, 3, std::vector<std::uint8_t>(36, 128)}};
    keepsakes.save(std::move(keepsake));
    keepsakes.wait();
    return *keepsakes.finished();
  };
  EXPECT_EQ(keepsakes.token(), "") << "nobody would answer";
  EXPECT_EQ(kept().outcome->token, "");
  passes.serve();
  const auto done = kept();
  ASSERT_TRUE(done.outcome) << to_text(done.outcome.error());
  const auto pass = passes.find(done.outcome->token, std::time(nullptr));
  ASSERT_TRUE(pass);
  EXPECT_EQ(pass->visit, done.outcome->folder.filename().string());
  EXPECT_EQ(pass->language, "ar");
  EXPECT_NE(kept().outcome->token, done.outcome->token);
  EXPECT_EQ(Keepsakes(scratch.path(), {100, 0}).token(), "") << "the museum wants no phones";
}

// A page that was promised for a day went within hours. Now the last page is promised in time.
TEST(Keepsakes, WhenPromisedPagesFillTheQuotaNoMoreAreGivenAndStaffAreToldOnceADay) {
  const ScratchFolder scratch;
  souvenir::OpenPasses(scratch.path()).serve();
  const souvenir::Passes passes(scratch.path());
  const auto promise = [&](const std::string& name) {
    fs::create_directories(scratch.path() / name);
    std::ofstream(scratch.path() / name / "postcard.jpg") << std::string(10'000'000, 'x');
    ASSERT_TRUE(passes.give(name, std::time(nullptr), 24));
  };
  Keepsakes keepsakes(scratch.path(), {40, 0}, 24.0);
  double now = 0;
  const auto look = [&] {
    const auto before = keepsakes.room();
    now += Keepsakes::kRoom;
    keepsakes.look(now);
    for (int n = 0; n < 5000; ++n) {
      const auto room = keepsakes.room();
      if (room && (!before || room->promised != before->promised)) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  };
  look();
  EXPECT_FALSE(keepsakes.crowded(now));
  EXPECT_NE(keepsakes.token(), "");
  promise("2026-05-04_141503_a");
  promise("2026-05-04_141504_b");
  look();
  const auto told = keepsakes.crowded(now);
  ASSERT_TRUE(told) << "half of it is promised";
  EXPECT_NE(keepsakes.token(), "");
  EXPECT_FALSE(keepsakes.crowded(now + 3600));
  promise("2026-05-04_141505_c");
  look();
  EXPECT_EQ(keepsakes.token(), "");
  EXPECT_TRUE(keepsakes.crowded(now)) << "the last page is gone, and that is told at once";
  EXPECT_FALSE(keepsakes.crowded(now + 3600));
  EXPECT_TRUE(keepsakes.crowded(now + Keepsakes::kTidy));
  fs::remove_all(scratch.path() / "2026-05-04_141503_a");
  look();
  EXPECT_NE(keepsakes.token(), "") << "a visitor deleted theirs";
}

encoding::Turning a_turning(std::uint8_t shade) {
  return {8, 8, 4, 1.0, std::vector<std::uint8_t>(4 * 8 * 8 * 4, shade)};
}

souvenir::Keepsake a_keepsake(const char* name) {
  souvenir::Keepsake keepsake;
  keepsake.name = name;
  keepsake.postcard = {2, 2, std::vector<std::uint8_t>(16, 128)};
  keepsake.glb.resize(10);
  return keepsake;
}

TEST(Keepsakes, ATurningPictureFollowsItsSaveAndNoOtherAndTheProgramEndsWithIt) {
  const ScratchFolder scratch;
  {
    Keepsakes keepsakes(scratch.path(), {100, 0});
    const int first = keepsakes.save(a_keepsake("2026-05-04_141503_jar"));
    const int second = keepsakes.save(a_keepsake("2026-05-04_150000_jar"));
    keepsakes.add(first, a_turning(10), {});
    EXPECT_FALSE(keepsakes.adding()) << "another pot was kept since";
    keepsakes.add(second, a_turning(20), {});
    EXPECT_TRUE(keepsakes.adding());
  }
  EXPECT_FALSE(fs::exists(scratch.path() / "2026-05-04_141503_jar/turning.gif"));
  EXPECT_TRUE(fs::exists(scratch.path() / "2026-05-04_150000_jar/turning.gif"));
}

TEST(Keepsakes, ASaveIsToldBeforeItsTurningPictureAndWhetherOrNotThatComesToAnything) {
  const ScratchFolder scratch;
  Keepsakes keepsakes(scratch.path(), {100, 0});
  const int ticket = keepsakes.save(a_keepsake("2026-05-04_141503_jar"));
  keepsakes.wait();
  const auto saved = keepsakes.finished();
  ASSERT_TRUE(saved && saved->outcome);
  EXPECT_FALSE(keepsakes.busy());
  fs::remove_all(saved->outcome->folder);
  keepsakes.add(ticket, a_turning(10), {});
  keepsakes.wait();
  EXPECT_FALSE(keepsakes.busy()) << "a picture is no save";
  const auto added = keepsakes.added();
  ASSERT_TRUE(added);
  EXPECT_EQ(added->ticket, ticket);
  EXPECT_FALSE(added->outcome) << "its visitor deleted it";
  EXPECT_FALSE(keepsakes.added());
  EXPECT_FALSE(keepsakes.adding());
}

TEST(Keepsakes, NoSaveWaitsForAPictureThatIsEncoded) {
  const ScratchFolder scratch;
  Keepsakes keepsakes(scratch.path(), {100, 0});
  const int ticket = keepsakes.save(a_keepsake("2026-05-04_141503_jar"));
  encoding::Turning large{500, 500, 40, 4.0, {}};
  for (std::size_t k = 0; k < 500u * 500u * 40u * 4u; ++k)
    large.rgba.push_back(static_cast<std::uint8_t>(k * k >> 7));
  keepsakes.add(ticket, std::move(large), {});
  keepsakes.save(a_keepsake("2026-05-04_150000_jar"));
  for (int n = 0; n < 20'000 && keepsakes.busy(); ++n) {
    (void)keepsakes.finished();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_TRUE(fs::exists(scratch.path() / "2026-05-04_150000_jar"));
  EXPECT_FALSE(keepsakes.added()) << "ten million pixels are still at work";
}

// A kiosk saves and tidies for months without a reload between.
TEST(Keepsakes, WhatASaveHeldIsGivenBackWhenItHasEndedAndATidyingThatWaitedForItTooIs) {
  constexpr std::ptrdiff_t kReplay = 16 << 20;  // by mmap, so that it is counted apart
  const ScratchFolder scratch;
  Keepsakes keepsakes(scratch.path(), {100, 30});
  const auto before = static_cast<std::ptrdiff_t>(::mallinfo2().hblkhd);
  {
    souvenir::Keepsake keepsake;
    keepsake.name = "2026-01-04_141503_jar";
    keepsake.postcard = {50, 70, std::vector<std::uint8_t>(50 * 70 * 4, 200)};
    keepsake.replay.resize(kReplay);
    keepsakes.save(std::move(keepsake));
  }
  keepsakes.look(1000.0);
  for (int n = 0; n < 20'000 && keepsakes.busy(); ++n) {
    const auto done = keepsakes.finished();
    EXPECT_TRUE(!done || done->outcome);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  ASSERT_FALSE(keepsakes.busy());
  const auto held = [&] { return static_cast<std::ptrdiff_t>(::mallinfo2().hblkhd) - before; };
  // The tidying lets go of it at its own time.
  for (int n = 0; n < 5000 && held() >= kReplay; ++n)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_LT(held(), kReplay);
}

}  // namespace
}  // namespace onggi::exhibit::keepsakes_test
