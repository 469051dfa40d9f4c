#include "kiosk/exhibit/composition/hand_devices.h"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "kiosk/wheel/loop/stepped_wheel.h"

namespace onggi::exhibit::hand_devices_test {
namespace {

/// A cable that can hang: whoever reads waits until it is let go.
struct Cable {
  std::mutex mutex;
  std::condition_variable moved;
  bool hangs = false;
  void hang(bool on) {
    const std::lock_guard lock(mutex);
    hangs = on;
    moved.notify_all();
  }
};

class HangingPort final : public device::HidPort {
 public:
  explicit HangingPort(Cable& cable) : cable_(cable) {}
  int read(std::span<std::uint8_t>, int timeout_ms) noexcept override {
    std::this_thread::sleep_for(std::chrono::milliseconds(timeout_ms));
    std::unique_lock lock(cable_.mutex);
    cable_.moved.wait(lock, [this] { return !cable_.hangs; });
    return 0;
  }
  bool write(device::Report) noexcept override { return true; }
  int feature(std::uint8_t, std::span<std::uint8_t>) noexcept override { return -1; }

 private:
  Cable& cable_;
};

/// Two pucks, each on its own cable.
class TwoPucks final : public device::HidBus {
 public:
  TwoPucks(Cable& first, Cable& second) : cables_{&first, &second} {}
  std::vector<device::HidListing> list() override {
    std::vector<device::HidListing> both(2);
    for (std::size_t n = 0; n < both.size(); ++n) {
      both[n].path = std::to_string(n);
      both[n].vendor = 0x256f;
      both[n].product = 0xc635;
      both[n].usage_page = 1;
      both[n].usage = 8;
    }
    return both;
  }
  std::unique_ptr<device::HidPort> open(const std::string& path) override {
    return std::make_unique<HangingPort>(*cables_.at(static_cast<std::size_t>(std::stoi(path))));
  }

 private:
  std::array<Cable*, 2> cables_;
};

/// Frames until `done` or for `seconds`.
template <class Done>
bool frames(HandDevices& devices, double& now, double seconds, Done done) {
  for (const double until = now + seconds; now < until; now += 0.01) {
    devices.frame(now);
    if (done()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

TEST(HandDevices, OneThreadThatHangsInItsCableIsSeenThoughTheOtherGoesOn) {
  Cable first, second;
  loop::SteppedWheel wheel_host;
  HandDevices devices(wheel_host, std::make_unique<TwoPucks>(first, second),
                      [](device::DeviceKind kind) { return device::default_def(kind); }, {});
  double now = 0;
  int came = 0;
  ASSERT_TRUE(frames(devices, now, 10, [&] {
    came += static_cast<int>(devices.remarks().size());
    return came == 2;
  }));
  auto before = devices.moves();
  EXPECT_TRUE(frames(devices, now, 5, [&] { return devices.moves() > before + 5; }));
  second.hang(true);
  frames(devices, now, 0.1, [] { return false; });
  before = devices.moves();
  frames(devices, now, 0.3, [] { return false; });
  EXPECT_EQ(devices.moves(), before) << "one of two stands";
  second.hang(false);
  EXPECT_TRUE(frames(devices, now, 5, [&] { return devices.moves() > before + 5; }));
}

TEST(HandDevices, WhereNothingIsPluggedInNothingCanHang) {
  loop::SteppedWheel wheel_host;
  class Nothing final : public device::HidBus {
    std::vector<device::HidListing> list() override { return {}; }
    std::unique_ptr<device::HidPort> open(const std::string&) override { return nullptr; }
  };
  HandDevices devices(wheel_host, std::make_unique<Nothing>(),
                      [](device::DeviceKind kind) { return device::default_def(kind); }, {});
  const auto before = devices.moves();
  devices.frame(0.1);
  devices.frame(0.2);
  EXPECT_EQ(devices.moves(), before + 2);
}

}  // namespace
}  // namespace onggi::exhibit::hand_devices_test
