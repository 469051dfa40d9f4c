#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/def_field.h"
#include "engine/clay/clay.h"
#include "engine/effects/laid_coil.h"
#include "engine/effects/row_stage.h"
#include "engine/math/hash.h"
#include "engine/math/vec.h"

namespace onggi {

/// A pot is built of coils: a hand that holds one (HandInput::coil) lays it on the rim as the rim
/// passes. Once a ring is closed it becomes clay: new rows, counted by the coil's section and
/// length. The joint below it is weak until hands have worked it on both sides. Needs volume.
struct BuildingDef {
  double coil = 0.013;   ///< Diameter of the coil, m, 0.008..0.03.
  double tallest = 0.3;  ///< m, 0.05..1: no ring is begun that would end higher. Decides the
                         ///< memory: rows for so much height.
  double pace = 0.5;     ///< m/s, 0.02..5: a rim that passes faster takes no coil.
  double drift = 0.05;  ///< 0..0.25: by so many coils a ring comes to lie farther out than the hand
                        ///< lays it, as straight coils do.
  double joint = 0.3;   ///< 0.05..1: strength of a joint as laid, as a share of the wall's.
  double pinched = 0.8;  ///< 0..1: 0: pinching does not help; 1: a well pinched joint is as strong
                         ///< as the wall.
  double wetness = 0.1;  ///< Of the coil, 0..1 (MoistureDef). Wet coils slump.

  static constexpr const char* kName = "building";
  static std::span<const DefField<BuildingDef>> fields();
};

namespace effects {

/// Lays coils, and keeps how well each joint was worked. Allocates only when made; one thread.
class Building {
 public:
  Building(const BuildingDef& def, const Clay& clay);

  static constexpr bool kAsksMoves = true;
  static bool wanted(const Effects& def);
  static Building make(const Effects& def, Clay& clay);
  /// Rows that a scene keeps for it, in addition to the lump's.
  static int spare_rows(const BuildingDef& def, const ClayDef& clay);
  /// Height of a ring in its rows, m: its section, flattened where it meets others.
  static double ring_height(const BuildingDef& def, const ClayDef& clay);

  /// A hand with a coil goes from `from` to `to` in `seconds` (> 0): its coil's middle, clay frame,
  /// m. Where the coil rests on the rim, it is laid on every sector passed that is still free. A
  /// gap narrower than the coil closes: a rim with a notch would keep a ring open for ever. `step`:
  /// clay::History::depth(). Returns whether the coil rests on the rim. A ring for which there is
  /// no room is not begun: below BuildingDef::tallest, in the rows, within radius_max. O(sectors
  /// passed), and O(sectors) where something was laid.
  bool lay(const BuildingDef& def, Clay& clay, Vec3 from, Vec3 to, double seconds,
           std::uint64_t step) noexcept;
  const LaidCoil& laid() const { return laid_; }
  /// Height of the laid coil's middle, m.
  double laid_height(const BuildingDef& def, const Clay& clay) const {
    return clay.rim_height() + 0.5 * def.coil;
  }

  /// A closed ring waits to become rows.
  bool rises() const { return laid_.closed(); }
  /// Spare rows that the ring under way will take.
  int rows_kept() const { return laid_.any() ? slices_ - laid_.raised() : 0; }
  /// Adds the ring's next row at the top: a slice of the coil's section, with its share of the
  /// coil's clay. The caller keeps history, tells the other stages, and restacks. O(sectors).
  RowAdded raise(const BuildingDef& def, Clay& clay, std::uint64_t step) noexcept;

  /// Stage 6.8: how far this tick's moves worked the joints.
  void run(const StageWork& work) noexcept;
  /// A blow between paddle and anvil made a stored row thinner: its ring's mean of ln(before /
  /// after). What is beaten is one piece of clay.
  void beat(int stored, double thinner) noexcept;
  /// Yield strength of a stored row (Clay::stored), as a share of the wall's: 1 but near a joint.
  double strength(const BuildingDef& def, int stored) const noexcept;
  /// A joint keeps its row.
  bool loaded(int stored) const { return of(stored).joint; }
  /// Mean of outer^2 + inner^2 of a stored row as it was laid, m^2; 0 if it is of the lump.
  double laid_square(int stored) const { return of(stored).square; }

  void row_added(const Clay&, const RowAdded&) noexcept {}
  void row_divided(const Clay&, const RowDivided& divided) noexcept;
  void rows_joined(const Clay&, const RowsJoined&) noexcept {}  // joints are never joined
  void forget(Clay& clay, const Laid& laid) noexcept;
  void add_to(StateHash& hash, const Clay& clay) const;

 private:
  struct Ring {  // by stored row; of the lump: nothing
    bool joint = false;
    double square = 0.0;            // m^2, as laid
    std::array<float, 2> worked{};  // m, mean over the ring: outside, inside
    float beaten = 0.0f;            // thinned by blows: ln(before / after)
  };
  const Ring& of(int stored) const { return rings_[static_cast<std::size_t>(stored)]; }
  bool has_room(const BuildingDef& def, const Clay& clay) const noexcept;
  double centre_under(const BuildingDef& def, const Clay& clay, int sector, Vec3 at) const noexcept;

  LaidCoil laid_;
  std::vector<Ring> rings_;
  int slices_;     // rows of a ring
  double height_;  // m, of a ring
  double widths_;  // m, of its rows together
};

}  // namespace effects
}  // namespace onggi
