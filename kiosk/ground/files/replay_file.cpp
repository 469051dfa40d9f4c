#include "kiosk/ground/files/replay_file.h"

#include <span>

#include "kiosk/ground/files/read_file.h"
#include "kiosk/ground/files/zstandard.h"

namespace onggi::files {

namespace {
constexpr std::size_t kLargest = 1u << 30;  // Over ten hours of restless hands.
}

Result<Replay> read_replay(const std::filesystem::path& file) {
  using Fault = files::ReadFault::Kind;
  const std::string name = file.string();
  const auto bytes = files::read_file(file, kLargest);
  if (bytes && !is_packed(std::as_bytes(std::span(*bytes))))
    return Replay::read(std::as_bytes(std::span(*bytes)), name);
  if (bytes) {
    const auto replay = unpacked(std::as_bytes(std::span(*bytes)), kLargest);
    if (replay) return Replay::read(*replay, name);
    return problem(name, "The replay is damaged or cut short: it cannot be unpacked.",
                   "Use a replay file that this program wrote, whole.");
  }
  switch (bytes.error().kind) {
    case Fault::too_large:
      return problem(name, "It is over 1 GiB, larger than any visit.", "Name a visit.onggi.");
    case Fault::closed:
    case Fault::unreadable:
      return problem(name, "It could not be read.", "Check its permissions and disk.", 1);
    default:
      return problem(name, "There is no such file.", "Name the visit.onggi of a kept visit.");
  }
}

}  // namespace onggi::files
