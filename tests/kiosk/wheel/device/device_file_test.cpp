#include "kiosk/wheel/device/device_file.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::device::device_file_test {
namespace {

namespace fs = std::filesystem;

DeviceRead read_text(const std::string& text) {
  const files::test::ScratchFolder folder;
  std::ofstream(folder / "onggi_hid.toml") << text;
  return read_device(folder / "onggi_hid.toml", {});
}

TEST(DeviceFile, EveryKeyIsReadInItsUnit) {
  const DeviceRead read = read_text(
      "axes = [\"y\", \"z\", \"-x\"]\nmiddle_mm = [1, 2, 3]\nhome_mm = [60, 100, 20]\n"
      "scale = 1.5\nspeed = 0.2\ndead = 0.1\nturn_speed = 1\nsmoothing = 0.004\nlifts_after = 2\n"
      "[force]\nmax = 4.5\nslew = 300\nramp = 1\ndamping = 0.5\nstiffness_limit = 900\n"
      "[body]\nmass = 0.2\ndamping = 2\nfriction = 0.1\nstep_mm = 0.02\ndelay = 0\n"
      "[arm]\ncapstan_mm = [10, 11, 12]\ncounts = [2000, 2000, 4000]\nparked = [0, 0, -5000]\n"
      "most_milliamperes = 1500\n");
  EXPECT_TRUE(read.problems.empty()) << to_text(read.problems.front());
  EXPECT_EQ(read.def.axes[2], (device::DeviceAxis{0, -1.0}));
  EXPECT_EQ(read.def.middle, (Vec3{0.001, 0.002, 0.003}));
  EXPECT_EQ(read.def.scale, 1.5);
  EXPECT_EQ(read.def.cap(), 4.5);
  EXPECT_EQ(read.def.max_slew, 300.0);
  EXPECT_EQ(read.def.damping, 0.5);
  EXPECT_EQ(read.def.coupling(), 900.0);
  EXPECT_EQ(read.def.body, (device::DeviceBody{0.2, 2.0, 0.1, 2e-5, 0}));
  EXPECT_EQ(read.def.arm.capstan[1], 0.011);
  EXPECT_EQ(read.def.arm.counts[2], 4000);
  EXPECT_EQ(read.def.arm.parked[2], -5000);
}

TEST(DeviceFile, WithoutAStiffnessThatWasMeasuredThereIsNoMoreThanOneNewton) {
  EXPECT_EQ(read_text("[force]\nmax = 4.5\n").def.cap(), 1.0);
  EXPECT_EQ(read_text("[force]\nmax = 0.5\n").def.cap(), 0.5);
  EXPECT_EQ(read_text("[force]\nmax = 4.5\nstiffness_limit = 19\n").def.cap(), 4.5);
  EXPECT_EQ(read_text("").def.coupling(), device::kUnmeasuredStiffness);
}

TEST(DeviceFile, AStiffnessThatItsBodyDoesNotBearIsLeftOut) {
  const DeviceRead typed = read_text("[force]\nmax = 4.5\nstiffness_limit = 900\n");
  ASSERT_EQ(typed.problems.size(), 1u);
  EXPECT_NE(typed.problems[0].remedy.find("onggi lab loop --write"), std::string::npos);
  EXPECT_NE(typed.problems[0].where.find("onggi_hid.toml:3:"), std::string::npos);
  EXPECT_EQ(typed.def.cap(), 1.0);
  // 2 b / T / 1.5, to the digits that are written.
  const std::string body = "[body]\ndamping = 1\ndelay = 0\n";
  EXPECT_TRUE(read_text("[force]\nstiffness_limit = 1333.3\n" + body).problems.empty());
  EXPECT_FALSE(read_text("[force]\nstiffness_limit = 1400\n" + body).problems.empty());
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
}  // namespace onggi::device::device_file_test
