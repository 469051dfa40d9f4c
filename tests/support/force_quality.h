#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/scene/scene.h"

namespace onggi::test {

/// What a force is like to a hand that is pushed slowly into a turning pot.
struct ForceQuality {
  double mean = 0.0;       ///< N
  double increment = 0.0;  ///< Root mean square of its change from tick to tick, N.
  double own = 0.0;        ///< Of that, what a hand to and fro makes of any force: the same of its
                           ///< mean over 20 ms to both sides (by Hann's weights). No smoothing and
                           ///< no grid has less.
  double above_50 = 0.0;   ///< Of what it does above 50 Hz, root mean square, N.
  double lag = 0.0;        ///< s behind the same force without what makes it late, of what is
                           ///< slower than about 25 Hz; below 0: ahead of it.
};

/// 60 rpm; 5 mm/s, to and fro by 0.3 mm three times a second, for 1.6 s after the first touch.
struct SlowPush {
  std::uint8_t tool = 0;   ///< HandInput::tool
  double seconds = 0.001;  ///< Of a tick.
  double coupling = 0.0;   ///< N/m between hand and tool; 0: none, the scene's own force.
  bool wet = false;        ///< A sponge was held to the clay for a second before.
  bool spring = false;     ///< What the coupling's spring holds, not what is felt of it.
};
/// Force on the tool, N, a value a millisecond: what a hand would feel of `scene` without its
/// guard's ramp. Empty where the scene is none. Allocates.
std::vector<Vec3> push_slowly(const SceneDef& scene, const SlowPush& push);

/// Of a force of a value a millisecond; `sooner` is the one it lags behind, as many values.
ForceQuality quality_of(std::span<const Vec3> force, std::span<const Vec3> sooner);
/// `force` behind the paper's filter.
std::vector<Vec3> filtered(std::span<const Vec3> force);

/// Of what a scene gives; its lag is behind itself at ticks of a sixteenth of a millisecond, and at
/// a hand behind what the coupling's spring holds then: nothing that is felt late is in that. Its
/// tool may not be a wire, which presses nothing.
ForceQuality scenes_quality(const SceneDef& scene, std::uint8_t tool, double coupling = 0.0);
/// Of the printed model at its own grid on a scene's clay (how stiff, how soon it gives way, how
/// far off the middle) with the scene's ball: as it comes, and behind its filter.
struct PrintedQuality {
  ForceQuality raw, filtered;
};
PrintedQuality printed_quality(const SceneDef& scene);

}  // namespace onggi::test
