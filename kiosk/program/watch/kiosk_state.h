#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kiosk/ground/files/log.h"
#include "kiosk/program/watch/health.h"

namespace onggi::watch {

/// What a running kiosk says of itself to the staff of its machine.
struct KioskState {
  Health health;
  std::string exhibit;     ///< Its exhibit.toml, absolute.
  bool stands_in = false;  ///< Another exhibit than the museum's: that one is broken or crashed.
  std::int64_t said = 0;   ///< When this was so, s since 1970 by this machine's clock.
  bool open = false;       ///< A vessel can be chosen; false: it still begins.
  bool visitor = false;    ///< Somebody plays.
  bool ended = false;      ///< It was closed on request.
  std::string vessel;      ///< Id of the vessel on the wheel; "": none.
  double frames_a_second = 0.0;
  std::vector<std::string> devices;  ///< Names of the hand devices that are plugged in.
  /// The way into the staff's page that its screen showed last: the code's digest, and until when
  /// it is good, s since 1970.
  std::string way_in{};
  std::int64_t way_in_until = 0;
  std::optional<files::Trouble> trouble{};  ///< The last problem in its log.
};

/// A line a value: "frames 1234". At most kMostOfAState bytes, whatever a problem or a name says.
std::string text_of(const KioskState& state);
inline constexpr std::size_t kMostOfAState = 16384;

/// The state in `text`; nothing if its last line is missing, as in one that is being written. Keys
/// that are not known are skipped.
std::optional<KioskState> state_of(std::string_view text);

/// The file with the state, in the folder of the keepsakes.
inline constexpr const char* kStateFile = ".kiosk";

/// What the machine says of a kiosk.
struct SeenKiosk {
  std::optional<KioskState> state;  ///< The last one that it wrote.
  bool runs = false;                ///< Its process is there: it holds the file's lock.
};

/// Looks at the kiosk that keeps its keepsakes in `keepsakes`. Reads one small file. Its way in
/// counts only where the file is of the folder's owner.
SeenKiosk look_at_kiosk(const std::filesystem::path& keepsakes);

}  // namespace onggi::watch
