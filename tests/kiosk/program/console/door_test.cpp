#include "kiosk/program/console/door.h"

#include <gmock/gmock.h>

#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::console::door_test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr std::int64_t kNow = 1'780'000'000;

class DoorTest : public ::testing::Test {
 protected:
  Door door() const { return std::move(*Door::make("onggi_staff_8090", state_.path(), kNow)); }
  files::test::ScratchFolder state_;
};

/// A request with the cookie that a browser keeps of `set`.
web::Ask with(const std::string& set) {
  return {.method = "GET", .target = "/", .cookie = "other=1; " + set.substr(0, set.find(';'))};
}

TEST_F(DoorTest, OpensOnceToItsCodeAndToNoOther) {
  Door d = door();
  const std::string code = d.code();
  EXPECT_EQ(code.size(), 26u);
  EXPECT_EQ(d.enter("", kNow), "");
  EXPECT_EQ(d.enter(code.substr(1), kNow), "");
  EXPECT_EQ(d.enter(code + code.front(), kNow), "");
  std::string wrong = code;
  wrong.back() = wrong.back() == 'a' ? 'b' : 'a';
  EXPECT_EQ(d.enter(wrong, kNow), "");
  const std::string set = d.enter(code, kNow);
  EXPECT_THAT(set, StartsWith("onggi_staff_8090="));
  EXPECT_THAT(set, HasSubstr("HttpOnly; SameSite=Strict"));
  EXPECT_TRUE(d.session_of(with(set), kNow));
  EXPECT_EQ(d.enter(code, kNow), "") << "it was used";
  EXPECT_NE(d.code(), code);
}

TEST_F(DoorTest, KnowsNobodyWithoutItsCookie) {
  Door d = door();
  const std::string set = d.enter(d.code(), kNow);
  EXPECT_FALSE(d.session_of({}, kNow));
  EXPECT_FALSE(d.session_of({.method = "GET", .target = "/", .cookie = "onggi_staff_8090="}, kNow));
  std::string other = set;
  other[20] = other[20] == 'a' ? 'b' : 'a';
  EXPECT_FALSE(d.session_of(with(other), kNow));
  EXPECT_FALSE(d.session_of(with("onggi_staff_8091" + set.substr(16)), kNow))
      << "another program's";
}

TEST_F(DoorTest, ASessionEndsAfterHalfAnHourWithoutARequestAndAfterTwelveHours) {
  Door d = door();
  const web::Ask ask = with(d.enter(d.code(), kNow));
  EXPECT_TRUE(d.session_of(ask, kNow + Door::kIdle - 1));
  EXPECT_FALSE(d.session_of(ask, kNow + 2 * Door::kIdle));
  const web::Ask busy = with(d.enter(d.code(), kNow));
  std::int64_t at = kNow;
  for (; at < kNow + Door::kLongest; at += 60) ASSERT_TRUE(d.session_of(busy, at)) << at - kNow;
  EXPECT_FALSE(d.session_of(busy, at));
}

TEST_F(DoorTest, WhoLeavesIsForgottenAndNobodyElse) {
  Door d = door();
  const web::Ask one = with(d.enter(d.code(), kNow)), two = with(d.enter(d.code(), kNow));
  EXPECT_THAT(d.leave(one), HasSubstr("Max-Age=0"));
  EXPECT_FALSE(d.session_of(one, kNow));
  EXPECT_TRUE(d.session_of(two, kNow));
}

TEST_F(DoorTest, ACodeThatWasPrintedLongAgoOpensNothing) {
  Door d = door();
  const std::string code = d.code();
  EXPECT_EQ(d.enter(code, kNow + Door::kCodeLasts), "");
  EXPECT_NE(d.enter(code, kNow + Door::kCodeLasts - 1), "");
}

TEST_F(DoorTest, AnotherProcessGivesACodeOfWhichTheDiskHasOnlyAHash) {
  Door d = door();
  const auto first = Door::give_code(state_.path(), kNow),
             code = Door::give_code(state_.path(), kNow);
  ASSERT_TRUE(first && code);
  for (const auto& file : std::filesystem::directory_iterator(state_.path()))
    EXPECT_EQ(files::test::content(file.path()).find(*code), std::string::npos);
  EXPECT_EQ(d.enter(*first, kNow), "") << "there is one at a time";
  EXPECT_EQ(d.enter(*code, kNow + Door::kCodeLasts), "") << "it was good for an hour";
  EXPECT_EQ(d.enter(*code, kNow - 10), "") << "a clock that was ahead gave it";
  const std::string set = d.enter(*code, kNow + 60);
  const Session* session = d.session_of(with(set), kNow + 60);
  ASSERT_TRUE(session);
  EXPECT_EQ(session->role, Role::editor);
  EXPECT_EQ(d.enter(*code, kNow + 60), "") << "it was used";
  EXPECT_NE(d.enter(d.code(), kNow), "") << "the printed one is not";
}

TEST_F(DoorTest, WhoIsAdmittedHasTheirRoleUntilAllTheirSessionsAreEnded) {
  Door d = door();
  const web::Ask desk = with(d.admit("maria", Role::desk, kNow)),
                 again = with(d.admit("maria", Role::desk, kNow)),
                 other = with(d.admit("joon", Role::editor, kNow));
  ASSERT_TRUE(d.session_of(desk, kNow));
  EXPECT_EQ(d.session_of(desk, kNow)->who, "maria");
  EXPECT_EQ(d.session_of(desk, kNow)->role, Role::desk);
  d.end_all_of("maria");
  EXPECT_FALSE(d.session_of(desk, kNow) || d.session_of(again, kNow));
  EXPECT_TRUE(d.session_of(other, kNow));
}

TEST_F(DoorTest, AClockThatIsSetBackMakesNoSessionLast) {
  Door d = door();
  const web::Ask ask = with(d.admit("maria", Role::desk, kNow));
  EXPECT_TRUE(d.session_of(ask, kNow - 60));
  EXPECT_FALSE(d.session_of(ask, kNow - 2 * Door::kIdle));
}

TEST(Cookie, IsFoundByItsWholeName) {
  EXPECT_EQ(cookie_of("a=1; b=2;c=3", "b"), "2");
  EXPECT_EQ(cookie_of("a=1; b=2;c=3", "c"), "3");
  EXPECT_EQ(cookie_of("ab=1", "a"), "");
  EXPECT_EQ(cookie_of("xa=1; a=", "a"), "");
  EXPECT_EQ(cookie_of("a=b=c", "a"), "b=c");
}

}  // namespace
}  // namespace onggi::console::door_test
