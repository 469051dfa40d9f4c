#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "engine/base/def_field.h"
#include "engine/clay/clay.h"
#include "engine/clay/wall_side.h"
#include "engine/effects/row_stage.h"
#include "engine/math/hash.h"

namespace onggi {

/// What a paddle's face and an anvil's leave in the clay that they strike. No clay moves by it: it
/// is kept where blows fell and hands smoothed, for whoever draws the pot. Needs beating.
///
/// The defaults are those of a jar at half its size: cords of 2 to 4 mm are usual on real pots.
struct PrintsDef {
  enum Face { plain, cord, grid };

  int paddle = plain;    ///< Of Face, 0..2: plain wood, wound with cord, cut with a grid.
  double pitch = 0.003;  ///< m, 0.0005..0.01: from cord to cord, or from bar to bar.
  double rings = 0.004;  ///< m, 0..0.02: from ring to ring on the anvil. 0: the anvil is smooth.
  double depth = 4e-4;   ///< m, 5e-5..0.002: how deep the print of a whole blow is.

  static constexpr const char* kName = "prints";
  static std::span<const DefField<PrintsDef, int>> counts();
  static std::span<const DefField<PrintsDef>> fields();
};

/// The names of PrintsDef::Face, in its order, for a scene's and a vessel's `paddle` key.
std::span<const std::string_view> paddle_faces();
/// The Face of that name; nothing for other words.
std::optional<int> find_paddle_face(std::string_view name);

/// A place of the wall that was struck or smoothed, on the pot as it stands. Clay frame.
struct Print {
  enum Kind : std::uint8_t { paddle, anvil, smoothed };

  Kind kind = paddle;
  WallSide side = WallSide::outside;
  double low = 0.0, high = 0.0;  ///< m: heights between which it lies,
  double from = -1.0, to = 1.0;  ///< and what of the face they are: -1 its lower end, 1 its upper.
  double angle = 0.0, half = 0.0;  ///< rad: its middle, and half its width, at most pi.
  double wide = 0.0, tall = 0.0;   ///< m: half the face round the pot and upwards, as it struck.
  double deep = 0.0;  ///< m: how far it went into the clay where that is nearest to the middle of
                      ///< the face.
  bool left = false;  ///< It was struck to the left of the axis, as the visitor sees the wheel.
};

namespace effects {

/// Keeps the blows and the smoothing of a pot, in their order. A place is told by the clay below
/// it, which no blow, no hand and no row that divides changes. What a tool cuts off below it is
/// taken off that. Keeps the last kMost, of which at most kMostSmoothed are smoothed. Undo brings
/// back what cuts changed, as far as kMostCut places of the last strokes go. Allocates when made,
/// and in seen().
class Prints {
 public:
  static constexpr std::size_t kMost = 2048;
  static constexpr std::size_t kMostSmoothed = kMost / 2;
  static constexpr std::size_t kMostCut = 4 * kMost;
  static constexpr bool kAsksMoves = false;
  static bool wanted(const Effects& def);
  static Prints make(const Effects&, Clay& clay) { return Prints(clay.room()); }
  /// For a clay of at most `rows` rows.
  explicit Prints(int rows) : marks_(kMost), cut_(static_cast<std::size_t>(rows)), was_(kMostCut) {}

  /// Stage 6.7: a tool cut `gone` m^3 off row `j`.
  void note_cut(int j, double gone) noexcept;
  /// Takes what note_cut() was told off the clay below the prints. work.volume is without it.
  /// Nothing without a cut; else O(rows + prints x log(rows cut)).
  void lower(const StageWork& work) noexcept;

  /// A blow left `print` on the clay as it is in this tick. O(rows).
  void strike(const StageWork& work, const Print& print) noexcept;
  /// Stage 6.10: hands that press a printed wall smooth it. O(rows) for each.
  void run(const StageWork& work) noexcept;
  /// All of this lump, the first one first, where they lie now. Allocates. O(rows + prints).
  std::vector<Print> seen(const Clay& clay, const Volume& volume) const;

  void row_added(const Clay&, const RowAdded&) noexcept {}
  void row_divided(const Clay&, const RowDivided&) noexcept {}
  void rows_joined(const Clay&, const RowsJoined&) noexcept {}
  void forget(Clay& clay, const Laid& laid) noexcept;
  void add_to(StateHash& hash, const Clay& clay) const;

 private:
  static constexpr std::uint8_t kFreshLump = 255;
  struct Mark {
    std::uint32_t step = 0;         // clay::History::depth()
    std::uint32_t name = 0;         // in the order in which they came
    double low = 0.0, high = 0.0;   // m^3 of clay below
    float from = -1.0f, to = 1.0f;  // of the face
    float angle = 0.0f, half = 0.0f, wide = 0.0f, tall = 0.0f, deep = 0.0f;
    std::uint8_t kind = 0;  // of Print, or kFreshLump
    WallSide side = WallSide::outside;
    bool left = false;
  };
  struct Cut {
    double gone = 0.0;    // m^3, cut off since lower(); there: off all rows up to this one
    double before = 0.0;  // m^3: the clay below the row's top before that
  };
  // Where a mark was before the first cut of a step.
  struct Was {
    double low = 0.0, high = 0.0;
    std::uint32_t name = 0, step = 0;
  };
  const Mark& at(std::size_t n) const { return marks_[(first_ + n) % kMost]; }
  Mark& at(std::size_t n) { return marks_[(first_ + n) % kMost]; }
  static bool place(const StageWork& work, double low, double high, double foot,
                    Mark& mark) noexcept;
  void note(const Mark& mark) noexcept;
  void drop(std::size_t n) noexcept;
  void make_room_for_field() noexcept;
  double bare(std::size_t n) const noexcept;
  void count_live() noexcept;
  void keep_places(std::uint32_t step) noexcept;
  void put_back(std::uint32_t step) noexcept;
  bool goes_on(Mark& last, const Mark& more) const noexcept;

  std::vector<Mark> marks_;  // a ring
  std::size_t first_ = 0, count_ = 0;
  std::size_t live_ = 0;                        // of count_, those of this lump
  std::array<std::size_t, kMostHands> back_{};  // where a hand's last mark lies, from the end: 1 is
                                                // the last one; 0: it smooths nothing
  std::size_t looked_at_ = 0;                   // make_room_for_field()
  std::uint32_t names_ = 0;
  std::vector<Cut> cut_;             // of row j
  int first_cut_ = 0, end_cut_ = 0;  // rows
  std::vector<Was> was_;             // a ring
  std::size_t first_was_ = 0, was_count_ = 0;
};

}  // namespace effects
}  // namespace onggi
