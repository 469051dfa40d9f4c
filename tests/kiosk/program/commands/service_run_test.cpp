#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>

#include "kiosk/ground/files/child_process.h"
#include "kiosk/ground/files/virtual_display.h"
#include "tests/kiosk/program/commands/program.h"

namespace onggi::commands::service_run_test {
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
  std::string remembered() const { return content(folder_ / "state/runs"); }
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

  /// Runs the kiosk, whose exhibit says `exhibit`, until it has drawn and told its health; then it
  /// gets `signal`.
  Outcome run(const std::string& exhibit, int signal = SIGTERM) const {
    return run_config(
        write_exhibit(folder_, "first_touch", exhibit + "[keepsake]\nfolder = \"keepsakes\"\n"),
        signal);
  }
  /// The same with an exhibit file of this `text` alone.
  Outcome run_file(const std::string& text) const {
    const std::string config = (folder_ / "exhibit.toml").string();
    std::ofstream(config) << text;
    return run_config(config, SIGTERM);
  }

 private:
  Outcome run_config(const std::string& config, int signal) const {
    const std::string err = (folder_ / "err").string();
    const fs::path health = folder_ / "run/onggi.prom";
    fs::remove(health);
    const std::string command = "export STATE_DIRECTORY='" + (folder_ / "state").string() +
                                "' RUNTIME_DIRECTORY='" + (folder_ / "run").string() +
                                "'; exec '" ONGGI_PROGRAM "' run --window 320x240 --config '" +
                                config + "' 2>'" + err + "'";
    auto kiosk = files::ChildProcess::start("sh", {"-c", command}, {});
    if (!kiosk) return {};
    const auto runs = [&] {
      return fs::exists(health) && content(err).find("First picture") != std::string::npos;
    };
    const auto now = files::ChildProcess::Clock::now;
    for (const auto until = now() + std::chrono::seconds(60); !runs() && now() < until;)
      if (kiosk->wait_until(now() + std::chrono::milliseconds(50))) break;
    kiosk->end(signal);
    const int status = kiosk->status();
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128, "", content(err)};
  }

  ScratchFolder folder_;
  Result<std::unique_ptr<files::VirtualDisplay>> display_;
};

constexpr const char* kFourCrashes = "onggi-runs 1 running 1 crashes 3.\n";
constexpr const char* kEightCrashes = "onggi-runs 1 running 1 crashes 7.\n";
constexpr const char* kAnother = "languages = [\"ko\"]\n";

TEST(ServiceRun, AKioskThatCrashedFourTimesShowsAnExhibitThatIsKnownToBeGood) {
  const Service service;
  if (!service.has_display()) GTEST_SKIP() << "no display, and Xvfb is not installed";
  service.remember(kFourCrashes);
  const Outcome run = service.run(kAnother);
  EXPECT_THAT(run.err, HasSubstr("Safe mode"));
  EXPECT_THAT(run.err, HasSubstr("The exhibit is " + fs::absolute("config/exhibit.toml").string()));
  EXPECT_THAT(run.err, HasSubstr("First picture"));
  EXPECT_THAT(content(service / "run/onggi.prom"), HasSubstr("\nonggi_safe_mode 1\n"));
  EXPECT_EQ(service.remembered(), "onggi-runs 1 running 0 crashes 0.\n") << "it ended as asked";
}

TEST(ServiceRun, ALastGoodExhibitThatCrashesAsOftenGivesWayToThePrograms) {
  const Service service;
  if (!service.has_display()) GTEST_SKIP() << "no display, and Xvfb is not installed";
  service.keep_as_last_good(kAnother);
  service.remember(kFourCrashes);
  EXPECT_THAT(service.run("").err, HasSubstr("The exhibit is " + service.last_good()));
  service.remember(kEightCrashes);
  EXPECT_THAT(service.run("").err,
              HasSubstr("The exhibit is " + fs::absolute("config/exhibit.toml").string()));
}

TEST(ServiceRun,
     AnExhibitThatWasBrokenWhileTheMachineWasOffGivesWayToTheLastGoodOneUntilItIsMended) {
  const Service service;
  if (!service.has_display()) GTEST_SKIP() << "no display, and Xvfb is not installed";
  service.keep_as_last_good(kAnother);
  EXPECT_THAT(service.run("").err, Not(HasSubstr("last good exhibit")));
  const Outcome broken = service.run("shelf = [\n");
  EXPECT_THAT(broken.err, HasSubstr("exhibit.toml:"));
  EXPECT_THAT(broken.err, HasSubstr("The last good exhibit is shown"));
  EXPECT_THAT(broken.err, Not(HasSubstr("Safe mode")));
  service.keep_as_last_good("crediit = \"a slip that nobody minded\"\n");
  EXPECT_THAT(service.run("crediit = \"us\"\n").err,
              Not(HasSubstr("The last good exhibit is shown")));
}

TEST(ServiceRun, AnExhibitFileThatAPowerCutLeftEmptyGivesWayToTheLastGoodOneToo) {
  const Service service;
  if (!service.has_display()) GTEST_SKIP() << "no display, and Xvfb is not installed";
  service.keep_as_last_good(kAnother);
  const Outcome empty = service.run_file("");
  EXPECT_THAT(empty.err, HasSubstr("The exhibit file has no settings."));
  EXPECT_THAT(empty.err, HasSubstr("The last good exhibit is shown"));
}

TEST(ServiceRun, AKilledKioskIsACrashAndOneThatEndsAsAskedIsNone) {
  const Service service;
  if (!service.has_display()) GTEST_SKIP() << "no display, and Xvfb is not installed";
  service.run("", SIGKILL);
  EXPECT_EQ(service.remembered(), "onggi-runs 1 running 1 crashes 0.\n");
  EXPECT_THAT(service.run("").err, Not(HasSubstr("Safe mode")));
  EXPECT_EQ(service.remembered(), "onggi-runs 1 running 0 crashes 0.\n");
}

}  // namespace
}  // namespace onggi::commands::service_run_test
