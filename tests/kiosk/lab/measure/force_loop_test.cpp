#include "kiosk/lab/measure/force_loop.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "kiosk/wheel/device/device_file.h"
#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::measure::force_loop_test {
namespace {

namespace fs = std::filesystem;

/// A device's file in a folder of its own, gone with the object.
class File {
 public:
  File(const std::string& name, const std::string& text) {
    path = folder_ / name;
    std::ofstream(path) << text;
  }
  std::string text() const { return files::test::content(path); }
  fs::path path;

 private:
  const files::test::ScratchFolder folder_;
};

constexpr const char* kBody = "\n[body]\ndamping = 0.5\ndelay = 1   # a short wire\n";

TEST(ForceLoop, WritesTheLimitIntoForceAndLeavesEveryOtherByteAsItWas) {
  const std::string before = "# mine\nscale = 2\n\n[force]\nmax = 2.5  # N\n";
  const File file("onggi_hid.toml", before + kBody);
  const auto limit = write_stiffness_limit(file.path);
  ASSERT_TRUE(limit) << to_text(limit.error());
  EXPECT_NEAR(limit->allowed, 0.5 / 1.5e-3 / lab::kLoopMargin, 0.1);
  const std::string after = file.text();
  const std::size_t at = after.find("stiffness_limit");
  ASSERT_NE(at, std::string::npos);
  EXPECT_NE(after.find("onggi lab loop --write", at), std::string::npos) << "it says whose it is";
  std::string rest = after;
  rest.erase(at, after.find('\n', at) + 1 - at);
  EXPECT_EQ(rest, before + kBody);
  const auto read = device::read_device(file.path, {});
  EXPECT_TRUE(read.problems.empty());
  EXPECT_NEAR(read.def.coupling(), limit->allowed, 0.1);
}

TEST(ForceLoop, RenewsALimitThatTheBodyDoesNotBearAnyMore) {
  const File file("polhem.toml", std::string("[force]\nstiffness_limit = 5000\nmax = 3\n") + kBody);
  ASSERT_TRUE(write_stiffness_limit(file.path));
  EXPECT_EQ(file.text().find("5000"), std::string::npos);
  const std::string once = file.text();
  ASSERT_TRUE(write_stiffness_limit(file.path));
  EXPECT_EQ(file.text(), once);
}

TEST(ForceLoop, AFileWithoutForceGetsOne) {
  const File file("onggi_hid.toml", "scale = 1");
  ASSERT_TRUE(write_stiffness_limit(file.path));
  EXPECT_NEAR(device::read_device(file.path, {}).def.coupling(), 19.0, 0.1);
}

TEST(ForceLoop, WhatDoesNotPushOrBearsNothingIsRefusedWithARemedy) {
  const File puck("space_mouse.toml", "speed = 0.1\n");
  EXPECT_FALSE(write_stiffness_limit(puck.path));
  EXPECT_FALSE(write_stiffness_limit(puck.path.parent_path() / "onggi_hid.toml"));
  const File limp("onggi_hid.toml", "[body]\ndamping = 0\n");
  const auto refused = write_stiffness_limit(limp.path);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().remedy.find("damping"), std::string::npos);
  EXPECT_EQ(limp.text(), "[body]\ndamping = 0\n");
  const File broken("onggi_hid.toml", "scale = \"wide\"\n");
  EXPECT_FALSE(write_stiffness_limit(broken.path));
}

TEST(ForceLoop, TheFilesThatShipCarryWhatTheirBodiesBear) {
  for (const char* name : {"onggi_hid.toml", "polhem.toml"}) {
    const std::string text = files::test::content(std::string("config/devices/") + name);
    const File file(name, text);
    ASSERT_TRUE(write_stiffness_limit(file.path)) << name;
    EXPECT_EQ(file.text(), text) << "run onggi lab loop --write config/devices/" << name;
  }
}

}  // namespace
}  // namespace onggi::measure::force_loop_test
