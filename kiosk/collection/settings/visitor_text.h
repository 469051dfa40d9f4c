#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "kiosk/ground/toml/toml_reader.h"

namespace onggi::settings {

/// How long a text for visitors may be, so that every screen has room for it.
struct TextBound {
  std::size_t letters;  ///< Unicode characters, also combining ones; at least 2.
  bool lines = false;   ///< It may have line breaks and tabs.
  bool wide = false;    ///< A Chinese, Japanese or Korean letter counts twice.
};

/// All bounds, in letters. config/README.md and the pages about content name them to curators.
/// tests/kiosk/visit/screens/fonts_test.cpp lays out labels of these lengths.
namespace bounds {
// exhibit.toml: the postcard's credit line, a screen's title.
inline constexpr TextBound kExhibitTitle{120}, kExhibitCredit{120};
// vessel.toml. Its words are also limited to 100.
inline constexpr TextBound kTitle{60, false, true}, kCulture{80, false, true};
inline constexpr TextBound kWhat{40, false, true};
inline constexpr TextBound kDate{60, false, true}, kLabelCredit{300, false, true};
inline constexpr TextBound kMade{300, true, true}, kText{900, true, true};
// Printed in one line: institution, accession, credit.
inline constexpr TextBound kInstitution{100}, kAccession{40}, kCredit{200};
// In a keepsake's files, on no screen.
inline constexpr TextBound kLicence{200}, kSource{1000, true};
// glazes.toml
inline constexpr TextBound kGlazeName{40}, kGlazeAbout{160, true};
// A way to decorate: names of it, its tools, pigments and figures; what a finger does.
inline constexpr TextBound kWayName{40, false, true}, kWayAbout{200, true, true};
inline constexpr TextBound kToolHow{120, false, true};
// A lesson's step, which is read at a glance.
inline constexpr TextBound kStepWords{120};
// missions.toml: a card's title, the task.
inline constexpr TextBound kMissionTitle{40}, kMissionAbout{240, true};
// A language's own name, on a button. Its texts: bound_beside().
inline constexpr TextBound kLanguageName{30};
}  // namespace bounds

/// The bound for a translation of `english`: twice its letters and 20, since other languages are
/// longer, and single words longest.
TextBound bound_beside(std::string_view english);

/// Letters of a word without a place to break. A longer one is broken anywhere, or fills a card.
inline constexpr std::size_t kMostWordLetters = 40;

/// Unicode characters of a UTF-8 text, not bytes.
std::size_t letters(std::string_view utf8);

/// What counts against a bound: letters, or where wide ones count twice their columns.
std::size_t count_for(std::string_view utf8, TextBound bound);

/// Letters of the longest word: between spaces, hyphens and slashes. Writing that breaks anywhere
/// (Chinese, Japanese, Korean, Thai and its neighbours) has no long words.
std::size_t longest_word(std::string_view utf8);

/// True if nothing of `utf8` can be seen: it is empty, or has only spaces, control characters and
/// characters of no width.
bool is_blank(std::string_view utf8);

/// What is wrong with a text for visitors, and what to do; each a sentence.
struct TextFault {
  std::string what, remedy;
};
/// The first fault of `text`, which a message calls `name`: nothing to see, a control character, a
/// word or a text that is too long. None if a screen can show it.
std::optional<TextFault> fault_of(std::string_view text, const std::string& name, TextBound bound);

/// `text` as far as a screen can show it: a space for each control character that `bound` does not
/// allow, and "…" at the end if that is not all.
std::string fitted(std::string_view text, TextBound bound);

/// `utf8` with a break of no width (U+200B) after each kMostWordLetters letters of a longer word.
/// Pango's time for a word grows with its square, because it tries each place to break.
std::string with_breaks(std::string_view utf8);

/// Reads `key`, called `name` in messages. True, with `out` set, if present and without fault;
/// notes a fault in the file.
bool read_visitor_text(toml::TomlReader::Table& table, std::string_view key,
                       const std::string& name, TextBound bound, std::string& out);

}  // namespace onggi::settings
