#include "kiosk/program/console/vessel_sheets.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::console::vessel_sheets_test {
namespace {

namespace fs = std::filesystem;

class Sheets : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_ / "jar");
    std::ofstream(folder_ / "jar/vessel.toml") << "a = 1\n";
    std::ofstream(folder_ / "jar/vessel.glb") << "shape";
    program(
        "for file; do :; done; printf drawn > \"$file\"; echo '{\"outer\": [[0, 0.05], [0.1, "
        "0.06]]}'");
  }
  void program(const std::string& script) const {
    std::ofstream(folder_ / "onggi") << "#!/bin/sh\n" << script << '\n';
    fs::permissions(folder_ / "onggi", fs::perms(0755));
  }
  VesselSheets::Sheet known(VesselSheets& sheets) const {
    VesselSheets::Sheet sheet;
    for (int n = 0; n < 3000 && sheet.png.empty() && sheet.trouble.empty(); ++n) {
      sheet = sheets.of(folder_ / "jar");
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return sheet;
  }
  const files::test::ScratchFolder folder_;
};

TEST_F(Sheets, AreDrawnOnceAndAnewWhereTheVesselChanged) {
  VesselSheets sheets(folder_ / "onggi", folder_ / "kept");
  EXPECT_EQ(sheets.of(folder_ / "jar").png, "") << "nobody waits for it";
  EXPECT_EQ(known(sheets).png, "drawn");
  EXPECT_TRUE(known(sheets).outline.starts_with("<svg"));
  program("exit 1");
  EXPECT_EQ(known(sheets).png, "drawn");
  std::ofstream(folder_ / "jar/vessel.toml") << "a = 22\n";
  EXPECT_EQ(known(sheets).png, "");
  EXPECT_NE(known(sheets).trouble, "");
}

TEST_F(Sheets, ThatCannotBeDrawnSayWhy) {
  program("echo '{\"done\": false, \"what\": \"It has no wall.\"}'; exit 2");
  VesselSheets sheets(folder_ / "onggi", folder_ / "kept");
  EXPECT_EQ(known(sheets).trouble, "It has no wall.");
}

}  // namespace
}  // namespace onggi::console::vessel_sheets_test
