#pragma once

#include <array>
#include <span>
#include <vector>

#include "engine/base/def_field.h"
#include "engine/clay/clay.h"
#include "engine/effects/laid_coil.h"
#include "engine/effects/row_stage.h"
#include "engine/math/vec.h"

namespace onggi {

/// A potter beats the wall between a paddle outside and an anvil inside (HandInput::paddle). The
/// wall between them gets thinner, wider and higher. Needs volume.
///
/// The defaults are those of a jar at a third of its size: 0.8 J on the jar itself, with a paddle
/// 12 cm wide, are 0.03 J and 4 cm here, because energy goes with the cube of the length.
struct BeatingDef {
  double energy = 0.03;  ///< J, 0.001..2: what a blow spends on the clay. For two bodies that stay
                         ///< together: m M / (m + M) v^2 / 2.
  double face = 0.02;    ///< m, 0.005..0.08: radius of the paddle's face.
  double yield_stress = 80e3;  ///< Pa, 5e3..1e6: stress along one direction at which dry clay
                               ///< yields. Water weakens it (MoistureDef::weakening). Clay that was
                               ///< left to stiffen a little; it is too wet to beat before.

  static constexpr const char* kName = "beating";
  static std::span<const DefField<BeatingDef>> fields();
};

namespace effects {

/// What a blow did.
struct Struck {
  double force = 0.0;  ///< N, the mean while the clay yields; 0: the blow missed.
  Vec3 out;            ///< Unit, level, clay frame: away from the wall, towards the paddle.
};

/// A blow ends within one to three ticks. So it is solved at once, as a balance of its energy and
/// the clay's plastic work: engine/docs/effects.md. Keeps nothing between ticks but what the last
/// one's blows did. Allocates only when made; one thread.
class Beating : public KeepsNoRows {
 public:
  static constexpr bool kAsksMoves = false;
  static bool wanted(const Effects& def);
  static Beating make(const Effects&, Clay& clay) { return Beating(clay); }
  explicit Beating(const Clay& clay);

  /// Stage 6.9: the blows of the tick. For each: at most kLooked elements about thirty times, all
  /// elements under the face once, and their whole rows five times, by vectors.
  void run(const StageWork& work) noexcept;
  /// What hand `n` struck in the last tick.
  const Struck& struck(std::size_t n) const { return struck_[n]; }

  /// The balance is struck over so many elements of the patch; of more, evenly every few.
  static constexpr std::size_t kLooked = 1024;
  /// An element under the face.
  struct Looked {
    float weight, round, up;   // 0..1, and its place on the face, -1..1
    float outer, inner, area;  // m, m, m^2 that it stands for
  };

 private:
  std::array<Struck, kMostHands> struck_{};
  std::vector<Looked> looked_;
  std::vector<float> under_;  // by row: how much of it lay under the last face
};

/// A ball of `radius` at `at` (clay frame, m) against the wall, which is firm for it, on its outer
/// face where it is nearer. Above the rim: rim_touched(). Radii between rows and rays are
/// interpolated; below the floor's top there is no wall. O(log rows).
Overlap wall_touched(const Clay& clay, Vec3 at, double radius) noexcept;

/// `at` (clay frame, m) is nearer to the wall's outer face than to its inner one, at its height.
bool outside_of_wall(const Clay& clay, Vec3 at) noexcept;

}  // namespace effects
}  // namespace onggi
