#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "kiosk/wheel/device/hid_hand.h"
#include "tests/stand_in/simulated_handle.h"
#include "tests/stand_in/world.h"

namespace onggi::device {

/// A simulated device in a scripted world, its link turned by hand, and the loop's end of it.
class Rig {
 public:
  explicit Rig(std::unique_ptr<stand_in::SimulatedDevice> simulated,
               std::vector<stand_in::PlannedFault> faults = {}) {
    world.keeps = true;
    socket = &world.plug(std::move(simulated), std::move(faults));
  }
  /// Opens what is plugged in. False where it does not shake hands.
  bool open(const DeviceDef* def = nullptr) {
    const auto listed = world.list();
    if (listed.empty()) return false;
    const auto kind = kind_of(listed[0]);
    if (!kind) return false;
    auto bus = stand_in::bus_of(world);
    LinkParts parts{bus->open(listed[0].path), *kind, listed[0],
                    def != nullptr ? *def : default_def(*kind)};
    link = HidLink::begin(std::move(parts), HidLink::Turning::by_hand);
    hand = link ? std::make_unique<HidHand>(link) : nullptr;
    return hand != nullptr;
  }
  /// `ms` ticks in which the clay pushes with `force`; gives the last place read.
  HandInput tick(int ms = 1, Vec3 force = {}, bool contact = true) {
    HandInput in;
    for (int n = 0; n < ms; ++n) {
      if (beats) link->heartbeat();
      in = hand->read(1e-3);
      HandFeedback felt;
      felt.force = felt.touch.push = force;
      felt.contact = contact;
      if (feels) hand->feel(felt);
    }
    return in;
  }
  std::uint64_t faults(LinkFault which) {
    return link->status().faults[static_cast<std::size_t>(which)];
  }

  stand_in::World world;
  stand_in::Socket* socket = nullptr;
  std::shared_ptr<HidLink> link;
  std::unique_ptr<HidHand> hand;
  bool beats = true, feels = true;
};

/// A hand that holds still at `at` for `ms`, from the start on.
inline stand_in::Track still(Vec3 at, long ms) {
  return stand_in::Track(
      std::vector<stand_in::TrackPoint>(static_cast<std::size_t>(ms), {at, true}));
}

}  // namespace onggi::device
