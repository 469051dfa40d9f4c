#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "kiosk/ground/files/json.h"
#include "kiosk/program/console/sentence.h"
#include "kiosk/program/watch/kiosk_state.h"

namespace onggi::console {

/// What is known of a site's kiosk at one moment.
struct Known {
  watch::SeenKiosk kiosk;
  std::int64_t now = 0;                        ///< s since 1970.
  std::string exhibit;                         ///< The site's exhibit.toml.
  std::string vessel;                          ///< Name of the vessel on the wheel, for people.
  std::optional<std::uint64_t> free_bytes;     ///< Of the keepsakes' disk; absent: not readable.
  std::optional<std::size_t> file_problems{};  ///< That onggi check found; absent: not known.
  std::optional<bool> phones_answered;         ///< Absent: visitors' phones get no pages here.
};

/// How a line of the report is: as it should be, worth a look, or wrong.
enum class Mood : std::uint8_t { good, look, wrong };

/// One thing that staff want to know, in words.
struct Line {
  std::string id;    ///< "kiosk", "picture", "wheel", "keepsakes", "disk", "devices", "phones",
                     ///< "files", "trouble".
  std::string name;  ///< "Keepsakes"; a key of PageWords, too.
  Mood mood = Mood::good;
  std::vector<Sentence> says{};
  Sentence remedy{};  ///< What to do; without words: nothing.
};

/// The state in words: the kiosk first. Pure.
std::vector<Line> report_of(const Known& known);

/// {"mood": the worst, "lines": [{id, name, mood, says: [sentence], remedy: sentence or null}]}
files::Json json_of(const std::vector<Line>& lines);

}  // namespace onggi::console
