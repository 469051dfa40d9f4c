#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "kiosk/files/child_process.h"
#include "kiosk/files/virtual_display.h"
#include "kiosk/store/database.h"
#include "tests/kiosk/commands/program.h"

namespace onggi::commands {
namespace {

// A dial is pressed ever more seldom: the first press that finds the kiosk open begins the visit,
// however long that takes, and too few follow to end it.
TEST(Run, AVisitUnderWayWhenTheProgramIsAskedToEndIsCountedThoughTheFormerStoreIsDamaged) {
  const TemporaryFolder folder;
  const auto display = files::VirtualDisplay::ensure(640, 480);
  if (!display) GTEST_SKIP() << "no display, and Xvfb is not installed";
  const std::string scenario = (folder / "scenario").string(), log = (folder / "log").string();
  {
    std::ofstream out(scenario);
    out << "clock real\ndevice surface_dial";
    for (int ms = 1000; ms < 100'000; ms *= 2) out << " click " << ms;
    out << '\n';
  }
  // Apart from what is written: a change beside the exhibit opens it anew.
  const TemporaryFolder site;
  const std::string exhibit = write_exhibit(
      site, "first_touch", "[keepsake]\nfolder = \"" + (folder / "kept").string() + "\"\n");
  std::filesystem::create_directories(folder / "kept");
  std::ofstream(folder / "kept/onggi.sqlite") << std::string(20'000, 'x');
  const std::string command =
      "export LD_PRELOAD='" ONGGI_HID_STAND_IN "' ONGGI_STAND_IN='" + scenario +
      "'; exec '" ONGGI_PROGRAM "' run --window 320x240 --config '" + exhibit + "' 2>'" + log + "'";
  auto kiosk = files::ChildProcess::start("sh", {"-c", command}, {});
  ASSERT_TRUE(kiosk);
  for (int n = 0; n < 1200 && text_of(log).find("First picture") == std::string::npos; ++n)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  std::this_thread::sleep_for(std::chrono::milliseconds(6000));
  kiosk->end(SIGTERM);
  EXPECT_EQ(kiosk->status(), 0) << text_of(log);
  const std::string said = text_of(log), aside = "is set aside as onggi.sqlite.damaged-";
  ASSERT_NE(said.find(aside), std::string::npos) << said;
  EXPECT_EQ(said.find(aside), said.rfind(aside)) << "once";
  store::Database counted =
      store::Database::open(folder / "kept/onggi.sqlite", store::Database::Mode::read);
  EXPECT_EQ(counted.number("SELECT count(*) FROM visits"), 1) << text_of(log);
  EXPECT_EQ(counted.number("SELECT count(*) FROM visits WHERE ended = 'closed'"), 1);
}

}  // namespace
}  // namespace onggi::commands
