#include "kiosk/keepsake/souvenir/room.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "kiosk/keepsake/souvenir/pass.h"
#include "tests/kiosk/ground/files/disk.h"

namespace onggi::souvenir::room_test {
namespace {

using namespace files::test;
using ::testing::HasSubstr;

constexpr std::time_t kNow = 1'780'000'000;

void put_visit(const fs::path& folder, const std::string& name, std::size_t kilobytes) {
  fs::create_directories(folder / name);
  std::ofstream(folder / name / "postcard.jpg") << std::string(kilobytes * 1000, 'x');
}

TEST(room, keepsakes_and_those_whose_page_is_promised_are_counted_each_once) {
  const ScratchFolder scratch;
  const Passes passes(scratch.path());
  put_visit(scratch.path(), "2026-05-01_100000_a", 3000);
  put_visit(scratch.path(), "2026-05-02_100000_b", 2000);
  put_visit(scratch.path(), "2026-05-03_100000_c", 500);
  fs::create_directories(scratch.path() / "photos");
  ASSERT_TRUE(passes.give("2026-05-01_100000_a", kNow - 10 * 3600, 24));
  ASSERT_TRUE(passes.give("2026-05-01_100000_a", kNow, 24)) << "the desk gave a second one";
  ASSERT_TRUE(passes.give("2026-05-02_100000_b", kNow - 25 * 3600, 24)) << "it is over";
  ASSERT_TRUE(passes.give("2026-05-04_100000_d", kNow, 24)) << "its keepsake was deleted";
  const Room room = room_in(scratch.path(), {100}, kNow);
  EXPECT_EQ(room.quota, 100'000'000u);
  EXPECT_EQ(room.held, 5'500'000u);
  EXPECT_EQ(room.promised, 3'000'000u);
  EXPECT_EQ(room.pages, 1u);
  EXPECT_TRUE(room_in(scratch.path() / "none", {100}, kNow).for_a_page());
}

TEST(room, pages_are_promised_while_what_is_promised_fits_the_quota) {
  Room room{2'000'000'000, 2'000'000'000, 0, 0};
  EXPECT_TRUE(room.for_a_page()) << "what nobody was promised makes way";
  EXPECT_EQ(room.pages_left(), 249u);
  room.promised = 1'984'000'000;
  room.pages = 248;
  EXPECT_TRUE(room.for_a_page());
  EXPECT_EQ(room.pages_left(), 1u);
  room.promised = 1'992'000'000;
  room.pages = 249;
  EXPECT_FALSE(room.for_a_page());
  EXPECT_EQ(room.pages_left(), 0u);
  EXPECT_TRUE((Room{16'000'000, 0, 0, 0}).for_a_page()) << "one, and one on its way";
  // Visits that are larger than usual need more.
  EXPECT_FALSE((Room{100'000'000, 0, 60'000'000, 2}).for_a_page());
}

TEST(room, staff_are_told_with_figures_from_half_the_quota_on) {
  EXPECT_FALSE(warning_of({2'000'000'000, 1'999'000'000, 999'000'000, 250}, 24));
  const auto half = warning_of({2'000'000'000, 2'000'000'000, 1'000'000'000, 250}, 24);
  ASSERT_TRUE(half);
  for (const char* told : {"250 visitors", "24 hours", "1000 of 2000 MB", "room for 124 more"})
    EXPECT_THAT(half->what, HasSubstr(told));
  EXPECT_THAT(half->where, HasSubstr("quota_mb"));
  EXPECT_THAT(half->remedy, HasSubstr("at least 2001"));
  EXPECT_FALSE(warning_of({2'001'000'000, 0, 1'000'000'000, 250}, 24)) << "so the remedy helps";
  const auto full = warning_of({2'000'000'000, 2'000'000'000, 1'999'000'000, 499}, 24);
  ASSERT_TRUE(full);
  EXPECT_THAT(full->what, HasSubstr("no page on their phones"));
}

}  // namespace
}  // namespace onggi::souvenir::room_test
