#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/surface/layer.h"
#include "engine/surface/outline_rows.h"
#include "engine/surface/strata.h"

namespace onggi::surface {

/// Glaze is kept in whole units.
inline constexpr int kGlazeUnit = 4000;                           ///< nm.
inline constexpr int kMostGlaze = 255;                            ///< Units: 1.02 mm.
inline constexpr int kMostRelief = 30000, kLeastRelief = -30000;  ///< um.
inline constexpr int kMostBurnish = 3;                            ///< Passes of the stone.
inline constexpr int kMostSmoke = 255;
/// Of a wall's thickness may be cut away, percent.
inline constexpr int kMostCut = 40;

/// The surface of a leather-hard pot: what was cut into it and laid upon it, on the reference body
/// that it was born with. Row j is 0.25 mm of the outline (outline_rows.h), sector i spans the
/// angle [i, i + 1) * 2 pi / kSectors. From the body outwards: clay, three strata of slip, glaze.
/// Whole numbers throughout, so that the same strokes leave the same bits on every machine. Only
/// the laws write (laws.h). Allocates when a tile is touched; not safe across threads.
class Surface {
 public:
  /// A bare one. `name` goes into the Problem: see outline_of().
  static Result<Surface> create(const Profile& profile, const std::string& name);

  int rows() const { return static_cast<int>(outline_.size()); }
  const Row& row(int j) const { return outline_[static_cast<std::size_t>(j)]; }
  /// Height of the clay over the reference body, um.
  int relief(int j, int i) const { return relief_.at(j, i); }
  Strata slip(int j, int i) const { return Strata(slip_.at(j, i)); }
  /// Units of kGlazeUnit, 0..kMostGlaze.
  int glaze(int j, int i) const { return glaze_.at(j, i); }
  /// What lies here takes no slip and no glaze: wax, or a finger that holds the pot.
  bool resist(int j, int i) const { return (skin_.at(j, i) & kResist) != 0; }
  /// What stands here over the reference body is a coil, and no loose clay.
  bool coil(int j, int i) const { return (skin_.at(j, i) & kCoil) != 0; }
  /// Passes of the stone, 0..kMostBurnish.
  int burnish(int j, int i) const { return skin_.at(j, i) & kBurnish; }
  int smoke(int j, int i) const { return smoke_.at(j, i); }  ///< Carbon, 0..kMostSmoke.
  /// Height of everything over the reference body, nm.
  int top(int j, int i) const {
    return relief(j, i) * int{kNanometres} + slip(j, i).thickness() + glaze(j, i) * kGlazeUnit;
  }
  /// As deep as a tool may cut into row j, um below the reference body.
  int deepest(int j) const { return row(j).wall / 100 * kMostCut; }

  // For the laws. Values are clamped to what a cell can hold.
  void set_relief(int j, int i, int um);
  void set_slip(int j, int i, Strata slip) { slip_.set(j, i, slip.word()); }
  void set_glaze(int j, int i, int units);
  void set_resist(int j, int i, bool covered);
  void set_coil(int j, int i, bool laid);
  void set_burnish(int j, int i, int passes);
  void set_smoke(int j, int i, int carbon);
  /// What rounding has left over in row j, with its sign: of a pigment, of the glaze, of a cut's
  /// burr.
  static constexpr int kGlazeRest = kPigments, kBurrRest = kPigments + 1, kRests = kPigments + 2;
  Volume rest(int j, int kind) const { return rests_.at(j, kind); }
  void set_rest(int j, int kind, Volume volume) { rests_.set(j, kind, volume); }

  /// Begins a step of the undo, or goes on with the last one. The oldest are forgotten beyond
  /// kUndoBytes and kMostSteps.
  void begin_step(bool continues);
  /// Gives back memory that the step no longer needs. It looks at every tile of the step, so a step
  /// of many strokes does it once, before the next one begins.
  void end_step();
  bool can_undo() const { return steps_ > 0; }
  int steps() const { return steps_; }
  /// Takes the last step back, to the bit. Does nothing where there is none.
  void undo();
  static constexpr std::size_t kUndoBytes = 8u << 20;
  static constexpr int kMostSteps = 64;

  /// All slip of one pigment, and all glaze, with what rounding left over. O(cells).
  Volume slip_volume(int pigment) const;
  Volume glaze_volume() const;
  std::size_t bytes() const;       ///< Held by the layers and the outline.
  std::size_t undo_bytes() const;  ///< Held to take steps back.
  /// Of every cell and rest. Equal surfaces have equal hashes, whatever their undo. O(cells).
  std::uint64_t hash() const;

 private:
  static constexpr std::uint8_t kBurnish = 3, kResist = 4, kCoil = 8;
  template <class Cell>
  using Cells = Layer<Cell, 64, 60>;

  explicit Surface(std::vector<Row> outline);
  template <class Self, class Visit>
  static void each_layer(Self& self, Visit&& visit) {
    visit(self.relief_), visit(self.slip_), visit(self.glaze_);
    visit(self.skin_), visit(self.smoke_), visit(self.rests_);
  }

  std::vector<Row> outline_;
  Cells<std::int16_t> relief_;
  Cells<std::uint32_t> slip_;
  Cells<std::uint8_t> glaze_, skin_, smoke_;
  Layer<Volume, 16, kRests> rests_;
  int steps_ = 0;
};

}  // namespace onggi::surface
