#pragma once

#include <optional>
#include <vector>

#include "engine/clay/clay.h"
#include "engine/clay/clay_view.h"
#include "engine/effects/beating.h"
#include "engine/effects/building.h"
#include "engine/profile/profile.h"

namespace onggi::script {

/// How hard paddle and anvil come together: HandInput::swing and HandInput::anvil, 0..1.
struct Swings {
  double paddle = 1.0;
  double anvil = 1.0;
  friend bool operator==(const Swings&, const Swings&) = default;
};

/// How a vessel is built of coils. Every bit of clay has its place on the vessel: that with as much
/// of the wall's clay below it. Where the scene beats, rings are laid inside the vessel's line, as
/// far as blows will widen them, and are beaten out to it: clay that leaves from between paddle and
/// anvil goes round and up alike (BeatingDef). Rings lean only so far, so below a narrow mouth they
/// are laid still farther in, and the anvil drives the belly out. Without beating, rings follow the
/// line.
///
/// Lengths in metres, at the scene's scale; the clay's frame. Only the constructor allocates.
class RingPlan {
 public:
  /// `target`: at least its outer radii. `floor`: height of the floor on which the pot is built
  /// (scene::built_floor()).
  RingPlan(const Profile& target, double floor, const BuildingDef& law,
           const std::optional<BeatingDef>& beating);

  bool beats() const { return beating_.has_value(); }
  /// About as many rings as the vessel takes, and one to spare.
  int rings() const;
  /// The pot has less clay than its vessel takes, by most of a ring. O(rows), of a Clay O(rows x
  /// sectors); so is what follows.
  bool lacks_a_ring(const Clay& pot) const;
  bool lacks_a_ring(const ClayView& pot) const;
  /// Distance from the axis at which the middle of the next ring's coil belongs. It may be beside
  /// the rim: a ring leans only so far (Building::lay).
  double next_ring(const Clay& pot) const;
  double next_ring(const ClayView& pot) const;

  /// The next blow at `height`, so that the wall there gets thin and comes to the vessel's line: it
  /// is squeezed while it is too thick, and one of the two strikes harder where it would end beside
  /// the line. `angle`: of the blow in the clay's frame, rad; absent: the mean of the ring counts.
  /// `strength`: the wall's there, as a share of dry clay's (effects::strength()). Full swings
  /// without beats().
  Swings swings(const Clay& pot, double height, std::optional<double> angle,
                double strength = 1.0) const;
  Swings swings(const ClayView& pot, double height, std::optional<double> angle,
                double strength = 1.0) const;
  /// Where blows are needed most.
  struct Worst {
    double height = 0.0;  ///< m
    bool inward = false;  ///< The wall there stands out over the line.
  };
  /// The worst of the bands as high as a paddle's face; `last`'s, while no other is much worse.
  /// Only where beats() and the pot has a wall.
  std::optional<Worst> worst(const ClayView& pot, std::optional<double> last) const;
  /// All rings are laid, and the wall is still thick or off the line, on the mean of each height.
  /// False without beats().
  bool to_beat(const Clay& pot) const;
  bool to_beat(const ClayView& pot) const;
  /// Neither, and the pot is as high as its vessel.
  bool beaten(const ClayView& pot) const;

 private:
  struct Slice {
    double clay = 0.0;                           // m^3 of the wall up to its upper end
    double outer = 0.0, wall = 0.0, laid = 0.0;  // laid: middle of a ring before blows
  };
  Slice at_share(double share) const;
  Slice place_of(double below, double all) const;
  double ring_clay(double radius) const;
  template <class Pot>
  bool lacks(const Pot& pot, double has) const;
  template <class Pot>
  double next(const Pot& pot) const;
  template <class Pot>
  Swings strike(const Pot& pot, double height, std::optional<double> angle, double strength) const;
  template <class Pot>
  bool wants_blows(const Pot& pot) const;
  template <class Pot, class Visit>
  void each_row(const Pot& pot, Visit&& visit) const;

  BuildingDef law_;
  std::optional<BeatingDef> beating_;
  Profile target_;
  double floor_;                    // its height
  double ring_height_, ring_wall_;  // of a ring as laid
  double clay_ = 0.0;               // of the finished wall, m^3
  std::vector<Slice> slices_;       // even heights from the floor to the rim
};

}  // namespace onggi::script
