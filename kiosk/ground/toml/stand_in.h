#pragma once

#include <filesystem>
#include <string>

namespace onggi::toml {

/// While it lives, this process reads `text` where it reads `file` as TOML, so that a change can be
/// checked before it is written. `file` must exist. One at a time: a second one replaces the first.
/// Made and ended by one thread, while others may read. The kiosk itself makes none.
class StandIn {
 public:
  StandIn(const std::filesystem::path& file, std::string text);
  ~StandIn();
  StandIn(const StandIn&) = delete;
  StandIn& operator=(const StandIn&) = delete;
  /// Somebody has read `file` since. Any thread.
  bool was_read() const;
};

/// The text that stands in for `file` now, or null. For read_toml_text().
const std::string* standing_in_for(const std::filesystem::path& file);

}  // namespace onggi::toml
