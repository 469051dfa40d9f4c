#include "kiosk/program/console/door.h"

#include <gmock/gmock.h>

namespace onggi::console::door_test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr std::int64_t kNow = 1'780'000'000;

Door door() { return std::move(*Door::make("onggi_staff_8090")); }

/// A request with the cookie that a browser keeps of `set`.
web::Ask with(const std::string& set) {
  return {.method = "GET", .target = "/", .cookie = "other=1; " + set.substr(0, set.find(';'))};
}

TEST(Door, OpensOnceToItsCodeAndToNoOther) {
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
  EXPECT_TRUE(d.knows(with(set), kNow));
  EXPECT_EQ(d.enter(code, kNow), "") << "it was used";
  EXPECT_NE(d.code(), code);
}

TEST(Door, KnowsNobodyWithoutItsCookie) {
  Door d = door();
  const std::string set = d.enter(d.code(), kNow);
  EXPECT_FALSE(d.knows({}, kNow));
  EXPECT_FALSE(d.knows({.method = "GET", .target = "/", .cookie = "onggi_staff_8090="}, kNow));
  std::string other = set;
  other[20] = other[20] == 'a' ? 'b' : 'a';
  EXPECT_FALSE(d.knows(with(other), kNow));
  EXPECT_FALSE(d.knows(with("onggi_staff_8091" + set.substr(16)), kNow)) << "another program's";
}

TEST(Door, ASessionEndsAfterHalfAnHourWithoutARequestAndAfterTwelveHours) {
  Door d = door();
  const web::Ask ask = with(d.enter(d.code(), kNow));
  EXPECT_TRUE(d.knows(ask, kNow + Door::kIdle - 1));
  EXPECT_FALSE(d.knows(ask, kNow + 2 * Door::kIdle));
  const web::Ask busy = with(d.enter(d.code(), kNow));
  std::int64_t at = kNow;
  for (; at < kNow + Door::kLongest; at += 60) ASSERT_TRUE(d.knows(busy, at)) << at - kNow;
  EXPECT_FALSE(d.knows(busy, at));
}

TEST(Door, WhoLeavesIsForgottenAndNobodyElse) {
  Door d = door();
  const web::Ask one = with(d.enter(d.code(), kNow)), two = with(d.enter(d.code(), kNow));
  EXPECT_THAT(d.leave(one), HasSubstr("Max-Age=0"));
  EXPECT_FALSE(d.knows(one, kNow));
  EXPECT_TRUE(d.knows(two, kNow));
}

TEST(Door, CookiesAreFoundByTheirWholeName) {
  EXPECT_EQ(cookie_of("a=1; b=2;c=3", "b"), "2");
  EXPECT_EQ(cookie_of("a=1; b=2;c=3", "c"), "3");
  EXPECT_EQ(cookie_of("ab=1", "a"), "");
  EXPECT_EQ(cookie_of("xa=1; a=", "a"), "");
  EXPECT_EQ(cookie_of("a=b=c", "a"), "b=c");
}

}  // namespace
}  // namespace onggi::console::door_test
