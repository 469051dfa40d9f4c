#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/scene/replay_columns.h"
#include "engine/scene/scene.h"

namespace onggi {

/// One tick's input, enough to repeat it bit for bit.
struct TickRecord {
  Hands hands;
  double dt = 0.001;
};

/// Writes a replay: a header (magic, version, SceneDef, seed, vessel id), the fired glaze, the last
/// hash, hashes noted on the way, what changed in each tick, by columns (replay_columns.h), and a
/// CRC-64 of everything before. Bit for bit, including NaN and -0; always little-endian. An
/// unchanged tick is one byte. Allocates; not for the tick.
class ReplayWriter {
 public:
  ReplayWriter(const SceneDef& def, const std::string& vessel_id, std::uint64_t seed);
  void tick(const TickRecord& record);
  void note_hash(std::uint64_t state_hash);
  /// Whether one more tick would make it a replay that nobody opens: see Replay.
  bool full() const;
  /// The replay so far, ended with the final hash. `glaze`: id of the fired glaze; empty if not
  /// fired.
  std::vector<std::byte> finish(std::uint64_t state_hash, const std::string& glaze = {}) const;

 private:
  std::vector<std::byte> head_;
  replay_bytes::Columns columns_;
  std::vector<replay_bytes::Note> notes_;
  TickRecord last_;
};

/// The result of run_replay().
struct ReplayOutcome {
  std::string vessel_id;
  std::string glaze;          ///< "": not fired.
  bool earlier_laws = false;  ///< Recorded with an earlier version of the clay's laws: the same
                              ///< hands may make a different pot, and the hashes cannot agree.
  std::uint64_t seed = 0;
  std::uint64_t ticks = 0;
  std::uint64_t recorded_hash = 0;  ///< The hash written at the end.
  std::uint64_t replayed_hash = 0;  ///< The hash that this engine computed.
  std::uint64_t hashes_checked = 0;
  std::int64_t first_difference_tick = -1;  ///< -1: every hash agreed.
};

/// A whole replay. Refuses wrong magic or version, a failed checksum, truncation, an invalid scene,
/// more than 4 million ticks (exit 2).
struct Replay {
  SceneDef def;
  std::string vessel_id;
  bool earlier_laws = false;  ///< As in ReplayOutcome.
  std::uint64_t seed = 0;
  std::vector<TickRecord> ticks;
  std::vector<replay_bytes::Note> notes;
  std::uint64_t final_hash = 0;
  std::string glaze;  ///< Empty: not fired.
  static Result<Replay> read(std::span<const std::byte> bytes, const std::string& name);
};

/// Runs `replay` on a fresh scene and compares the hashes. `scene_out`, if given, receives the
/// scene.
Result<ReplayOutcome> run_replay(const Replay& replay, std::unique_ptr<Scene>* scene_out = nullptr);

}  // namespace onggi
