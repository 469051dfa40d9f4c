#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/clay/clay.h"
#include "engine/math/hash.h"
#include "engine/math/vec.h"

namespace onggi::effects {

/// How deep a ball lies in a round body.
struct Overlap {
  double depth = 0.0;  ///< m; 0: clear.
  Vec3 out;            ///< The way out; unit.
};

/// A ring of coil on the rim that is not closed yet. Rows have one height all round, so the laid
/// sectors wait beside them. Keeps the order in which sectors were laid, for undo. Allocates only
/// when made; one thread.
class LaidCoil {
 public:
  /// `most`: sectors and rows of one lump's coils, at most.
  LaidCoil(int sectors, std::size_t most);

  bool any() const { return count_ > 0; }
  bool closed() const { return count_ == sectors(); }
  int sectors() const { return static_cast<int>(centre_.size()); }
  int count() const { return count_; }  ///< Sectors laid.
  /// Distance of the coil's middle from the axis, m; 0 where nothing lies.
  float centre(int sector) const { return centre_[static_cast<std::size_t>(sector)]; }
  std::span<const float> centres() const { return centre_; }
  /// Its clay, m^3: `section` (m^2) times the length of its middle line.
  double volume(double section) const noexcept;

  /// Lays `sector`, which was free, in step `step` (clay::History::depth()).
  void lay(int sector, float centre, std::uint64_t step) noexcept;
  /// Gaps narrower than `length` (m), by their arc at the end nearer to the axis, are laid evenly
  /// from one end to the other; none wider than an eighth of the ring. O(sectors).
  void close_gaps(double length, std::uint64_t step) noexcept;
  /// A row that a ring of coil became.
  struct Row {
    int stored = 0;
    bool joint = false;   ///< It lies at the ring's joint.
    double volume = 0.0;  ///< m^3
    double square = 0.0;  ///< Mean of outer^2 + inner^2 as laid, m^2.
  };
  /// `row` of the closed ring became clay in `step`. `last`: the next ring begins.
  void raise(const Row& row, bool last, std::uint64_t step) noexcept;
  /// No room is left for what `more` sectors and rows need to be taken back.
  bool full(std::size_t more) const { return events_.size() - lump() + more > most_; }
  int raised() const { return raised_; }  ///< Rows of the closed ring that are clay.
  /// Clay that rows brought since the lump was laid, m^3; what was taken back is left out.
  double added() const { return added_; }
  /// A fresh lump was laid in `step`: nothing lies on it.
  void clear(std::uint64_t step) noexcept;
  /// `step` and all later steps were taken back. O(sectors, and what they laid).
  void go_back(std::uint64_t step) noexcept;
  /// Calls `visit` with each Row since the lump was laid.
  template <class Visit>
  void each_row(Visit&& visit) const {
    for (std::size_t n = lump(); n < events_.size(); ++n)
      if (events_[n].what < 0) visit(events_[n].row);
  }

  /// A ball of `radius` at `at` (clay frame, m) against the laid part: a tube of `coil` (m) whose
  /// middle lies at `height`. The nearest place counts. O(sectors within reach).
  Overlap touched(const Clay& clay, Vec3 at, double radius, double coil,
                  double height) const noexcept;
  void add_to(StateHash& hash) const;

 private:
  static constexpr std::int32_t kRow = -1, kLastRow = -2, kFreshLump = -3;
  struct Event {
    std::uint64_t step = 0;
    std::int32_t what = 0;  // sector, kRow, kLastRow or kFreshLump
    float centre = 0.0f;    // of a sector
    Row row;
  };
  int gap_after(int sector) const noexcept;
  std::size_t lump() const noexcept;
  void note(const Event& event) noexcept;
  void take(const Event& event) noexcept;

  std::vector<float> centre_;  // by sector
  std::vector<Event> events_;  // of this lump and the one before; capacity never grows
  std::size_t most_;
  int count_ = 0;
  int raised_ = 0;
  double added_ = 0.0;
};

/// A ball of `radius` at `at` (clay frame, m) against the wall of the top row: upright, its edges
/// rounded by 3 mm or by half a thin wall. Never down. Radii between two rays are interpolated;
/// that the rim leans along itself is left out.
Overlap rim_touched(const Clay& clay, Vec3 at, double radius) noexcept;

/// The sector at the angle of `at` (clay frame).
int sector_at(const Clay& clay, Vec3 at) noexcept;

}  // namespace onggi::effects
