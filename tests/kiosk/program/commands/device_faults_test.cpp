#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "kiosk/wheel/device/reference/onggi_hid_device.h"
#include "tests/kiosk/program/commands/program.h"

// The real program, with its 1 kHz thread and a device's own, in real time: stopped and killed
// while a hand at the reference device feels clay. What went over the wire is looked at afterwards.

namespace onggi::commands::device_faults_test {
namespace {

using namespace std::chrono_literals;

struct Wire {
  long ms = 0;
  bool out = false;
  std::vector<std::uint8_t> bytes;

  int mode() const { return bytes[1]; }
  double force() const {
    double square = 0.0;
    for (std::size_t n = 0; n < 3; ++n) {
      const auto f = static_cast<std::int16_t>(bytes[4 + 2 * n] | bytes[5 + 2 * n] << 8);
      square += 1e-6 * f * f;
    }
    return std::sqrt(square);
  }
};

/// What was recorded so far; a last line that is not whole is left.
std::vector<Wire> recorded(const std::filesystem::path& file) {
  std::vector<Wire> all;
  std::istringstream in(content(file));
  for (std::string line; std::getline(in, line) && !in.eof();) {
    std::istringstream words(line);
    std::string path, way, byte;
    Wire wire;
    words >> path >> wire.ms >> way;
    wire.out = way == "out";
    while (words >> byte)
      wire.bytes.push_back(static_cast<std::uint8_t>(std::stoi(byte, nullptr, 16)));
    all.push_back(wire);
  }
  return all;
}

/// In and out at the wall of the lump, for four minutes: 1.5 mm deep, and clear of it again.
void write_track(const std::filesystem::path& file) {
  std::ofstream out(file);
  for (int ms = 0; ms < 240000; ++ms) {
    const double r = 0.0655 - 0.004 * (1.0 - std::cos(ms * 2e-3 * 3.14159265));
    out << r << " 0.08 0 1\n";
  }
}

/// `onggi soak` in the background, with the reference device plugged in.
class Soak {
 public:
  explicit Soak(const ScratchFolder& folder) : record_(folder / "record") {
    const std::string track = (folder / "track").string();
    write_track(track);
    const std::string scenario = (folder / "scenario").string();
    std::ofstream(scenario) << "clock real\nrecord " << record_.string()
                            << "\ndevice onggi_hid track " << track << " 0\n";
    const std::string out = (folder / "out").string(), log = (folder / "log").string();
    pid_ = fork();
    if (pid_ == 0) {
      setenv("LD_PRELOAD", ONGGI_HID_STAND_IN, 1);
      setenv("ONGGI_STAND_IN", scenario.c_str(), 1);
      unsetenv("DISPLAY");
      unsetenv("WAYLAND_DISPLAY");
      const int to = open(log.c_str(), O_WRONLY | O_CREAT, 0644);
      dup2(to, 1);
      dup2(to, 2);
      execl(ONGGI_PROGRAM, ONGGI_PROGRAM, "soak", "--by-device", "--minutes", "3", "--window",
            "320x240", "--out", out.c_str(), static_cast<char*>(nullptr));
      _exit(127);
    }
  }
  ~Soak() { end(SIGKILL); }
  void signal(int which) const { kill(pid_, which); }
  void end(int with) {
    if (pid_ <= 0) return;
    kill(pid_, with);
    waitpid(pid_, nullptr, 0);
    pid_ = -1;
  }
  std::vector<Wire> wire() const { return recorded(record_); }
  /// Waits until it has pushed with more than `newtons` after millisecond `after`.
  bool pushes(double newtons, long after) const {
    for (int n = 0; n < 600; ++n) {
      for (const Wire& w : wire())
        if (w.out && w.ms > after && w.mode() == 2 && w.force() > newtons) return true;
      std::this_thread::sleep_for(100ms);
    }
    return false;
  }

 private:
  std::filesystem::path record_;
  pid_t pid_ = -1;
};

TEST(DeviceFaults, StoppedAndThenKilledTheForceEndsByItselfAndComesBackFromNothing) {
  const ScratchFolder folder;
  Soak soak(folder);
  ASSERT_TRUE(soak.pushes(0.15, 0)) << content(folder / "log");

  soak.signal(SIGSTOP);
  std::this_thread::sleep_for(300ms);
  const auto before = soak.wire();
  const long stopped = before.back().ms;
  soak.signal(SIGCONT);
  ASSERT_TRUE(soak.pushes(0.15, stopped + 200)) << content(folder / "log");
  // The first word after the pause is off, and then it is armed anew, from nothing.
  const auto after = soak.wire();
  const auto first = std::find_if(after.begin(), after.end(),
                                  [&](const Wire& w) { return w.out && w.ms > stopped + 200; });
  ASSERT_NE(first, after.end());
  EXPECT_EQ(first->mode(), 0);
  double strongest = 0.0;
  const Wire* last = nullptr;
  for (const Wire& w : after) {
    if (!w.out || w.mode() != 2) {
      if (w.out) last = nullptr;
      continue;
    }
    strongest = std::max(strongest, w.force());
    if (last == nullptr) {
      EXPECT_LT(w.force(), 0.01) << "at " << w.ms;
    }
    last = &w;
  }
  EXPECT_LE(strongest, 3.3) << "the device's file allows no more";

  // kill -9, and what was on the wire goes into a device as a maker builds it: then nothing more.
  soak.end(SIGKILL);
  const onggi_hid_build build{5000, 20, {-1000, -1000, -1000}, {1000, 1000, 1000}, 1, 1, 1};
  onggi_hid_device device;
  onggi_hid_start(&device, &build);
  const std::int32_t place[3] = {0, 0, 0};
  std::int32_t f[3];
  const auto all = soak.wire();
  long ms = 0;
  bool pushed = false;
  for (const Wire& w : all) {
    for (; ms < w.ms; ++ms) onggi_hid_tick(&device, 1000, place, 1, 1, 0);
    if (!w.out) continue;
    onggi_hid_take(&device, w.bytes.data(), w.bytes.size());
    onggi_hid_force(&device, f);
    pushed = pushed || f[0] != 0;
  }
  EXPECT_TRUE(pushed);
  for (int n = 0; n < 41; ++n) onggi_hid_tick(&device, 1000, place, 1, 1, 0);
  onggi_hid_force(&device, f);
  EXPECT_EQ(std::abs(f[0]) + std::abs(f[1]) + std::abs(f[2]), 0);
}

}  // namespace
}  // namespace onggi::commands::device_faults_test
