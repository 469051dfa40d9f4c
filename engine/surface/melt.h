#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/base/def_field.h"
#include "engine/surface/even_base.h"
#include "engine/surface/levelling.h"
#include "engine/surface/surface.h"

namespace onggi::surface {

/// How the glaze melts in the kiln.
struct MeltDef {
  double viscosity = 1000.0;  ///< Of the molten glaze, Pa s, 10..1e6.
  double tension = 0.35;      ///< Of its surface, N/m, 0.05..1.
  double seconds = 1800.0;    ///< As long as it is molten, s, 0..1e5.
  double shrinks = 0.5;       ///< Thickness after the fire over that of the raw coat, 0.1..1.
  /// The raw coat that the kiln gives to a pot on which no glaze was laid, m, 0..1e-3.
  double even = 0.0;

  static constexpr const char* kName = "melt";
  static std::span<const DefField<MeltDef>> fields();
};

/// The glaze of a fired pot. Surface tension levels the top of the melt, and viscosity holds it
/// back: by Orchard's law (1962) a wave of the height with the wave number k keeps
///
///   exp(-(k / kc)^4),   kc^-4 = seconds * tension * h^3 / (3 * viscosity)
///
/// of it, where h is the mean thickness of the melt. The body's own curvature is part of the
/// height, so glaze is thin on edges and thick in corners. What is thinner than the mean flows by
/// the third power of its own thickness, and never leaves a place bare. Bare places stay bare.
/// Three ways through each cell, round, along and twice across, each a sum over its neighbours,
/// make the law the same in every direction. No time steps. No glaze is lost: its volume is the raw
/// one's to the last unit. It lies on an EvenBase. Same bits on every machine. Holds 19 MB of a
/// tall pot while it works, 6 MB then. Allocates; not safe across threads.
class Melt {
 public:
  static constexpr int kUnit = 250;  ///< nm of raw glaze.

  /// Of `surface`, which must not change and must live until done(). Problem: a figure of `def` is
  /// out of its range.
  static Result<Melt> begin(const Surface& surface, const MeltDef& def);

  /// Goes on for about `cells` cells' time, a cell some 50 ns. True once all is done.
  bool go_on(std::int64_t cells);
  bool done() const { return stage_ == Stage::done; }
  /// False: there is no glaze, and nothing has melted.
  bool glazed() const { return glazed_cells_ > 0; }

  /// Once done(): the raw glaze that has become this cell's, kUnit a unit.
  int glaze(int j, int i) const { return melted_[cell(j, i)]; }
  /// Once done(): thickness after the fire, on an EvenBase, nm.
  int fired(int j, int i) const {
    return static_cast<int>(std::int64_t{glaze(j, i)} * kUnit * shrinks_ / 1000);
  }
  /// Of the raw glaze, with what rounding left over: Surface::glaze_volume(), if that is not 0.
  Volume volume() const;
  /// 1 / kc: the length by which it levels, m.
  double levels() const { return levels_; }

 private:
  enum class Stage { fill, round, along, across, back_across, count, lay, done };

  Melt(const Surface& surface, const MeltDef& def);
  static std::size_t cell(int j, int i) {
    return static_cast<std::size_t>(j) * kSectors + static_cast<std::size_t>(i);
  }
  int raw(int j, int i) const;
  float base(int i) const { return 1e-3f * static_cast<float>(base_[static_cast<std::size_t>(i)]); }
  void weigh_up();
  void next_stage();
  std::int64_t work(int n);
  void look_at_body();
  void fill_row(int j);
  void level_row(int j);
  void level_columns(int block, int way);
  int wanted(int j, int i) const;
  void lay_row(int j);

  const Surface* surface_;
  MeltDef def_;
  int shrinks_ = 0;    ///< Thousandths.
  int even_ = 0;       ///< Units of kGlazeUnit on each cell without resist; 0: as it was laid.
  float mean_ = 0.0f;  ///< Thickness, kUnit.
  double levels_ = 0.0;
  std::int64_t glazed_cells_ = 0;
  Volume glazed_area_ = 0;  ///< um^2.
  Volume volume_ = 0, lies_ = 0, rest_ = 0;
  double share_ = 0.0;  ///< Of what each place wants, so that all together is the volume.
  Volume laid_ = 0;
  Stage stage_ = Stage::fill;
  int next_ = 0;                       ///< Row or block of the stage.
  std::vector<float> height_;          ///< Of the melt's top, um.
  std::vector<std::uint16_t> melted_;  ///< kUnit; before that, whether there is glaze.
  std::vector<double> edges_;          ///< By row: what the body's curvature adds, um.
  std::vector<LevelKernel> round_, along_, across_;  ///< By row.
  std::vector<int> slant_;                           ///< By row: where a way across is, sectors.
  std::vector<float> room_;
  std::optional<EvenBase> even_base_;  ///< Until done(),
  std::span<const int> base_;          ///< and its row at work, nm.
};

}  // namespace onggi::surface
