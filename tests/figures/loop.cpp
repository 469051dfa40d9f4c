// The data of the closed loop's figure: how stiff a wall devices bear over their delay. The same
// bits on every machine.
// usage: onggi_figure_loop OUT.csv
#include <algorithm>
#include <cstdio>

#include "engine/lab/sampled_theory.h"
#include "engine/lab/stiffness_limit.h"

int main(int argc, char** argv) {
  namespace lab = onggi::lab;
  if (argc != 2) return 2;
  std::FILE* out = std::fopen(argv[1], "w");
  if (out == nullptr) return 1;
  std::fprintf(out, "# 45 g, no friction, an encoder of 0.055 mm; N/m, the least of three hands\n");
  std::fprintf(out, "damping,delay,passive,given,filtered,head\n");
  const double tick = lab::LoopPlan::kSeconds;
  for (const lab::DeviceModel& device : lab::device_list()) {
    if (device.friction > 0.0) continue;
    double filtered = lab::kStiffestCoupling;
    for (const lab::HandModel& hand : {lab::kFreeHand, lab::kLightHand, lab::kFirmHand})
      filtered = std::min(filtered, lab::theory::stiffest_stable(lab::SampledWall::filtered_spring,
                                                                 device, hand, tick));
    std::fprintf(out, "%.1f,%d,%.1f,%.1f,%.1f,501\n", device.damping, device.delay,
                 lab::theory::stiffest_passive(lab::SampledWall::spring, device, tick),
                 lab::derive_stiffness_limit(device).allowed, filtered);
  }
  return std::fclose(out) == 0 ? 0 : 1;
}
