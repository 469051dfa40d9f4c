#pragma once

#include <array>
#include <cstddef>

#include "engine/math/vec.h"

namespace onggi::lab {

/// A force device, as far as its loop asks. SI.
struct DeviceModel {
  double mass = 0.045;     ///< Of the handle as it is felt, kg, > 0.
  double damping = 0.5;    ///< N s/m, >= 0.
  double friction = 0.0;   ///< Coulomb's, N, >= 0.
  double step = 0.000055;  ///< What an encoder tells apart, m; 0: everything.
  int delay = 0;           ///< Ticks until a force is felt, 0..kMostDelay.

  static constexpr int kMostDelay = 8;
};

/// A hand at it: a spring and damper about where it would be.
struct HandModel {
  double stiffness = 0.0;  ///< N/m, >= 0.
  double damping = 0.0;    ///< N s/m, >= 0.
  double mass = 0.0;       ///< That goes along, kg, >= 0.
};
/// Nobody; two fingers; a fist. After Hajian & Howe 1997 (fingers: 0.1..0.2 kg are those of whole
/// fingers, of which a light touch carries little) and Kuchenbecker, Park & Niemeyer 2003.
inline constexpr HandModel kFreeHand{}, kLightHand{60.0, 1.5, 0.02}, kFirmHand{600.0, 6.0, 0.10};

/// A handle in a hand, between the ticks of a loop: M x'' = F + push - k (x - rest) - B x' -
/// friction, the force held from tick to tick and late by the device's delay. Leapfrog of kParts
/// parts a tick, damping exact, friction implicit: second order, no energy from nowhere. No
/// allocation; the same bits everywhere.
class Handle {
 public:
  static constexpr int kParts = 20;

  Handle(const DeviceModel& device, const HandModel& hand, Vec3 at, double seconds);
  /// What the device says: the place, in whole steps.
  Vec3 told() const;
  /// A tick of `seconds`, as given when it was made: `force` (N) goes into the wire; `push` (N) is
  /// the hand's own, and `rest` (m) where it would be.
  void go(Vec3 force, Vec3 push, Vec3 rest);
  /// A tick in which it is led to `to`, m.
  void lead(Vec3 force, Vec3 to);
  void kick(Vec3 speed) { speed_ = speed; }
  Vec3 at() const { return at_; }
  Vec3 speed() const { return speed_; }
  /// J that the device's force did on it, and that its own damping and friction took.
  double work() const { return work_; }
  double lost() const { return lost_; }

 private:
  Vec3 held(Vec3 force);

  DeviceModel device_;
  HandModel hand_;
  double part_ = 0.0, decay_ = 1.0;  // s; of a speed by damping in one
  Vec3 at_, speed_;
  std::array<Vec3, DeviceModel::kMostDelay + 1> wire_{};
  std::size_t newest_ = 0;
  double work_ = 0.0, lost_ = 0.0;
};

}  // namespace onggi::lab
