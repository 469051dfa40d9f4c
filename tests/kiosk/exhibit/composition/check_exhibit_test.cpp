#include "kiosk/exhibit/composition/check_exhibit.h"

#include <gtest/gtest.h>

namespace onggi::exhibit {
namespace {

TEST(CheckExhibit, AskedToStopItComesToNoFurtherVessel) {
  std::stop_source stop;
  const auto whole = check_path("", "config/exhibit.toml", stop.get_token());
  stop.request_stop();
  const auto cut = check_path("", "config/exhibit.toml", stop.get_token());
  ASSERT_TRUE(whole && cut);
  EXPECT_EQ(whole->vessels, 12);
  EXPECT_EQ(cut->vessels, 0);
}

}  // namespace
}  // namespace onggi::exhibit
