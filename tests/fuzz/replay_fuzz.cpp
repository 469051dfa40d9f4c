// Any bytes are a replay: as they are, unpacked, and with the checksum put right, so that the
// fuzzer gets past it. What is read is written and read again, and is then the same to the bit.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "engine/scene/replay.h"
#include "engine/scene/replay_bytes.h"
#include "kiosk/ground/files/zstandard.h"

namespace {

using namespace onggi;

std::vector<std::byte> written(const Replay& replay) {
  ReplayWriter writer(replay.def, replay.vessel_id, replay.seed);
  auto note = replay.notes.begin();
  for (std::size_t n = 0; n <= replay.ticks.size(); ++n) {
    for (; note != replay.notes.end() && note->tick == n; ++note) writer.note_hash(note->hash);
    if (n < replay.ticks.size()) writer.tick(replay.ticks[n]);
  }
  return writer.finish(replay.final_hash, replay.glaze);
}

void look(std::span<const std::byte> bytes) {
  const auto replay = Replay::read(bytes, "fuzz");
  if (!replay) {
    if (replay.error().what.empty() || replay.error().remedy.empty()) std::abort();
    return;
  }
  const auto once = written(*replay);
  const auto again = Replay::read(once, "fuzz");
  if (!again || written(*again) != once) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(data, size));
  look(bytes);
  constexpr std::size_t kMost = 1u << 20;
  if (const auto replay = files::unpacked(bytes, kMost)) look(*replay);
  std::vector<std::byte> right(bytes.begin(), bytes.end());
  right.resize(size - std::min(size, replay_bytes::kSealBytes));
  replay_bytes::seal(right);
  look(right);
  return 0;
}
