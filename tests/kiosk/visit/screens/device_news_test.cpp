#include "kiosk/visit/screens/device_news.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace onggi::screens::device_news_test {
namespace {

using device::DeviceKind;

TEST(DeviceNews, WhatComesAndGoesIsSaidForSixSecondsEach) {
  DeviceNews news;
  news.update(0.0, false);
  EXPECT_EQ(news.key(), "");
  news.device_added(DeviceKind::space_mouse, false);
  news.update(1.0, false);
  EXPECT_EQ(news.key(), "throw.device_puck");
  news.update(6.9, false);
  EXPECT_EQ(news.key(), "throw.device_puck");
  news.update(7.1, false);
  EXPECT_EQ(news.key(), "");
  news.device_removed(DeviceKind::space_mouse);
  news.update(8.0, false);
  EXPECT_EQ(news.key(), "throw.device_lost");
}

TEST(DeviceNews, AForceDevicePluggedInAgainAsksToBeHeldUntilItIs) {
  DeviceNews news;
  news.device_added(DeviceKind::onggi_hid, true);
  news.update(0.0, true);
  EXPECT_EQ(news.key(), "throw.device_force") << "the first time it only says what it is";
  news.device_removed(DeviceKind::onggi_hid);
  news.update(10.0, false);
  EXPECT_EQ(news.key(), "throw.device_lost");
  news.device_added(DeviceKind::onggi_hid, true);
  for (double now = 12.0; now < 60.0; now += 1.0) {
    news.update(now, true);
    EXPECT_EQ(news.key(), "throw.device_hold") << now;
  }
  news.update(61.0, false);
  EXPECT_EQ(news.key(), "") << "somebody holds it";
}

TEST(DeviceNews, WhichDeviceMovesTheHandIsSaidForAsLongAsItDoes) {
  DeviceNews news;
  EXPECT_EQ(news.in_use(), "");
  news.device_in_use(DeviceKind::onggi_hid, true);
  EXPECT_EQ(news.in_use(), "throw.with_force");
  EXPECT_TRUE(news.pushes());
  news.device_in_use(DeviceKind::space_mouse, true);
  EXPECT_EQ(news.in_use(), "throw.with_puck");
  news.device_in_use(std::nullopt, false);
  EXPECT_EQ(news.in_use(), "") << "a finger needs no words";
  EXPECT_FALSE(news.pushes());
}

TEST(DeviceNews, EveryKeyThatCanBeSaidIsListed) {
  const auto keys = DeviceNews::keys();
  for (const device::KindInfo& info : device::device_kinds()) {
    DeviceNews news;
    news.device_added(info.kind, info.force);
    news.update(0.0, false);
    EXPECT_NE(std::find(keys.begin(), keys.end(), news.key()), keys.end()) << info.id;
  }
}

}  // namespace
}  // namespace onggi::screens::device_news_test
