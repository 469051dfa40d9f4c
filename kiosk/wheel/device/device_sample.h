#pragma once

#include <cstdint>

#include "engine/math/vec.h"

namespace onggi::device {

/// Buttons with the same meaning on all devices.
enum SampleButton : std::uint32_t {
  kClutch = 1u << 0,  ///< While held, the tool stays and the handle moves back.
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

/// The state of a device after its newest report, for the loop or the main thread.
struct DeviceSample {
  std::uint64_t reports = 0;  ///< Valid reports so far. 0: nothing below is known.
  std::int64_t at_ns = 0;     ///< Time of the newest, on the link's clock.
  bool lost = false;          ///< Unplugged, or no longer answering.
  bool has_place = false;
  Vec3 place;       ///< Position of its handle, metres, the device's own frame.
  Vec3 push;        ///< A puck's or sticks' deflection, -1..1: x right, y up, z to the visitor.
  Vec3 twist;       ///< The same for twist, right-handed about those axes.
  Vec3 turning;     ///< Speed at which the device itself turns, rad/s, about the same axes.
  double dial = 0;  ///< A dial's turn since it was plugged in, rad, clockwise.
  std::uint32_t buttons = 0;  ///< SampleButton.
  bool held = false;          ///< A person holds it.
  bool armed = false;         ///< A force device that is allowed to push.
};

/// The force that the loop wants a device to make.
struct ForceRequest {
  std::uint64_t ticks = 0;  ///< Requests so far. 0: none yet.
  std::int64_t at_ns = 0;   ///< Time, on the link's clock.
  Vec3 force;               ///< N, the device's own frame.
  double strength = 0;      ///< |force|, N, before the change to the device's frame.
  bool contact = false;
  std::uint32_t buzzes = 0;  ///< Counts a dial's short buzzes.
};

/// Faults between the clay's force and the cable; counted one by one.
enum class LinkFault : std::uint8_t {
  none,
  not_a_number,  ///< The wanted force is not a number.
  stuck_tick,    ///< The loop sent nothing new for a while.
  frozen_main,   ///< The screens sent no heartbeat for a while.
  stood_still,   ///< The whole program, or the machine, stopped for a while.
  stall,         ///< The device sent nothing new for a while.
  bad_report,    ///< It sent a short report, or one with a wrong checksum.
  jump,          ///< The handle jumped between two reports.
  deaf,          ///< The device does not answer.
  too_fast,      ///< The handle is too fast, for example after it was let go (force::Overspeed).
};
inline constexpr int kLinkFaults = 10;

}  // namespace onggi::device
