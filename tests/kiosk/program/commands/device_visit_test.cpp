#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "engine/scene/replay.h"
#include "kiosk/ground/files/replay_file.h"
#include "kiosk/keepsake/store/database.h"
#include "tests/kiosk/program/commands/program.h"

// The real program with simulated devices under hidapi's names (tests/stand_in).

namespace onggi::commands::device_visit_test {
namespace {

using Json = nlohmann::json;

/// What the shell does before the program, so that it finds the devices of `scenario`.
std::string plugged_in(const ScratchFolder& folder, const std::string& scenario) {
  const std::string file = (folder / "scenario").string();
  std::ofstream(file) << scenario;
  return "export LD_PRELOAD='" ONGGI_HID_STAND_IN "' ONGGI_STAND_IN='" + file + "'";
}

TEST(Devices, EachIsListedWithWhatItWouldDoAndTheThirdHandIsNotUsed) {
  const ScratchFolder folder;
  const std::string first = plugged_in(folder,
                                       "clock reads\ndevice space_mouse\ndevice surface_dial\n"
                                       "device onggi_hid\ndevice polhem\ndevice dual_sense\n");
  const Outcome run = onggi("devices --json -", first);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json devices = Json::parse(run.out).at("devices");
  ASSERT_EQ(devices.size(), 5u);
  EXPECT_EQ(devices[0].at("kind"), "space_mouse");
  EXPECT_EQ(devices[0].at("use"), "moves a hand (the first)");
  EXPECT_EQ(devices[1].at("use"), "turns the wheel");
  EXPECT_EQ(devices[2].at("force"), true);
  EXPECT_EQ(devices[2].at("usable"), true);
  EXPECT_EQ(devices[3].at("verified_on_hardware"), false);
  EXPECT_NE(devices[3].at("use").get<std::string>().find("not used"), std::string::npos);
  EXPECT_NE(onggi("devices", first).out.find("not been tested on real hardware"),
            std::string::npos);
  EXPECT_NE(onggi("devices", plugged_in(folder, "clock reads\n")).out.find("mouse and touch"),
            std::string::npos);
}

/// Where the tool was at each tick of a kept visit, as a simulated hand's track.
std::string track_of(const Json& visit, const ScratchFolder& folder) {
  const auto replay = files::read_replay(visit.at("files").at(2).get<std::string>());
  EXPECT_TRUE(replay);
  const std::string file = (folder / "track").string();
  std::ofstream out(file);
  for (const TickRecord& tick : replay->ticks) {
    const HandInput& hand = tick.hands.hand[0];
    out << hand.position.x << ' ' << hand.position.y << ' ' << hand.position.z << ' ' << hand.active
        << '\n';
  }
  return file;
}

/// A shelf of one vessel: reading and drawing all of them would be most of the work.
Json visit(const ScratchFolder& folder, const std::string& name, const std::string& hand,
           const std::string& first) {
  const std::filesystem::path shelf = folder / "shelf";
  std::filesystem::create_directory(shelf);
  std::filesystem::copy(
      "content/vessels/moon_jar", shelf / "moon_jar",
      std::filesystem::copy_options::recursive | std::filesystem::copy_options::skip_existing);
  const Outcome run =
      onggi("visit --script groove --vessel moon_jar --window 320x240 --shelf " + shelf.string() +
                " --hand " + hand + " --json - --out " + (folder / name).string(),
            first);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return run.exit_code == 0 ? Json::parse(run.out) : Json();
}

/// How alike two kept pots are: RMS distance of their outlines, mm.
double apart_mm(const Json& a, const Json& b) {
  const Outcome run = onggi("score " + a.at("files").at(1).get<std::string>() + " " +
                            b.at("files").at(1).get<std::string>() + " --json -");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return Json::parse(run.out).at("measures").at("outline_rms").get<double>() * 1e3 *
         a.at("height").get<double>();
}

Replay replay_of(const Json& visit) {
  auto replay = files::read_replay(visit.at("files").at(2).get<std::string>());
  EXPECT_TRUE(replay);
  return std::move(*replay);
}

struct Told {
  long ms = 0;  ///< Of the device's time.
  std::vector<int> bytes;
};

/// What a world's record says was sent to its device `number`, a report each.
std::vector<Told> told(const std::string& record, int number) {
  std::vector<Told> all;
  std::ifstream in(record);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string path, way;
    Told report;
    words >> path >> report.ms >> way;
    if (way != "out" || path != "stand-in/hidraw" + std::to_string(number)) continue;
    for (std::string byte; words >> byte;) report.bytes.push_back(std::stoi(byte, nullptr, 16));
    all.push_back(std::move(report));
  }
  return all;
}

int strokes_of(const Replay& replay) {
  int strokes = 0;
  bool down = false;
  for (const TickRecord& tick : replay.ticks)
    if (tick.hands.hand[0].active != std::exchange(down, tick.hands.hand[0].active) && down)
      ++strokes;
  return strokes;
}

bool begins_with_attract(const Json& visit) {
  return visit.at("screens").at(0).get<std::string>().find("attract") != std::string::npos;
}

// One controller by cable and one by radio, tilted opposite ways, their sticks towards the axis.
TEST(DeviceVisit, ADialBeginsTheVisitAndTurnsTheWheelTwoControllersTiltAndTrembleAndItIsCounted) {
  const ScratchFolder folder;
  const std::string record = (folder / "record").string();
  const Json kept =
      visit(folder, "felt", "device",
            plugged_in(folder, "clock reads\nrecord " + record +
                                   "\ndevice dual_sense stick 60 128 tilt 1475 9000\n"
                                   "device dual_sense bluetooth stick 60 128 tilt "
                                   "-1475 9000\ndevice surface_dial click 500 turn 400 "
                                   "5000\n"));
  EXPECT_FALSE(begins_with_attract(kept)) << "the click came first";
  const Replay replay = replay_of(kept);
  EXPECT_TRUE(std::any_of(replay.ticks.begin(), replay.ticks.end(), [](const TickRecord& t) {
    return t.hands.wheel_speed == 30.0;
  })) << "40 degrees are two steps of 2.5 rad/s on 25";
  // By 90 degrees about x: the handle that stood upright lies, towards the visitor and away.
  const Hands& last = replay.ticks[replay.ticks.size() / 2].hands;
  for (std::size_t n = 0; n < kMaxHands; ++n)
    EXPECT_NEAR(last.hand[n].handle.z, n == 0 ? 1.0 : -1.0, 1e-3) << n;
  for (const int number : {0, 1}) {
    const bool radio = number == 1;
    const std::size_t at = radio ? 3 : 1;
    int tap = 0, strongest = 0;
    const auto reports = told(record, number);
    for (const auto& [ms, report] : reports) {
      ASSERT_EQ(report.size(), radio ? 78u : 63u);
      EXPECT_EQ(report[0], radio ? 0x31 : 0x02);
      EXPECT_EQ(report[at], 3);
      tap = std::max(tap, report[at + 2]);
      strongest = std::max(strongest, report[at + 3]);
    }
    EXPECT_EQ(tap, 160) << number << ": a tap as the clay is met";
    EXPECT_GT(strongest, 4) << number << ": and it trembles as hard as the clay pushes";
    ASSERT_FALSE(reports.empty());
    EXPECT_EQ(reports.back().bytes[at + 2] + reports.back().bytes[at + 3], 0) << "still at the end";
  }

  // And the program that was visited has counted it (kiosk/docs/store.md).
  const std::string file = (folder / "felt").string() + "/onggi.sqlite";
  store::Database counted = store::Database::open(file, store::Database::Mode::read);
  const auto visits = [&counted](const std::string& where) {
    return counted.number("SELECT count(*) FROM visits" + where);
  };
  EXPECT_EQ(visits(""), 1);
  EXPECT_EQ(visits(" WHERE vessel = 'moon_jar' AND language = 'en' AND way = 'dual_sense'"), 1);
  EXPECT_EQ(visits(" WHERE left_at = 'keepsake' AND reached = left_at AND ended = 'finished'"), 1);
  EXPECT_EQ(visits(" WHERE kept AND pots = 1 AND likeness > 0 AND scene = 'first_touch'"), 1);
  EXPECT_EQ(visits(" WHERE throwing_s > 30 AND active_s > throwing_s AND active_s < 150"), 1);
}

TEST(DeviceVisit, APuckAndAForceDeviceThrowThePotThatTheMouseThrows) {
  const ScratchFolder folder;
  const Json by_mouse = visit(folder, "mouse", "mouse", "true");
  const std::string track = track_of(by_mouse, folder) + " " +
                            std::to_string(by_mouse.at("first_tick").get<int>()) + "\n";
  const std::string record = (folder / "record").string(), buzzed = (folder / "buzzed").string();
  const Json by_puck = visit(
      folder, "puck", "device",
      plugged_in(folder, "clock reads\nrecord " + buzzed + "\ndevice space_mouse combined track " +
                             track + "device surface_dial\n"));
  const auto buzzes = told(buzzed, 1);
  // A stroke may leave the clay and come back to it.
  const int strokes = strokes_of(replay_of(by_mouse));
  EXPECT_GE(static_cast<int>(buzzes.size()), strokes) << "each time that a tool meets the clay";
  EXPECT_LE(static_cast<int>(buzzes.size()), 2 * strokes);
  for (const auto& buzz : buzzes) {
    EXPECT_EQ(buzz.bytes, (std::vector<int>{1, 1, 3, 0, 0}));
    EXPECT_GT(buzz.ms, by_mouse.at("first_tick").get<long>()) << "never in attract";
  }
  EXPECT_TRUE(begins_with_attract(by_puck));
  EXPECT_LT(apart_mm(by_mouse, by_puck), 0.05);
  const Json by_force = visit(
      folder, "force", "device",
      plugged_in(folder, "clock reads\nrecord " + record + "\ndevice onggi_hid track " + track));
  // The tool hangs back behind the handle by force / stiffness (engine/force/coupling.h), and the
  // hand that holds it does not know.
  EXPECT_LT(apart_mm(by_mouse, by_force), 0.2);
  // Left alone the lump's wall is as thick everywhere: so they made it.
  EXPECT_LT(by_mouse.at("measures").at("made").at("wall_evenness").get<double>(), 0.98);

  // The clay pushed back, and never with more than the device's file allows.
  std::ifstream in(record);
  double strongest = 0.0;
  int forces = 0;
  for (std::string path, way, line; in >> path;) {
    long ms = 0;
    in >> ms >> way;
    std::getline(in, line);
    if (way != "out" || line.rfind(" 02 02", 0) != 0) continue;
    double square = 0.0;
    for (int n = 0; n < 3; ++n) {
      const auto low = std::stoi(line.substr(13 + 6 * static_cast<std::size_t>(n), 2), nullptr, 16);
      const auto high =
          std::stoi(line.substr(16 + 6 * static_cast<std::size_t>(n), 2), nullptr, 16);
      const double newtons = static_cast<std::int16_t>(low | high << 8) * 1e-3;
      square += newtons * newtons;
    }
    strongest = std::max(strongest, std::sqrt(square));
    ++forces;
  }
  EXPECT_GT(forces, 10'000);
  EXPECT_GT(strongest, 0.3);
  EXPECT_LE(strongest, 3.3);
}

}  // namespace
}  // namespace onggi::commands::device_visit_test
