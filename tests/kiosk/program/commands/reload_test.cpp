#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <thread>

#include "kiosk/ground/files/child_process.h"
#include "kiosk/ground/files/virtual_display.h"
#include "tests/kiosk/program/commands/program.h"

namespace onggi::commands::reload_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
namespace fs = std::filesystem;

/// A site of one's own with one vessel, open on a display.
class OpenSite {
 public:
  OpenSite() : display_(files::VirtualDisplay::ensure(640, 480)) {
    fs::copy("config", folder_ / "config", fs::copy_options::recursive);
    fs::create_directories(folder_ / "content/vessels");
    fs::copy("content/lessons", folder_ / "content/lessons", fs::copy_options::recursive);
    fs::copy("content/ways", folder_ / "content/ways", fs::copy_options::recursive);
    fs::copy("content/glazes.toml", folder_ / "content/glazes.toml");
    fs::copy("content/missions.toml", folder_ / "content/missions.toml");
    add_vessel("tea_bowl");
    if (!display_) return;
    const std::string command = "exec '" ONGGI_PROGRAM "' run --window 320x240 --config '" +
                                exhibit().string() + "' 2>'" + (folder_ / "log").string() + "'";
    kiosk_ = std::make_unique<files::ChildProcess>(
        std::move(*files::ChildProcess::start("sh", {"-c", command}, {})));
  }
  ~OpenSite() {
    if (kiosk_) kiosk_->end(SIGTERM);
  }
  bool has_display() const { return display_.has_value(); }
  fs::path exhibit() const { return folder_ / "config/exhibit.toml"; }
  void add_vessel(const std::string& id) {
    fs::copy("content/vessels/" + id, folder_ / ("content/vessels/" + id),
             fs::copy_options::recursive);
  }
  std::string log() const { return content(folder_ / "log"); }
  int times(const std::string& words) const {
    const std::string log = this->log();
    int n = 0;
    for (std::size_t at = 0; (at = log.find(words, at)) != std::string::npos; ++at) ++n;
    return n;
  }
  /// Waits for the `n`th line with `words`.
  bool says(const std::string& words, int n = 1) const {
    for (int i = 0; i < 1200 && times(words) < n; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    return times(words) >= n;
  }

 private:
  ScratchFolder folder_;
  Result<std::unique_ptr<files::VirtualDisplay>> display_;
  std::unique_ptr<files::ChildProcess> kiosk_;
};

TEST(Reload, AVesselPutOnTheShelfIsShownAndABrokenExhibitLeavesTheOldOneOpenAndSaysSo) {
  OpenSite site;
  if (!site.has_display()) GTEST_SKIP() << "no display, and Xvfb is not installed";
  ASSERT_TRUE(site.says("The shelf holds 1 vessel;")) << site.log();
  ASSERT_TRUE(site.says("Watching for changes of the exhibit")) << site.log();

  site.add_vessel("moon_jar");
  EXPECT_TRUE(site.says("The shelf holds 2 vessels")) << site.log();

  std::ofstream(site.exhibit(), std::ios::app) << "\nshelf = [\n";
  EXPECT_TRUE(site.says("has a fault")) << site.log();
  EXPECT_THAT(site.log(), HasSubstr("exhibit.toml:"));
  EXPECT_EQ(site.times("The shelf holds"), 2) << site.log();

  fs::copy("config/exhibit.toml", site.exhibit(), fs::copy_options::overwrite_existing);
  EXPECT_TRUE(site.says("The shelf holds 2 vessels", 2)) << site.log();
}

}  // namespace
}  // namespace onggi::commands::reload_test
