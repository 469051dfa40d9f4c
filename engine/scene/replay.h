#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/scene/scene.h"

namespace onggi {

/// One tick's input, enough to repeat it bit for bit.
struct TickRecord {
  Hands hands;
  double dt = 0.001;
};

/// Writes a replay: header (magic, version, SceneDef, vessel id), then each tick as the fields that
/// changed since the one before (an unchanged tick is one byte); every simulated second a state
/// hash may be noted; at the end the glaze that was chosen and the last hash. Bit for bit, NaN and
/// -0 included. Little-endian everywhere; at the very end a CRC-64 of all before it. Allocates; not
/// for the tick.
class ReplayWriter {
 public:
  ReplayWriter(const SceneDef& def, const std::string& vessel_id, std::uint64_t seed);
  void tick(const TickRecord& record);
  void note_hash(std::uint64_t state_hash);
  /// Ends the replay with the final hash and gives its bytes. `glaze`: the id of the one that the
  /// pot was fired with; empty where it was not.
  std::vector<std::byte> finish(std::uint64_t state_hash, const std::string& glaze = {});

 private:
  std::vector<std::byte> bytes_;
  TickRecord last_;
};

/// What replaying found.
struct ReplayOutcome {
  std::string vessel_id;
  std::string glaze;  ///< "": not fired.
  std::uint64_t seed = 0;
  std::uint64_t ticks = 0;
  std::uint64_t recorded_hash = 0;  ///< The hash written at the end.
  std::uint64_t replayed_hash = 0;  ///< The hash this engine came to.
  std::uint64_t hashes_checked = 0;
  std::int64_t first_difference_tick = -1;  ///< -1: every hash agreed.
};

/// A replay read whole; refuses anything malformed: wrong magic or version, a byte that is not as
/// it was written, cut short, bad def, more than 4 million ticks (exit 2).
struct Replay {
  SceneDef def;
  std::string vessel_id;
  std::uint64_t seed = 0;
  struct Note {
    std::uint64_t tick = 0;  ///< Ticks done when it was noted.
    std::uint64_t hash = 0;
  };
  std::vector<TickRecord> ticks;
  std::vector<Note> notes;
  std::uint64_t final_hash = 0;
  std::string glaze;  ///< "": not fired.
  static Result<Replay> read(std::span<const std::byte> bytes, const std::string& name);
};

/// Runs `replay` on a fresh scene and compares the hashes. `scene_out`, if given, receives the
/// scene.
Result<ReplayOutcome> run_replay(const Replay& replay, std::unique_ptr<Scene>* scene_out = nullptr);

}  // namespace onggi
