#pragma once

#include <cstdint>

#include "engine/math/vec.h"

namespace onggi::device {

/// Of a device's buttons, those that mean the same on all of them.
enum SampleButton : std::uint32_t {
  kClutch = 1u << 0,  ///< Held: the tool stays while the handle is moved back.
  kSide = 1u << 1,
  kWater = 1u << 2,
  kFaster = 1u << 3,
  kSlower = 1u << 4,
  kEnter = 1u << 5,
  kGoBack = 1u << 6,
  kLeft = 1u << 7,
  kRight = 1u << 8,
  kUp = 1u << 9,
  kDown = 1u << 10,
};

/// A device as its newest report leaves it: what its thread tells the loop, or the main thread.
struct DeviceSample {
  std::uint64_t reports = 0;  ///< Good ones so far. 0: nothing below is known.
  std::int64_t at_ns = 0;     ///< When the newest came, on the link's clock.
  bool lost = false;          ///< Unplugged, or not to be talked to any more.
  bool has_place = false;
  Vec3 place;       ///< Of its handle, metres, the device's own frame.
  Vec3 push;        ///< A puck's or sticks' deflection, -1..1: x right, y up, z to the visitor.
  Vec3 twist;       ///< The same of turning, right-handed about those axes.
  Vec3 turning;     ///< How fast the device itself is being turned, rad/s, about the same axes.
  double dial = 0;  ///< A dial's turn since it was plugged in, rad, clockwise.
  std::uint32_t buttons = 0;  ///< SampleButton.
  bool held = false;          ///< A person is at it.
  bool armed = false;         ///< A force device that may push.
};

/// What the loop would have a device's hand feel.
struct FeelWish {
  std::uint64_t ticks = 0;  ///< Wishes so far. 0: none yet.
  std::int64_t at_ns = 0;   ///< When, on the link's clock.
  Vec3 force;               ///< N, the device's own frame.
  double strength = 0;      ///< |force|, N, before it was turned into the device's frame.
  bool contact = false;
  std::uint32_t buzzes = 0;  ///< Of a dial: counts, each new one is a short buzz.
};

/// What was wrong between the clay's force and the wire; counted one by one.
enum class LinkFault : std::uint8_t {
  none,
  not_a_number,  ///< The force wanted was none.
  stuck_tick,    ///< The loop said nothing new for a while.
  frozen_main,   ///< The screens did not move for a while.
  stood_still,   ///< The whole program, or the machine, did.
  stall,         ///< The device said nothing new for a while.
  bad_report,    ///< It sent a short report, or one with a wrong check.
  jump,          ///< The handle was elsewhere at once.
  deaf,          ///< The device does not answer to what it is sent.
  too_fast,      ///< The handle runs away, or was let go of (force::Overspeed).
};
inline constexpr int kLinkFaults = 10;

}  // namespace onggi::device
