#include "kiosk/wheel/device/hid_link.h"

#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <utility>

#include "kiosk/ground/files/monotonic.h"
#include "kiosk/wheel/device/stop_forces_on_terminate.h"

namespace onggi::device {

namespace {

constexpr int kWaitMs = 2;
constexpr int kMostAtOnce = 64;  // reports: the size of the system's queue
// Just above the loop: the work is short, and the force depends on it
constexpr int kLinkPriority = 76;
constexpr std::int64_t kSayAgainNs = 10'000'000;

std::int64_t in_ns(double seconds) { return static_cast<std::int64_t>(seconds * 1e9); }

}  // namespace

std::unique_ptr<HidLink> HidLink::begin(LinkParts parts, Turning turning) {
  std::unique_ptr<Driver> driver = make_driver(parts.kind, parts.listing, parts.def);
  if (!parts.port || !driver || !driver->begin(*parts.port)) return nullptr;
  return std::unique_ptr<HidLink>(new HidLink(std::move(parts), turning, std::move(driver)));
}

HidLink::HidLink(LinkParts parts, Turning turning, std::unique_ptr<Driver> driver)
    : port_(std::move(parts.port)),
      driver_(std::move(driver)),
      kind_(parts.kind),
      listing_(std::move(parts.listing)),
      def_(parts.def),
      turning_(turning),
      force_device_(info_of(parts.kind).force),
      says_(driver_->says()),
      limits_{def_.cap(), def_.max_slew, def_.engage_time} {
  if (const auto own = driver_->greatest_force()) limits_.cap = std::min(limits_.cap, *own);
  turned_ns_ = answered_ns_ = now_ns();
  publish(LinkFault::none);
  if (turning_ == Turning::by_thread) thread_ = std::thread([this] { run(); });
}

HidLink::~HidLink() {
  stop_.store(true, std::memory_order_relaxed);
  if (thread_.joinable()) thread_.join();
  driver_->end(*port_);
}

std::int64_t HidLink::now_ns() const noexcept {
  return turning_ == Turning::by_thread ? files::monotonic_ns()
                                        : turned_time_ns_.load(std::memory_order_relaxed);
}

void HidLink::wish(ForceRequest wish) noexcept {
  wish.at_ns = now_ns();
  wishes_.put(wish);
}

void HidLink::pump(double dt) noexcept {
  turned_time_ns_.fetch_add(in_ns(dt), std::memory_order_relaxed);
  turn(0);
}

LinkStatus HidLink::status() noexcept {
  statuses_.take(seen_);
  return seen_;
}

void HidLink::run() {
  sched_param parameter{};
  parameter.sched_priority = kLinkPriority;
  // Without permission it runs as an ordinary thread; the loop's own line tells staff.
  pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameter);
  while (!stop_.load(std::memory_order_relaxed) && turn(kWaitMs)) {
  }
}

bool HidLink::turn(int timeout_ms) noexcept {
  if (sample_.lost) return false;
  LinkFault fault = listen(timeout_ms);
  const std::int64_t now = now_ns();
  if (sample_.lost) {
    gate_.cut();
    publish(fault);
    return false;
  }
  wishes_.take(wish_);
  if (!driver_->feels_hand() && sample_.has_place) {
    presence_.look(sample_.place, now);
    sample_.held = presence_.held();
  }
  held_once_ = held_once_ || sample_.held;
  if (fault == LinkFault::none) fault = look_for_faults(now);
  answer(fault, now);
  turned_ns_ = now;
  turns_.fetch_add(1, std::memory_order_relaxed);
  return !sample_.lost;
}

/// Reads all waiting reports, so that the newest wins.
LinkFault HidLink::listen(int timeout_ms) noexcept {
  std::array<std::uint8_t, 128> bytes{};
  LinkFault fault = LinkFault::none;
  news_ = false;
  int size = port_->read(bytes, timeout_ms);
  for (int n = 0; size > 0 && n < kMostAtOnce; ++n) {
    const auto length_of = std::min(static_cast<std::size_t>(size), bytes.size());
    const Vec3 before = sample_.place;
    switch (driver_->take(Report(bytes).first(length_of), sample_)) {
      case ReportResult::news:
        if (sample_.has_place && sample_.reports > 0 && length(sample_.place - before) > kJump)
          fault = LinkFault::jump;
        if (force_device_ && sample_.has_place && sample_.reports > 0 &&
            overspeed_.look(sample_.place, static_cast<double>(now_ns() - sample_.at_ns) * 1e-9))
          fault = fault == LinkFault::none ? LinkFault::too_fast : fault;
        ++sample_.reports;
        sample_.at_ns = now_ns();
        news_ = true;
        break;
      case ReportResult::broken:
        fault = LinkFault::bad_report;
        break;
      case ReportResult::nothing:
        break;
    }
    size = port_->read(bytes, 0);
  }
  if (size < 0) sample_.lost = true;
  return fault;
}

LinkFault HidLink::look_for_faults(std::int64_t now) const noexcept {
  if (now - turned_ns_ > in_ns(kStandstill)) return LinkFault::stood_still;
  const std::int64_t beat = heartbeat_ns_.load(std::memory_order_relaxed);
  if (beat >= 0 && now - beat > in_ns(kFrozen)) return LinkFault::frozen_main;
  if (wish_.ticks > 0 && now - wish_.at_ns > in_ns(kStuck)) return LinkFault::stuck_tick;
  if (!force_device_) return LinkFault::none;
  if (sample_.reports > 0 && now - sample_.at_ns > in_ns(kStall)) return LinkFault::stall;
  return driver_->deaf() ? LinkFault::deaf : LinkFault::none;
}

void HidLink::answer(LinkFault fault, std::int64_t now) noexcept {
  DriverOutput saying;
  saying.wish = wish_;
  saying.now_ns = now;
  saying.cap = limits_.cap;
  saying.damping = def_.damping;
  if (force_device_) {
    const bool ready = sample_.held && wish_.ticks > 0 && limits_.cap > 0.0 && !program_ends();
    const double seconds = static_cast<double>(now - turned_ns_) * 1e-9;
    if (ready && sample_.armed) {
      saying.force = whole_millinewtons(gate_.step(wish_.force, seconds, limits_, fault));
    } else {
      if (fault == LinkFault::none && !is_finite(wish_.force)) fault = LinkFault::not_a_number;
      gate_.cut();
    }
    saying.may_push = ready && fault == LinkFault::none;
  } else if (fault != LinkFault::none) {
    saying.wish.contact = false;  // do not vibrate for clay after a fault
    saying.wish.strength = 0.0;
  }
  said_.force = saying.may_push ? saying.force : Vec3{};
  // Send at most one output for each report, but send a stop at once.
  const bool speak = news_ || fault != LinkFault::none || now - answered_ns_ > kSayAgainNs;
  const Report report = speak ? driver_->say(saying) : Report{};
  if (speak) answered_ns_ = now;
  if (!report.empty() && !port_->write(report)) sample_.lost = true;
  publish(fault);
}

void HidLink::publish(LinkFault fault) noexcept {
  if (fault != LinkFault::none) ++said_.faults[static_cast<std::size_t>(fault)];
  if (sample_.lost) said_.force = {};
  said_.asks_to_be_held = force_device_ && !held_once_ && !sample_.lost;
  said_.sample = sample_;
  samples_.put(sample_);
  statuses_.put(said_);
}

}  // namespace onggi::device
