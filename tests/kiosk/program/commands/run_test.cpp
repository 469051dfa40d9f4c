#include <gtest/gtest.h>
#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "kiosk/ground/files/child_process.h"
#include "kiosk/ground/files/virtual_display.h"
#include "kiosk/keepsake/store/database.h"
#include "tests/kiosk/program/commands/doomed_server.h"
#include "tests/kiosk/program/commands/program.h"

namespace onggi::commands::run_test {
namespace {

struct Counted {
  std::int64_t visits = 0, closed = 0;
  std::string log;
};

/// Runs the kiosk with a damaged store until `seconds` after its first picture, and asks it to end.
/// A dial is pressed ever more seldom: the first press that finds the kiosk open begins the visit,
/// and too few follow to end it.
Counted counted_of_a_visit(int seconds) {
  const ScratchFolder folder;
  const std::string scenario = (folder / "scenario").string(), log = (folder / "log").string();
  {
    std::ofstream out(scenario);
    out << "clock real\ndevice surface_dial";
    for (int ms = 1000; ms < 100'000; ms *= 2) out << " click " << ms;
    out << '\n';
  }
  // Apart from what is written: a change beside the exhibit opens it anew.
  const ScratchFolder site;
  const std::string exhibit = write_exhibit(
      site, "first_touch", "[keepsake]\nfolder = \"" + (folder / "kept").string() + "\"\n");
  std::filesystem::create_directories(folder / "kept");
  std::ofstream(folder / "kept/onggi.sqlite") << std::string(20'000, 'x');
  const std::string command =
      "export LD_PRELOAD='" ONGGI_HID_STAND_IN "' ONGGI_STAND_IN='" + scenario +
      "'; exec '" ONGGI_PROGRAM "' run --window 320x240 --config '" + exhibit + "' 2>'" + log + "'";
  auto kiosk = files::ChildProcess::start("sh", {"-c", command}, {});
  if (!kiosk) return {};
  for (int n = 0; n < 1200 && content(log).find("First picture") == std::string::npos; ++n)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  std::this_thread::sleep_for(std::chrono::seconds(seconds));
  kiosk->end(SIGTERM);
  EXPECT_EQ(kiosk->status(), 0) << content(log);
  store::Database store =
      store::Database::open(folder / "kept/onggi.sqlite", store::Database::Mode::read);
  return {store.number("SELECT count(*) FROM visits").value_or(0),
          store.number("SELECT count(*) FROM visits WHERE ended = 'closed'").value_or(0),
          content(log)};
}

TEST(Run, AVisitUnderWayWhenTheProgramIsAskedToEndIsCountedThoughTheFormerStoreIsDamaged) {
  const auto display = files::VirtualDisplay::ensure(640, 480);
  if (!display) GTEST_SKIP() << "no display, and Xvfb is not installed";
  // On a busy machine no press may have found the kiosk open by then: it gets longer.
  Counted counted;
  for (int seconds = 6; seconds < 60 && counted.visits == 0; seconds *= 2)
    counted = counted_of_a_visit(seconds);
  const std::string& said = counted.log;
  const std::string aside = "is set aside as onggi.sqlite.damaged-";
  ASSERT_NE(said.find(aside), std::string::npos) << said;
  EXPECT_EQ(said.find(aside), said.rfind(aside)) << "once";
  EXPECT_EQ(counted.visits, 1) << said;
  EXPECT_EQ(counted.closed, 1);
}

TEST(Run, AVisitUnderWayWhenTheXServerEndsIsCountedAndTheProgramEndsForAnother) {
  DoomedServer server;
  if (server.name().empty()) GTEST_SKIP() << "Xvfb is not installed";
  const ScratchFolder folder, site;
  const std::string log = (folder / "log").string();
  const std::string exhibit = write_exhibit(
      site, "first_touch", "[keepsake]\nfolder = \"" + (folder / "kept").string() + "\"\n");
  auto kiosk = files::ChildProcess::start(
      "sh",
      {"-c", "export DISPLAY='" + server.name() +
                 "'; exec '" ONGGI_PROGRAM "' run --window 320x240 --config '" + exhibit + "' 2>'" +
                 log + "'"},
      {});
  ASSERT_TRUE(kiosk);
  for (int n = 0; n < 1200 && content(log).find("First picture") == std::string::npos; ++n)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  // Touches, for longer than somebody who walks by.
  ASSERT_EQ(std::system(("DISPLAY=" + server.name() +
                         " sh -c 'for n in 1 2 3 4 5 6 7 8; do xdotool mousemove 160 120 click 1; "
                         "sleep 0.6; done'")
                            .c_str()),
            0);
  server.end();
  EXPECT_TRUE(kiosk->wait_until(files::ChildProcess::Clock::now() + std::chrono::seconds(30)));
  EXPECT_TRUE(WIFEXITED(kiosk->status()) && WEXITSTATUS(kiosk->status()) == 1) << content(log);
  EXPECT_NE(content(log).find("X server is gone"), std::string::npos) << content(log);
  store::Database counted =
      store::Database::open(folder / "kept/onggi.sqlite", store::Database::Mode::read);
  EXPECT_EQ(counted.number("SELECT count(*) FROM visits WHERE ended = 'closed'"), 1)
      << content(log);
}

}  // namespace
}  // namespace onggi::commands::run_test
