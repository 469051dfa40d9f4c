#pragma once

#include "engine/lab/handle.h"

namespace onggi::lab {

/// Walls that have a closed form.
enum class SampledWall {
  spring,           ///< H = K
  maxwell,          ///< H = K (z - 1) / (z - e^(-T / tau)): clay that gives way
  filtered_spring,  ///< H = K B(z), B the paper's Butterworth of 10 Hz
};

/// Closed forms and eigenvalues for loops of a handle and a wall that is sampled every `seconds`
/// and held, without friction and encoder. Independent of the simulation, which is checked against
/// them. Allocates nothing.
namespace theory {

inline constexpr double kRelaxation = 0.00949;  ///< tau of `maxwell`, s: clay as it ships.

/// Colgate & Brown 1994, with a delay: a loop is passive if b > (T / 2) Re{(1 - e^-jwT) H} / (1 -
/// cos wT) for all w up to half the rate. Returns the damping (N s/m) that a wall of 1 N/m needs.
double passive_damping(SampledWall wall, int delay, double seconds);
/// The stiffest wall that is passive on `device`, N/m.
double stiffest_passive(SampledWall wall, const DeviceModel& device, double seconds);
/// The stiffest wall (two-sided) that is stable on `device` in `hand`, N/m: where the spectral
/// radius of the sampled system passes 1. 0 if no wall is stable, 1e6 if all are.
double stiffest_stable(SampledWall wall, const DeviceModel& device, const HandModel& hand,
                       double seconds);
/// Spectral radius of that system with a wall of `stiffness` N/m.
double spectral_radius(SampledWall wall, double stiffness, const DeviceModel& device,
                       const HandModel& hand, double seconds);

}  // namespace theory
}  // namespace onggi::lab
