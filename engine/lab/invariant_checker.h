#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/scene/scene.h"

namespace onggi::lab {

/// What must hold after every tick, whatever was done to the clay.
enum class Invariant : std::uint8_t {
  finite,     ///< Every result of the tick, every radius and every height.
  range,      ///< radius_min <= inner, inner + wall_min <= outer <= radius_max;
              ///< solid floor rows.
  stacked,    ///< Rows stand on each other, each of some thickness; the floor's top is in place and
              ///< not above the rim.
  volume,     ///< With VolumeDef: the amount of clay, to a millionth; cutting tools take some.
  force,      ///< Within the guard's clamp and slew; the law itself gave a number.
  depth,      ///< A press is no deeper than the clay is large.
  marks,      ///< A changed row was marked for drawing.
  same_hash,  ///< The same hands leave the same bits, with other vectors too.
  mirror,     ///< A mirrored world has a mirrored pot.
};
inline constexpr int kInvariants = 9;
/// "finite", "range" ...
const char* name_of(Invariant invariant);

/// An invariant that did not hold.
struct Breach {
  Invariant invariant = Invariant::finite;
  std::uint64_t tick = 0;  ///< Ticks done, including this one.
  std::string what;        ///< A sentence, with the figures.
};

/// Checks a scene, tick by tick. It takes the scene's dirty and moved rows, so no one else may. A
/// tick costs the changed rows and a look at every row's height; every kWhole ticks all of the clay
/// is checked. Allocates when made, and for a Breach.
class InvariantChecker {
 public:
  static constexpr int kWhole = 512;

  explicit InvariantChecker(Scene& scene);

  /// Call after scene.step() of `dt` seconds, which returned `felt`.
  std::optional<Breach> after(Scene& scene, double dt, const Feedback& felt);
  /// Ticks were done without after(), and no hand is there: continues from the clay as it is.
  void resume(Scene& scene);
  /// Checks all of the clay now.
  std::optional<Breach> whole(Scene& scene);

  /// Checks row `j`, and how all rows stand on each other, of any clay of that many rows.
  std::optional<Breach> look_at_row(const Clay& clay, int j);
  std::optional<Breach> look_at_stack(const Clay& clay) const;

  /// Tolerance for rounding at largest radius `radius`, m: sixteen of a float's last digits.
  static double rounding(double radius);

 private:
  std::optional<Breach> breach(Invariant invariant, std::string what) const;
  std::optional<Breach> look_at_feedback(const Scene& scene, double dt, const Feedback& felt);
  std::optional<Breach> look_at_volume(const Scene& scene, double seconds);

  std::uint64_t tick_ = 0;
  double lump_ = 0.0;                   // m, m^3
  double rim_ = 0.0;                    // m, a tick ago
  std::vector<double> area_;            // of every row's section, m^2, as last seen
  std::vector<std::uint64_t> content_;  // its hash
  std::array<Vec3, kMaxHands> force_{};
  int off_ = 0;               // ticks,
  double off_seconds_ = 0.0;  // and seconds for which the volume has been wrong
  bool laying_ = false, pressed_ = false;
  bool cut_ = false;  // a cutting tool was there
};

}  // namespace onggi::lab
