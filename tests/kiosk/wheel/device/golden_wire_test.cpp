// What goes over the wire to each device in one scripted session, to the byte: a change of it is a
// decision, seen here before a motor sees it.
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>

#include "kiosk/ground/files/crc32.h"
#include "tests/kiosk/ground/files/scratch_folder.h"
#include "tests/kiosk/wheel/device/rig.h"
#include "tests/stand_in/simulated_others.h"
#include "tests/stand_in/simulated_puck.h"

namespace onggi::device::golden_wire_test {
namespace {

constexpr std::size_t kShown = 8;  // Outputs of each device that are written out.

/// Taken in hand, pressed into clay and out of it, stopped, and the end.
std::string session(const std::string& name, std::unique_ptr<stand_in::SimulatedDevice> simulated) {
  Rig rig(std::move(simulated));
  if (!rig.open()) return name + " does not answer\n";
  rig.tick(600, {}, false);
  for (int ms = 0; ms < 400; ++ms) rig.tick(1, {0.002 * ms, -0.001 * ms, 0.0});
  rig.feels = false;
  rig.tick(15);
  rig.feels = true;
  rig.tick(100, {}, false);
  ForceRequest buzz;
  buzz.buzzes = 1;
  rig.link->wish(buzz);
  for (int ms = 0; ms < 12; ++ms) rig.link->pump(1e-3);
  rig.hand.reset();
  rig.link.reset();

  std::size_t count = 0;
  std::uint32_t check = 0;
  std::string shown;
  stand_in::Bytes before;
  std::size_t lines = 0;
  for (const auto& wire : rig.world.record) {
    if (!wire.out) continue;
    ++count;
    check = files::crc32(wire.bytes, check);
    if (wire.bytes == before || lines++ >= kShown) continue;
    before = wire.bytes;
    char text[16];
    std::snprintf(text, sizeof text, "  %5ld", wire.at);
    shown += text;
    // What is zero to the end is left out.
    std::size_t size = wire.bytes.size();
    while (size > 1 && wire.bytes[size - 1] == 0) --size;
    for (std::size_t n = 0; n < size; ++n) {
      std::snprintf(text, sizeof text, " %02x", wire.bytes[n]);
      shown += text;
    }
    shown += '\n';
  }
  char head[96];
  std::snprintf(head, sizeof head, "%s: %zu outputs, CRC-32 of all %08x\n", name.c_str(), count,
                check);
  return head + shown;
}

TEST(GoldenWire, EveryDeviceIsToldWhatItWasAlwaysTold) {
  const Vec3 home = default_def(DeviceKind::onggi_hid).home;
  std::string all;
  all += session("space_mouse", std::make_unique<stand_in::SimulatedPuck>(
                                    stand_in::SimulatedPuck::Reports::split, stand_in::Track()));
  all += session("surface_dial", std::make_unique<stand_in::SimulatedDial>(300));
  all +=
      session("dual_sense usb", std::make_unique<stand_in::SimulatedController>(false, 128, 128));
  all += session("dual_sense bluetooth",
                 std::make_unique<stand_in::SimulatedController>(true, 128, 128));
  std::vector<stand_in::TrackPoint> way(3000);
  for (std::size_t n = 0; n < way.size(); ++n)
    way[n] = {home + Vec3{2e-5 * static_cast<double>(n), 0.0, 0.0}, true};
  all += session("polhem", std::make_unique<stand_in::SimulatedArm>(stand_in::Track(way)));
  all += session("onggi_hid", std::make_unique<stand_in::SimulatedHandle>(still(home, 100000)));
  const std::string golden = files::test::content("tests/golden/device_bytes.txt");
  EXPECT_EQ(all, golden) << "If this is meant, write it there, and why in the commit.";
}

}  // namespace
}  // namespace onggi::device::golden_wire_test
