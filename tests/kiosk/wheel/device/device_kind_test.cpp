#include "kiosk/wheel/device/device_kind.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "kiosk/wheel/device/device_access.h"

namespace onggi::device::device_kind_test {
namespace {

HidListing listed(std::uint16_t vendor, std::uint16_t product, std::uint16_t page,
                  std::uint16_t usage) {
  HidListing listing;
  listing.path = "/dev/hidraw0";
  listing.vendor = vendor;
  listing.product = product;
  listing.usage_page = page;
  listing.usage = usage;
  return listing;
}

TEST(DeviceKind, EveryListedSpaceMouseIsOneAndItsKeyboardIsNot) {
  for (const std::uint16_t id : std::initializer_list<std::uint16_t>{
           0xc62e, 0xc62f, 0xc631, 0xc632, 0xc633, 0xc635, 0xc636, 0xc638, 0xc63a, 0xc652}) {
    EXPECT_EQ(kind_of(listed(0x256f, id, 1, 8)), DeviceKind::space_mouse) << std::hex << id;
    EXPECT_EQ(kind_of(listed(0x256f, id, 1, 6)), std::nullopt) << std::hex << id;
  }
  for (const std::uint16_t id : std::initializer_list<std::uint16_t>{
           0xc603, 0xc605, 0xc606, 0xc621, 0xc623, 0xc625, 0xc626, 0xc627, 0xc628, 0xc629, 0xc62b})
    EXPECT_EQ(kind_of(listed(0x046d, id, 1, 8)), DeviceKind::space_mouse) << std::hex << id;
  EXPECT_EQ(kind_of(listed(0x046d, 0xc52b, 1, 8)), std::nullopt) << "another Logitech";
}

TEST(DeviceKind, TheOthersGoByNumbersAndUsage) {
  EXPECT_EQ(kind_of(listed(0x045e, 0x091b, 1, 0x0e)), DeviceKind::surface_dial);
  EXPECT_EQ(kind_of(listed(0x045e, 0x091b, 1, 6)), std::nullopt);
  EXPECT_EQ(kind_of(listed(0x054c, 0x0ce6, 1, 5)), DeviceKind::dual_sense);
  EXPECT_EQ(kind_of(listed(0x16c0, 0x0486, 0xffab, 0x200)), DeviceKind::polhem);
  EXPECT_EQ(kind_of(listed(0x16c0, 0x0486, 0xffc9, 4)), std::nullopt) << "a Teensy's serial port";
  EXPECT_EQ(kind_of(listed(0x1234, 0x0006, 0, 0)), DeviceKind::polhem);
  EXPECT_EQ(kind_of(listed(0x16c0, 0x27d9, 0xff00, 1)), DeviceKind::onggi_hid);
  EXPECT_EQ(kind_of(listed(0x1d50, 0x1111, 0xff00, 1)), DeviceKind::onggi_hid) << "any numbers";
  EXPECT_EQ(kind_of(listed(0x046d, 0xc077, 1, 2)), std::nullopt) << "a mouse";
  for (const KindInfo& info : device_kinds()) EXPECT_EQ(&info_of(info.kind), &info) << info.id;
}

TEST(DeviceAccess, SaysWhatIsMissingAndTheExactLineThatGivesIt) {
  HidListing listing = listed(0x256f, 0xc635, 1, 8);
  EXPECT_EQ(udev_rule(listing),
            "SUBSYSTEM==\"hidraw\", KERNELS==\"*:256F:C635.*\", GROUP=\"onggi\", MODE=\"0660\"");
  listing.path = "/dev/null";
  EXPECT_FALSE(access_problem(listing));
  listing.path = "/dev/hidraw-that-is-not-there";
  ASSERT_TRUE(access_problem(listing));
  EXPECT_NE(access_problem(listing)->what.find("No such file"), std::string::npos);
}

TEST(DeviceAccess, TheRulesThatLieInConfigNameEveryDeviceThatThereIsADriverFor) {
  std::ifstream file("config/udev/70-onggi-hid.rules");
  std::ostringstream rules;
  rules << file.rdbuf();
  ASSERT_NE(rules.str().find("GROUP=\"onggi\", MODE=\"0660\""), std::string::npos);
  // Every number of these makers, asked of the drivers' own list.
  for (const unsigned vendor : {0x256fu, 0x046du, 0x045eu, 0x054cu, 0x16c0u, 0x1234u})
    for (unsigned product = 0; product <= 0xffff; ++product) {
      bool ours = false;
      for (const auto& [page, usage] : {std::pair{1, 8}, {1, 14}, {1, 5}, {0xffab, 0x200}, {0, 0}})
        ours = ours || kind_of(listed(
                           static_cast<std::uint16_t>(vendor), static_cast<std::uint16_t>(product),
                           static_cast<std::uint16_t>(page), static_cast<std::uint16_t>(usage)));
      char name[24];
      std::snprintf(name, sizeof name, "*:%04X:%04X.*", vendor, product);
      const bool ruled = rules.str().find(name) != std::string::npos;
      if (vendor == 0x16c0 && product == 0x27d9) continue;  // A home-built hand goes by its page.
      if (ours != ruled) ADD_FAILURE() << name << (ours ? " has no rule" : " has no driver");
    }
}

// Run as root the test becomes somebody else for a moment: root may open anything.
TEST(DeviceAccess, WhoMayNotOpenADeviceIsToldEachCommandThatGivesIt) {
  HidListing listing = listed(0x256f, 0xc635, 1, 8);
  char name[] = "/tmp/onggi-no-access-XXXXXX";
  const int file = mkstemp(name);
  ASSERT_GE(file, 0);
  fchmod(file, 0);
  listing.path = name;
  const uid_t own = getuid();
  constexpr uid_t kNobody = 65534;
  if (own == 0) {
    ASSERT_EQ(setresuid(kNobody, 0, 0), 0);
  }
  const auto problem = access_problem(listing);
  if (own == 0) {
    ASSERT_EQ(setresuid(0, 0, 0), 0);
  }
  close(file);
  unlink(name);
  ASSERT_TRUE(problem);
  EXPECT_NE(problem->what.find("may not read and write"), std::string::npos);
  std::size_t at = 0;
  for (const std::string& step :
       {std::string("groupadd --system --force onggi"), udev_rule(listing),
        std::string("udevadm control --reload"), std::string("udevadm trigger"),
        std::string("usermod -aG onggi")}) {
    const std::size_t found = problem->remedy.find(step, at);
    ASSERT_NE(found, std::string::npos) << step << ", in that order";
    at = found;
  }
}

}  // namespace
}  // namespace onggi::device::device_kind_test
