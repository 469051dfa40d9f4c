#include "kiosk/keepsake/souvenir/staff_notice.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::souvenir::staff_notice_test {
namespace {

TEST(StaffNotice, IsSeenWhileItIsUpAndNeverElse) {
  const files::test::ScratchFolder folder;
  EXPECT_EQ(address_for_staff(folder.path()), "");
  {
    StaffNotice notice(folder.path());
    EXPECT_TRUE(notice.put_up("https://kiosk.museum.org"));
    EXPECT_EQ(address_for_staff(folder.path()), "https://kiosk.museum.org");
    EXPECT_TRUE(notice.put_up("https://kiosk.museum.org"));
    notice.take_away();
    EXPECT_EQ(address_for_staff(folder.path()), "");
    EXPECT_TRUE(notice.put_up("http://127.0.0.1:8090"));
  }
  EXPECT_EQ(address_for_staff(folder.path()), "");
  EXPECT_FALSE(StaffNotice("/nowhere").put_up("http://x"));
}

// A program that was killed leaves its file, and no lock.
TEST(StaffNotice, OfAProgramThatWasKilledCountsForNothing) {
  const files::test::ScratchFolder folder;
  std::ofstream(folder / ".staff") << "https://kiosk.museum.org";
  EXPECT_EQ(address_for_staff(folder.path()), "");
}

TEST(StaffNotice, WithAnythingButAnAddressCountsForNothing) {
  const files::test::ScratchFolder folder;
  for (const char* text : {"", "ftp://x", "http://a b", "http://a\n", "http://\xFF"}) {
    StaffNotice notice(folder.path());
    ASSERT_TRUE(notice.put_up(text));
    EXPECT_EQ(address_for_staff(folder.path()), "") << text;
  }
}

}  // namespace
}  // namespace onggi::souvenir::staff_notice_test
