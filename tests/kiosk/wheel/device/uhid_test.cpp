// The reference device through the system's own HID: where the kernel has /dev/uhid.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/uhid.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <thread>

#include "kiosk/wheel/device/device_kind.h"
#include "kiosk/wheel/device/hidapi_bus.h"
#include "kiosk/wheel/device/reference/onggi_hid_device.h"

namespace onggi::device::uhid_test {
namespace {

TEST(Uhid, TheReferencesDescriptorIsOneThatTheSystemListsAsOnggiHid) {
  const int file = open("/dev/uhid", O_RDWR | O_CLOEXEC);
  if (file < 0) GTEST_SKIP() << "/dev/uhid is not here, or may not be opened";
  uhid_event event{};
  event.type = UHID_CREATE2;
  std::strncpy(reinterpret_cast<char*>(event.u.create2.name), "onggi-hid reference",
               sizeof event.u.create2.name - 1);
  std::memcpy(event.u.create2.rd_data, onggi_hid_report_descriptor,
              onggi_hid_report_descriptor_size);
  event.u.create2.rd_size = static_cast<std::uint16_t>(onggi_hid_report_descriptor_size);
  event.u.create2.bus = 3;  // USB
  event.u.create2.vendor = 0x16c0;
  event.u.create2.product = 0x27d9;
  ASSERT_EQ(write(file, &event, sizeof event), static_cast<ssize_t>(sizeof event));
  bool found = false;
  for (int n = 0; n < 100 && !found; ++n) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    const auto all = hidapi_bus()->list();
    found = std::any_of(all.begin(), all.end(), [](const HidListing& listing) {
      return listing.vendor == 0x16c0 && listing.product == 0x27d9 &&
             kind_of(listing) == DeviceKind::onggi_hid;
    });
  }
  close(file);
  EXPECT_TRUE(found);
}

}  // namespace
}  // namespace onggi::device::uhid_test
