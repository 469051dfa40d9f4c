#pragma once

#include <array>
#include <cstddef>

#include "engine/math/vec.h"

namespace onggi::lab {

/// A force device, as far as its control loop needs it. SI.
struct DeviceModel {
  double mass = 0.045;     ///< Of the handle as it is felt, kg, > 0.
  double damping = 0.5;    ///< N s/m, >= 0.
  double friction = 0.0;   ///< Coulomb's, N, >= 0.
  double step = 0.000055;  ///< Encoder resolution, m; 0: exact.
  int delay = 0;           ///< Ticks until a force is felt, 0..kMostDelay.

  static constexpr int kMostDelay = 8;
};

/// A hand at the device: spring and damper about the place it wants.
struct HandModel {
  double stiffness = 0.0;  ///< N/m, >= 0.
  double damping = 0.0;    ///< N s/m, >= 0.
  double mass = 0.0;       ///< Mass that moves along, kg, >= 0.
};
/// No hand, two fingers, a fist. After Hajian & Howe 1997 (0.1..0.2 kg are whole fingers; a light
/// touch carries little of them) and Kuchenbecker, Park & Niemeyer 2003.
inline constexpr HandModel kFreeHand{}, kLightHand{60.0, 1.5, 0.02}, kFirmHand{600.0, 6.0, 0.10};

/// A handle in a hand, between the ticks of a loop: M x'' = F + push - k (x - rest) - B x' -
/// friction. The force is held from tick to tick and late by the device's delay. Leapfrog of kParts
/// parts a tick, damping exact, friction implicit: second order, and no energy is created. No
/// allocation; the same bits everywhere.
class Handle {
 public:
  static constexpr int kParts = 20;

  Handle(const DeviceModel& device, const HandModel& hand, Vec3 at, double seconds);
  /// The place that the device reports, in whole steps, m.
  Vec3 told() const;
  /// One tick of the length given at construction. `force` (N) goes to the device, `push` (N) is
  /// the hand's own, `rest` (m) is where the hand wants to be.
  void go(Vec3 force, Vec3 push, Vec3 rest);
  /// One tick in which the handle is led to `to`, m.
  void lead(Vec3 force, Vec3 to);
  void kick(Vec3 speed) { speed_ = speed; }
  Vec3 at() const { return at_; }
  Vec3 speed() const { return speed_; }
  /// Work of the device's force on the handle, and work lost to its damping and friction, J.
  double work() const { return work_; }
  double lost() const { return lost_; }

 private:
  Vec3 held(Vec3 force);

  DeviceModel device_;
  HandModel hand_;
  double part_ = 0.0, decay_ = 1.0;  // s of a part; factor by which damping reduces speed in it
  Vec3 at_, speed_;
  std::array<Vec3, DeviceModel::kMostDelay + 1> wire_{};
  std::size_t newest_ = 0;
  double work_ = 0.0, lost_ = 0.0;
};

}  // namespace onggi::lab
