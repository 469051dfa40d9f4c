#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/collection/settings/translations.h"

namespace onggi::content {

/// What the hands in a step's drawing do.
enum class HandsDrawn : std::uint8_t { around, inside, up, along, rim, wire, coil, fire, paddle };
inline constexpr std::array<std::string_view, 9> kHandsDrawn{
    "around", "inside", "up", "along", "rim", "wire", "coil", "fire", "paddle"};

/// What a visitor has done when a step is complete.
enum class DoneWhen : std::uint8_t {
  touched,
  opened,
  raised,
  shaped,
  rim,
  cut,
  laid,     ///< Of a pot that is built of coils: a ring is closed;
  built,    ///< it has its vessel's clay;
  dried,    ///< it is dry enough to be beaten;
  ringing,  ///< a blow fell on clay that is;
  beaten    ///< its wall is thin and on the line.
};
inline constexpr std::array<std::string_view, 11> kDoneWhen{
    "touched", "opened", "raised", "shaped",  "rim",   "cut",
    "laid",    "built",  "dried",  "ringing", "beaten"};

/// One step of a lesson.
struct LessonStep {
  std::string id;                            ///< "touch"; letters, digits and _; 1..40 of them.
  std::map<std::string, std::string> words;  ///< Words by language: a sentence or two.
  HandsDrawn hands = HandsDrawn::around;
  DoneWhen until = DoneWhen::touched;
  double after = 15.0;  ///< s after which the step goes away, done or not: 3..120.

  /// The words in `language`, else in the first language.
  const std::string& words_in(const std::string& language) const;
};

inline constexpr std::size_t kMostSteps = 12;

/// The steps of a file and everything found wrong in it, with line and column.
struct LessonRead {
  std::vector<LessonStep> steps;  ///< The good ones, in the file's order; at most kMostSteps.
  std::vector<Problem> problems;
  int keys_checked = 0;
};

/// Reads content/lessons/NAME.toml, a [[step]] each (kiosk/docs/lesson.md), with words in all of
/// `languages`. A step without id or words is left out; other invalid values get their default. A
/// file without steps is an empty lesson. `translations` come before a step's own words.
LessonRead read_lesson(const std::filesystem::path& file,
                       const std::vector<std::string>& languages = {},
                       const settings::Translations& translations = {});

}  // namespace onggi::content
