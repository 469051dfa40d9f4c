#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "kiosk/ground/files/virtual_display.h"
#include "tests/kiosk/program/commands/program.h"

namespace onggi::commands {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
namespace fs = std::filesystem;

/// A service's folders, as systemd gives them, and a display.
class Service {
 public:
  Service() {
    fs::create_directories(folder_ / "state");
    fs::create_directories(folder_ / "run");
    display_ = files::VirtualDisplay::ensure(640, 480);
  }
  bool has_display() const { return display_.has_value(); }
  void remember(const std::string& runs) const { std::ofstream(folder_ / "state/runs") << runs; }
  std::string remembered() const { return text_of(folder_ / "state/runs"); }
  /// A last good exhibit, which says `exhibit`, as the kiosk keeps it.
  void keep_as_last_good(const std::string& exhibit) const {
    fs::create_directories(folder_ / "state/last_good/config");
    fs::rename(write_exhibit(folder_, "first_touch", exhibit), last_good());
    std::ofstream(folder_ / "state/last_good/files.txt")
        << (folder_ / "keepsakes").string() << '\n';
  }
  std::string last_good() const {
    return (folder_ / "state/last_good/config/exhibit.toml").string();
  }
  fs::path operator/(const std::string& name) const { return folder_ / name; }

  /// Runs the kiosk, whose exhibit says `exhibit`, until `signal` some seconds later.
  Outcome run(const std::string& exhibit, const std::string& signal, int seconds) const {
    const std::string config =
        write_exhibit(folder_, "first_touch", exhibit + "[keepsake]\nfolder = \"keepsakes\"\n");
    return run_config(config, signal, seconds);
  }
  /// The same with an exhibit file of this `text` alone.
  Outcome run_file(const std::string& text, const std::string& signal, int seconds) const {
    const std::string config = (folder_ / "exhibit.toml").string();
    std::ofstream(config) << text;
    return run_config(config, signal, seconds);
  }

 private:
  Outcome run_config(const std::string& config, const std::string& signal, int seconds) const {
    const std::string err = (folder_ / "err").string();
    const std::string command =
        "STATE_DIRECTORY='" + (folder_ / "state").string() + "' RUNTIME_DIRECTORY='" +
        (folder_ / "run").string() + "' timeout -s " + signal + " " + std::to_string(seconds) +
        " '" ONGGI_PROGRAM "' run --window 320x240 --config '" + config + "' 2>'" + err + "'";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128, "", text_of(err)};
  }

  TemporaryFolder folder_;
  Result<std::unique_ptr<files::VirtualDisplay>> display_;
};

constexpr const char* kFourCrashes = "onggi-runs 1 running 1 crashes 3.\n";
constexpr const char* kEightCrashes = "onggi-runs 1 running 1 crashes 7.\n";
constexpr const char* kAnother = "languages = [\"ko\"]\n";

TEST(ServiceRun, AKioskThatCrashedFourTimesShowsAnExhibitThatIsKnownToBeGood) {
  const Service service;
  if (!service.has_display()) GTEST_SKIP() << "no display, and Xvfb is not installed";
  service.remember(kFourCrashes);
  const Outcome run = service.run(kAnother, "TERM", 3);
  EXPECT_THAT(run.err, HasSubstr("Safe mode"));
  EXPECT_THAT(run.err, HasSubstr("The exhibit is " + fs::absolute("config/exhibit.toml").string()));
  EXPECT_THAT(run.err, HasSubstr("First picture"));
  EXPECT_THAT(text_of(service / "run/onggi.prom"), HasSubstr("\nonggi_safe_mode 1\n"));
  EXPECT_EQ(service.remembered(), "onggi-runs 1 running 0 crashes 0.\n") << "it ended as asked";
}

TEST(ServiceRun, ALastGoodExhibitThatCrashesAsOftenGivesWayToThePrograms) {
  const Service service;
  if (!service.has_display()) GTEST_SKIP() << "no display, and Xvfb is not installed";
  service.keep_as_last_good(kAnother);
  service.remember(kFourCrashes);
  EXPECT_THAT(service.run("", "TERM", 2).err, HasSubstr("The exhibit is " + service.last_good()));
  service.remember(kEightCrashes);
  EXPECT_THAT(service.run("", "TERM", 2).err,
              HasSubstr("The exhibit is " + fs::absolute("config/exhibit.toml").string()));
}

TEST(ServiceRun,
     AnExhibitThatWasBrokenWhileTheMachineWasOffGivesWayToTheLastGoodOneUntilItIsMended) {
  const Service service;
  if (!service.has_display()) GTEST_SKIP() << "no display, and Xvfb is not installed";
  service.keep_as_last_good(kAnother);
  EXPECT_THAT(service.run("", "TERM", 2).err, Not(HasSubstr("last good exhibit")));
  const Outcome broken = service.run("shelf = [\n", "TERM", 2);
  EXPECT_THAT(broken.err, HasSubstr("exhibit.toml:"));
  EXPECT_THAT(broken.err, HasSubstr("The last good exhibit is shown"));
  EXPECT_THAT(broken.err, Not(HasSubstr("Safe mode")));
  service.keep_as_last_good("crediit = \"a slip that nobody minded\"\n");
  EXPECT_THAT(service.run("crediit = \"us\"\n", "TERM", 2).err,
              Not(HasSubstr("The last good exhibit is shown")));
}

TEST(ServiceRun, AnExhibitFileThatAPowerCutLeftEmptyGivesWayToTheLastGoodOneToo) {
  const Service service;
  if (!service.has_display()) GTEST_SKIP() << "no display, and Xvfb is not installed";
  service.keep_as_last_good(kAnother);
  const Outcome empty = service.run_file("", "TERM", 2);
  EXPECT_THAT(empty.err, HasSubstr("The exhibit file has no settings."));
  EXPECT_THAT(empty.err, HasSubstr("The last good exhibit is shown"));
}

TEST(ServiceRun, AKilledKioskIsACrashAndOneThatEndsAsAskedIsNone) {
  const Service service;
  if (!service.has_display()) GTEST_SKIP() << "no display, and Xvfb is not installed";
  service.run("", "KILL", 1);
  EXPECT_EQ(service.remembered(), "onggi-runs 1 running 1 crashes 0.\n");
  EXPECT_THAT(service.run("", "TERM", 2).err, Not(HasSubstr("Safe mode")));
  EXPECT_EQ(service.remembered(), "onggi-runs 1 running 0 crashes 0.\n");
}

}  // namespace
}  // namespace onggi::commands
