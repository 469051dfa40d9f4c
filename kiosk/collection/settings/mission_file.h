#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/collection/settings/translations.h"

namespace onggi::settings {

/// Another task at the wheel, instead of choosing a vessel. A curator can switch it on.
struct Mission {
  enum class Kind : std::uint8_t {
    today,        ///< One vessel of the shelf each day.
    describe,     ///< No vessel: a shape described by figures.
    eyes_closed,  ///< The pot is hidden; only sound describes it.
    two_hands     ///< Two visitors, one hand each.
  };
  /// The wanted figures of a pot as thrown; metres.
  struct Described {
    /// From .. to, both included; metres.
    struct Bounds {
      double least = 0.0, most = 0.0;
      friend bool operator==(const Bounds&, const Bounds&) = default;
    };
    double volume = 0.001;         ///< Capacity, filled to its rim, m^3.
    std::optional<Bounds> height;  ///< From the standing surface to the rim.
    std::optional<Bounds> mouth;   ///< Outer diameter at the rim.
    friend bool operator==(const Described&, const Described&) = default;
  };
  std::string id;  ///< Lower-case letters, digits and _; 1..40 of them.
  Kind kind = Kind::today;
  bool on = true;
  std::map<std::string, std::string> title;  ///< Title of its card by language, a few words.
  std::map<std::string, std::string> about;  ///< The task, by language.
  /// For `today`: vessels of the shelf, day by day; empty: all of it.
  std::vector<std::string> vessels;
  Described wanted;    ///< For `describe`.
  std::string vessel;  ///< For the last two kinds: a vessel on the shelf; empty: the first.
  /// For two hands: the second visitor's input.
  enum class Second : std::uint8_t {
    finger,  ///< A second finger on the glass.
    keys     ///< A keyboard, beside the mouse or finger of the first visitor.
  };
  Second second = Second::finger;

  /// The title in `language`, else in English, else in the first language; empty if there is none.
  const std::string& title_in(const std::string& language) const;
  const std::string& about_in(const std::string& language) const;
};

inline constexpr std::array<std::string_view, 4> kMissionKinds{"today", "describe", "eyes_closed",
                                                               "two_hands"};
inline constexpr std::array<std::string_view, 2> kSecondHands{"finger", "keys"};
inline constexpr std::size_t kMostMissions = 6;
/// Litres that a description may ask for: what hands can shape on this wheel.
inline constexpr double kLeastLitres = 0.1, kMostLitres = 3.0;

/// The missions of a file and everything found wrong in it, with line and column.
struct MissionsRead {
  std::vector<Mission> missions;  ///< The valid ones, off or on, in the file's order.
  std::vector<Problem> problems;
  int keys_checked = 0;
};

/// Reads content/missions.toml, a [[mission]] each (kiosk/docs/missions.md), with a title and words
/// in all of `languages`. `shelf`: the ids that a mission may name; if empty, any. A mission that
/// cannot be played is left out; one that only lacks a language stays. A file without missions is
/// valid. `translations` come before a mission's own words.
MissionsRead read_missions(const std::filesystem::path& file,
                           const std::vector<std::string>& languages = {},
                           const std::vector<std::string>& shelf = {},
                           const Translations& translations = {});

}  // namespace onggi::settings
