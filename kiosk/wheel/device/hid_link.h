#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <string>
#include <thread>

#include "engine/force/overspeed.h"
#include "kiosk/wheel/device/driver.h"
#include "kiosk/wheel/device/force_gate.h"
#include "kiosk/wheel/device/mailbox.h"
#include "kiosk/wheel/device/presence.h"

namespace onggi::device {

/// The state of a link, for screens, lists and logs.
struct LinkStatus {
  DeviceSample sample;
  Vec3 force;                                       ///< As last written, N, the device's frame.
  std::array<std::uint64_t, kLinkFaults> faults{};  ///< By LinkFault.
  bool asks_to_be_held = false;  ///< A force device that nobody has held since it was plugged in.
};

struct LinkParts {
  std::unique_ptr<HidPort> port;
  DeviceKind kind = DeviceKind::space_mouse;
  HidListing listing;
  DeviceDef def;
};

/// Runs one device while it is plugged in: its own thread reads reports, keeps the newest, passes
/// the force request through the gate and writes. Or the caller turns it by hand, one tick at a
/// time, like loop::SteppedWheel. Made and destroyed on the main thread, with the device at rest.
/// Each call says which thread may use it.
class HidLink {
 public:
  enum class Turning : std::uint8_t { by_thread, by_hand };

  /// Does the handshake. Null if it is not the expected device or does not answer.
  static std::unique_ptr<HidLink> begin(LinkParts parts, Turning turning);
  ~HidLink();
  HidLink(const HidLink&) = delete;
  HidLink& operator=(const HidLink&) = delete;

  DeviceKind kind() const { return kind_; }
  const HidListing& listing() const { return listing_; }
  const DeviceDef& def() const { return def_; }
  const std::string& says() const { return says_; }
  /// Largest force, N: the setting, or the device's own limit if that is less.
  double cap() const { return limits_.cap; }

  /// Loop thread. newest(): gets the newest sample, if there is a new one. wish(): replaces the
  /// last request.
  bool newest(DeviceSample& sample) noexcept { return samples_.take(sample); }
  void wish(ForceRequest wish) noexcept;
  /// Loop thread, by hand only: `dt` seconds pass, and the device has a turn.
  void pump(double dt) noexcept;
  /// Any thread: turns of the link's thread so far. The count stops while a call to the device
  /// hangs.
  std::uint64_t turns() const noexcept { return turns_.load(std::memory_order_relaxed); }
  /// Any thread: the link's clock, ns.
  std::int64_t time_ns() const noexcept { return now_ns(); }
  bool by_hand() const noexcept { return turning_ == Turning::by_hand; }

  /// Main thread: tells that the screens are running. After the first call, call at least every
  /// half second.
  void heartbeat() noexcept { heartbeat_ns_.store(now_ns(), std::memory_order_relaxed); }
  /// Main thread.
  LinkStatus status() noexcept;

  static constexpr double kStall = 0.010;      ///< s without a report from a force device.
  static constexpr double kStuck = 0.010;      ///< s without a request from the loop.
  static constexpr double kFrozen = 0.5;       ///< s without a heartbeat.
  static constexpr double kStandstill = 0.05;  ///< s without a turn.
  static constexpr double kJump = 0.02;        ///< m between two reports.

 private:
  HidLink(LinkParts parts, Turning turning, std::unique_ptr<Driver> driver);
  void run();
  bool turn(int timeout_ms) noexcept;
  LinkFault listen(int timeout_ms) noexcept;
  LinkFault look_for_faults(std::int64_t now) const noexcept;
  void answer(LinkFault fault, std::int64_t now) noexcept;
  void publish(LinkFault fault) noexcept;
  std::int64_t now_ns() const noexcept;

  std::unique_ptr<HidPort> port_;
  std::unique_ptr<Driver> driver_;
  DeviceKind kind_;
  HidListing listing_;
  DeviceDef def_;
  Turning turning_;
  bool force_device_;
  std::string says_;
  ForceLimits limits_;

  // The link's thread only.
  DeviceSample sample_;
  ForceRequest wish_;
  ForceGate gate_;
  Presence presence_;
  force::Overspeed overspeed_;
  LinkStatus said_;
  std::int64_t turned_ns_ = 0, answered_ns_ = 0;
  bool news_ = false;
  bool held_once_ = false;  ///< Somebody has held it since it was plugged in.

  Mailbox<DeviceSample> samples_;
  Mailbox<ForceRequest> wishes_;
  Mailbox<LinkStatus> statuses_;
  LinkStatus seen_;  ///< Main thread only.
  std::atomic<std::int64_t> heartbeat_ns_{-1};
  std::atomic<std::int64_t> turned_time_ns_{0};  ///< The clock if it is turned by hand.
  std::atomic<std::uint64_t> turns_{0};
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace onggi::device
