#include "kiosk/settings/device_file.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace onggi::settings {
namespace {

namespace fs = std::filesystem;

DeviceRead read_text(const std::string& text) {
  std::string name = (fs::temp_directory_path() / "onggi-device-XXXXXX").string();
  const fs::path folder = mkdtemp(name.data());
  std::ofstream(folder / "onggi_hid.toml") << text;
  DeviceRead read = read_device(folder / "onggi_hid.toml", {});
  fs::remove_all(folder);
  return read;
}

TEST(DeviceFile, EveryKeyIsReadInItsUnit) {
  const DeviceRead read = read_text(
      "axes = [\"y\", \"z\", \"-x\"]\nmiddle_mm = [1, 2, 3]\nhome_mm = [60, 100, 20]\n"
      "scale = 1.5\nspeed = 0.2\ndead = 0.1\nturn_speed = 1\nsmoothing = 0.004\nlifts_after = 2\n"
      "[force]\nmax = 4.5\nslew = 300\nramp = 1\ndamping = 0.5\nstiffness_limit = 900\n"
      "[arm]\ncapstan_mm = [10, 11, 12]\ncounts = [2000, 2000, 4000]\nparked = [0, 0, -5000]\n"
      "most_milliamperes = 1500\n");
  EXPECT_TRUE(read.problems.empty()) << to_text(read.problems.front());
  EXPECT_EQ(read.def.axes[2], (device::DeviceAxis{0, -1.0}));
  EXPECT_EQ(read.def.middle, (Vec3{0.001, 0.002, 0.003}));
  EXPECT_EQ(read.def.scale, 1.5);
  EXPECT_EQ(read.def.cap(), 4.5);
  EXPECT_EQ(read.def.max_slew, 300.0);
  EXPECT_EQ(read.def.damping, 0.5);
  EXPECT_EQ(read.def.arm.capstan[1], 0.011);
  EXPECT_EQ(read.def.arm.counts[2], 4000);
  EXPECT_EQ(read.def.arm.parked[2], -5000);
}

TEST(DeviceFile, WithoutAStiffnessThatWasMeasuredThereIsNoMoreThanOneNewton) {
  EXPECT_EQ(read_text("[force]\nmax = 4.5\n").def.cap(), 1.0);
  EXPECT_EQ(read_text("[force]\nmax = 0.5\n").def.cap(), 0.5);
  EXPECT_EQ(read_text("[force]\nmax = 4.5\nstiffness_limit = 900\n").def.cap(), 4.5);
}

TEST(DeviceFile, WhatIsNoGoodIsNamedByItsLineAndTheUsualStands) {
  const DeviceRead read =
      read_text("axes = [\"x\", \"x\", \"z\"]\nscale = 100\n[force]\nmaxx = 3\nmax = 40\n");
  ASSERT_EQ(read.problems.size(), 4u);
  EXPECT_NE(read.problems[0].where.find("onggi_hid.toml:1:"), std::string::npos);
  EXPECT_NE(read.problems[0].what.find("each of the device's axes once"), std::string::npos);
  EXPECT_EQ(read.def, device::DeviceDef{});
}

}  // namespace
}  // namespace onggi::settings
