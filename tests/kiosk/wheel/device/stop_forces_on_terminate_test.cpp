#include "kiosk/wheel/device/stop_forces_on_terminate.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include "kiosk/wheel/device/codecs/onggi_hid.h"
#include "kiosk/wheel/device/hid_hand.h"
#include "tests/stand_in/simulated_handle.h"

namespace onggi::device::stop_forces_on_terminate_test {
namespace {

using stand_in::Bytes;
using stand_in::SimulatedHandle;

/// A device on a wire whose bytes out go into a pipe, which outlives the program.
class WirePort final : public HidPort {
 public:
  WirePort(std::unique_ptr<SimulatedHandle> handle, int wire)
      : handle_(std::move(handle)), wire_(wire) {}
  int read(std::span<std::uint8_t> out, int timeout_ms) noexcept override {
    if (timeout_ms == 0) return 0;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const auto report = handle_->tick();
    std::copy(report->begin(), report->end(), out.begin());
    return static_cast<int>(report->size());
  }
  bool write(Report report) noexcept override {
    handle_->take(Bytes(report.begin(), report.end()));
    return ::write(wire_, report.data(), report.size()) == static_cast<ssize_t>(report.size());
  }
  int feature(std::uint8_t id, std::span<std::uint8_t> out) noexcept override {
    const auto bytes = handle_->feature(id);
    std::copy(bytes->begin(), bytes->end(), out.begin());
    return static_cast<int>(bytes->size());
  }

 private:
  std::unique_ptr<SimulatedHandle> handle_;
  int wire_;
};

/// The program, as far as this asks: it pushes, and then throws what nobody catches.
[[noreturn]] void push_and_throw(int wire) {
  stop_forces_on_terminate();
  const Vec3 home = default_def(DeviceKind::onggi_hid).home;
  std::vector<stand_in::TrackPoint> held(100000, {home, true});
  auto handle = std::make_unique<SimulatedHandle>(stand_in::Track(held));
  LinkParts parts;
  parts.kind = DeviceKind::onggi_hid;
  parts.listing = handle->listing();
  parts.def = default_def(DeviceKind::onggi_hid);
  parts.port = std::make_unique<WirePort>(std::move(handle), wire);
  auto link =
      std::shared_ptr<HidLink>(HidLink::begin(std::move(parts), HidLink::Turning::by_thread));
  HidHand hand(link);
  // Until the device pushes, however late a busy machine's threads are.
  const auto pushes = [&] { return link->status().force.x > 0.35; };
  for (int ms = 0; ms < 1500 || (ms < 30000 && !pushes()); ++ms) {
    hand.read(1e-3);
    HandFeedback felt;
    felt.contact = true;
    if (ms > 300) felt.touch.push = {0.6, 0.0, 0.0};
    hand.feel(felt);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  std::thread([] { throw std::runtime_error("nobody catches this"); }).join();
  _exit(0);
}

TEST(LastWord, AnExceptionThatNobodyCatchesIsZeroForceOnTheWire) {
  int wire[2];
  ASSERT_EQ(pipe(wire), 0);
  const pid_t program = fork();
  if (program == 0) {
    close(wire[0]);
    close(2);  // what std::terminate has to say
    push_and_throw(wire[1]);
  }
  close(wire[1]);
  std::vector<std::vector<std::uint8_t>> outs;
  std::vector<std::uint8_t> report(onggi_hid::kOutputSize);
  for (std::size_t have = 0;;) {
    const ssize_t got = ::read(wire[0], report.data() + have, report.size() - have);
    if (got <= 0) break;
    have += static_cast<std::size_t>(got);
    if (have < report.size()) continue;
    outs.push_back(report);
    have = 0;
  }
  close(wire[0]);
  int status = 0;
  waitpid(program, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status)) << "it ended by the exception";
  ASSERT_GT(outs.size(), 100u);
  const auto force = [](const std::vector<std::uint8_t>& out) {
    return out[4] | out[5] << 8;  // mN along x
  };
  bool pushed = false;
  for (const auto& out : outs) pushed = pushed || (out[1] == 2 && force(out) > 300);
  EXPECT_TRUE(pushed);
  EXPECT_EQ(outs.back()[1], 0) << "the last word is off";
  EXPECT_EQ(force(outs.back()), 0);
}

}  // namespace
}  // namespace onggi::device::stop_forces_on_terminate_test
