#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/base/result.h"
#include "engine/clay/clay.h"
#include "engine/math/vectors.h"
#include "engine/scene/coil_view.h"
#include "engine/scene/hand_view.h"
#include "engine/scene/hands.h"
#include "engine/scene/scene_def.h"

namespace onggi {

/// Counters of the ticks' work, monotonic since create().
struct SceneCounters {
  std::uint64_t ticks = 0;
  std::uint64_t visited_elements = 0;
  std::uint64_t touched_elements = 0;
  std::uint64_t held_samples = 0;   ///< Hand samples refused by the input check.
  std::uint64_t clamped_times = 0;  ///< dt outside [1 us, 5 ms].
};

/// A pot on a wheel. The numbered pipeline of engine/docs/pipeline.md, one tick at a time.
/// Movable, not copyable. One thread at a time.
class Scene {
 public:
  /// Allocates everything the scene will ever use. `vectors`, one of vectors_here(), changes only
  /// the speed.
  static Result<Scene> create(const SceneDef& def, Vectors vectors = best_vectors());
  Scene(Scene&&) noexcept;
  Scene& operator=(Scene&&) noexcept;
  ~Scene();

  /// Advances by `dt` seconds (clamped to [1 us, 5 ms]). No allocation, lock, file or throw.
  Feedback step(const Hands& hands, double dt) noexcept;

  const SceneDef& def() const;
  const Clay& clay() const;
  /// The pot fell by more than SlumpDef::fall since it was last laid. Hands::restore then goes back
  /// to where it last stood.
  bool fallen() const;
  /// Row `row` of the clay is torn (WallsDef): hands pass through it, until a fresh lump is laid or
  /// Hands::restore goes back to before the last tear. The row is dirty when this changes.
  bool torn(int row) const;
  /// Wetness of row `row` of the clay, 0..1, for drawing.
  double wetness_of(int row) const;
  /// The coil on the rim (BuildingDef).
  CoilView coil() const;
  /// Where blows fell and hands smoothed (PrintsDef), the first one first; empty where the scene
  /// keeps none. Allocates; not for the tick.
  std::vector<Print> prints() const;
  /// A fresh lump is being laid, or a step undone: rows are partly old, partly new.
  bool laying() const;
  /// Hands::restore has a stroke, or a fresh lump, to undo.
  bool can_restore() const;
  /// Returns and clears the lowest changed row at or above `from`; -1 if there is none. No
  /// allocation.
  int take_dirty_row(int from) noexcept;
  /// The same for rows that only moved, tore or healed. Take the changed rows first.
  int take_moved_row(int from) noexcept;
  void mark_all_dirty() noexcept;
  /// What hand `n` (0..kMaxHands - 1) holds, and where, after the last tick.
  HandView hand(int n) const noexcept;
  /// Clears these FaultBits after they were reported. Changes neither state_hash() nor a replay.
  void clear_faults(std::uint32_t which = ~0u) noexcept;
  const SceneCounters& counters() const;
  double time() const;  ///< Simulated seconds since create().
  /// Hash of all state that the next tick depends on. O(rows x sectors); not for the tick.
  std::uint64_t state_hash() const;

 private:
  struct State;
  explicit Scene(std::unique_ptr<State>);
  std::unique_ptr<State> state_;
};

}  // namespace onggi
