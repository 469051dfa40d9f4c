#include "kiosk/program/console/served_at.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace onggi::console::served_at_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(ServedAt, ThisMachineAloneHasItsOwnNamesAndAPlainCookie) {
  const ServedAt at = served_here("127.0.0.1", 8090);
  EXPECT_THAT(at.pages, ElementsAre("http://127.0.0.1:8090"));
  EXPECT_THAT(at.hosts, ElementsAre("127.0.0.1:8090", "localhost:8090"));
  EXPECT_FALSE(at.https);
  EXPECT_EQ(at.cookie, "onggi_staff_8090");
  EXPECT_THAT(served_here("::1", 80).hosts, ElementsAre("[::1]", "localhost"));
}

TEST(ServedAt, AProxysAddressesAreHostsAsABrowserWritesThem) {
  const auto at = served_by_proxy({"https://192.168.1.20", "https://kiosk.local:443",
                                   "https://kiosk:8443", "https://[fd00::1]:8443"});
  ASSERT_TRUE(at) << to_text(at.error());
  EXPECT_THAT(at->hosts, ElementsAre("192.168.1.20", "kiosk.local", "kiosk:8443", "[fd00::1]:8443"))
      << "a browser leaves the usual port out";
  EXPECT_EQ(at->pages.front(), "https://192.168.1.20");
  EXPECT_TRUE(at->https);
  EXPECT_TRUE(at->cookie.starts_with("__Host-")) << at->cookie;
}

TEST(ServedAt, WhatIsNoAddressOfAPageIsRefusedByName) {
  for (const char* wrong :
       {"http://192.168.1.20", "192.168.1.20", "https://", "https://:443", "https://a b",
        "https://kiosk/", "https://kiosk:0", "https://kiosk:99999", "https://kiosk:x",
        "https://KIOSK", "https://a;b", "https://[fd00::1", "https://user@kiosk"}) {
    const auto at = served_by_proxy({"https://good", wrong});
    ASSERT_FALSE(at) << wrong;
    EXPECT_THAT(at.error().where, HasSubstr(wrong));
    EXPECT_EQ(at.error().exit_code, 2);
  }
  EXPECT_THAT(to_text(served_by_proxy({}).error()), HasSubstr("--address is missing"));
}

}  // namespace
}  // namespace onggi::console::served_at_test
