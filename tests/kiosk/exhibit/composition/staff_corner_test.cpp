#include "kiosk/exhibit/composition/staff_corner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "kiosk/ground/secrets/digest.h"
#include "kiosk/keepsake/souvenir/staff_notice.h"
#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::exhibit::staff_corner_test {
namespace {

using view::InputEvent;
using Kind = InputEvent::Kind;

constexpr int kWidth = 1280, kHeight = 720;

class Corner : public ::testing::Test {
 protected:
  Corner() { EXPECT_TRUE(notice_.put_up("https://kiosk.museum.org")); }
  /// The kinds that others get of an event.
  std::vector<Kind> pass(Kind kind, float x, float y, double now) {
    std::vector<Kind> kinds;
    for (const InputEvent& event :
         corner_.pass({.kind = kind, .x = x, .y = y}, kWidth, kHeight, now))
      kinds.push_back(event.kind);
    return kinds;
  }
  /// The texts of a frame, if the address is on it.
  std::vector<std::string> shown(double now) {
    view::Frame frame;
    frame.width = kWidth;
    frame.height = kHeight;
    corner_.draw(frame, language_, now);
    std::vector<std::string> out;
    for (const view::Item& item : frame.items) {
      const auto* text = std::get_if<view::Text>(&item);
      if (text == nullptr) continue;
      out.push_back(text->text);
      EXPECT_TRUE(text->box.y >= 0 && text->box.y + text->box.h <= kHeight) << text->text;
    }
    return out;
  }
  void hold(double from) {
    EXPECT_TRUE(pass(Kind::pointer_down, 5, 700, from).empty());
    EXPECT_TRUE(pass(Kind::pointer_move, 12, 705, from + 2).empty());
  }

  const files::test::ScratchFolder folder_;
  souvenir::StaffNotice notice_{folder_.path()};
  StaffCorner corner_{folder_.path(), [] { return std::int64_t{1'780'000'000}; }};
  content::Language language_ = content::check_language("content/languages/en.toml").language;
};

TEST_F(Corner, HeldForFiveSecondsShowsAnAddressWhoseDigestIsKnown) {
  hold(10);
  EXPECT_TRUE(shown(14.9).empty());
  EXPECT_FALSE(corner_.way_in());
  const auto words = shown(15.1);
  ASSERT_EQ(words.size(), 3u);
  const std::string address = words.back();
  const std::size_t code = address.find("/?code=");
  ASSERT_EQ(address.substr(0, code), "https://kiosk.museum.org");
  ASSERT_TRUE(corner_.way_in());
  EXPECT_EQ(corner_.way_in()->digest, secrets::digest_of(address.substr(code + 7)));
  EXPECT_EQ(corner_.way_in()->until, 1'780'000'000 + 3600);
}

TEST_F(Corner, TheAddressGoesWithTheNextTouchOrByItself) {
  hold(10);
  EXPECT_FALSE(shown(15.1).empty());
  EXPECT_TRUE(pass(Kind::pointer_up, 5, 700, 16).empty());
  EXPECT_FALSE(shown(16.1).empty());
  EXPECT_TRUE(pass(Kind::pointer_down, 600, 300, 20).empty()) << "that touch is for nothing else";
  EXPECT_TRUE(shown(20.1).empty());
  EXPECT_EQ(pass(Kind::pointer_up, 600, 300, 20.2), std::vector{Kind::pointer_up});
  const auto first = corner_.way_in();
  hold(30);
  EXPECT_FALSE(shown(35.1).empty());
  EXPECT_NE(corner_.way_in(), first) << "another code each time";
  EXPECT_TRUE(shown(35.1 + StaffCorner::kShown + 1).empty());
}

TEST_F(Corner, AShorterTouchIsAVisitorsAsEver) {
  EXPECT_TRUE(pass(Kind::pointer_down, 5, 5, 10).empty());
  EXPECT_EQ(pass(Kind::pointer_up, 5, 5, 12), (std::vector{Kind::pointer_down, Kind::pointer_up}));
  EXPECT_TRUE(pass(Kind::pointer_down, 1275, 5, 20).empty());
  EXPECT_EQ(pass(Kind::pointer_move, 1100, 60, 20.5),
            (std::vector{Kind::pointer_down, Kind::pointer_move}));
  EXPECT_EQ(pass(Kind::pointer_up, 1100, 60, 27), std::vector{Kind::pointer_up});
  EXPECT_TRUE(shown(28).empty());
  EXPECT_EQ(pass(Kind::pointer_down, 640, 360, 30), std::vector{Kind::pointer_down});
  EXPECT_TRUE(shown(40).empty());
}

TEST_F(Corner, OfAKioskWhoseStaffHaveNamesIsLikeTheRestOfTheScreen) {
  notice_.take_away();
  EXPECT_EQ(pass(Kind::pointer_down, 5, 5, 10), std::vector{Kind::pointer_down});
  EXPECT_TRUE(shown(20).empty());
  EXPECT_FALSE(corner_.way_in());
}

}  // namespace
}  // namespace onggi::exhibit::staff_corner_test
