#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"

namespace onggi::settings {

/// Something else to do at the wheel than to choose a vessel, which a curator may switch on.
struct Mission {
  enum class Kind : std::uint8_t {
    today,        ///< One vessel of the shelf a day.
    describe,     ///< No vessel: a shape by figures.
    eyes_closed,  ///< The pot is not shown: sound alone tells of it.
    two_hands     ///< Two visitors, a hand each.
  };
  /// What a pot is to measure, as it is thrown; metres.
  struct Described {
    /// From .. to, both included; metres.
    struct Bounds {
      double least = 0.0, most = 0.0;
      friend bool operator==(const Bounds&, const Bounds&) = default;
    };
    double volume = 0.001;         ///< m^3 that it holds, filled to its rim.
    std::optional<Bounds> height;  ///< From the standing surface to the rim.
    std::optional<Bounds> mouth;   ///< Outer diameter at the rim.
    friend bool operator==(const Described&, const Described&) = default;
  };
  std::string id;  ///< Lower-case letters, digits and _; 1..40 of them.
  Kind kind = Kind::today;
  bool on = true;
  std::map<std::string, std::string> title;  ///< By language: of its card, a few words.
  std::map<std::string, std::string> about;  ///< By language: what there is to do.
  std::vector<std::string> vessels;  ///< Today's: of the shelf, day by day; empty: all of it.
  Described wanted;                  ///< Of a description.
  std::string vessel;                ///< Of the last two, on the shelf; empty: the shelf's first.
  /// Of two hands, what the second visitor has.
  enum class Second : std::uint8_t {
    finger,  ///< A second finger on the glass.
    keys     ///< A keyboard, beside the mouse or finger of the first.
  };
  Second second = Second::finger;

  /// In `language`, else in English, else in the first there is; empty where there is none.
  const std::string& title_in(const std::string& language) const;
  const std::string& about_in(const std::string& language) const;
};

inline constexpr std::array<std::string_view, 4> kMissionKinds{"today", "describe", "eyes_closed",
                                                               "two_hands"};
inline constexpr std::array<std::string_view, 2> kSecondHands{"finger", "keys"};
inline constexpr std::size_t kMostMissions = 6;
inline constexpr std::size_t kMostTitleLetters = 40;   ///< Of a mission's title: a card's width.
inline constexpr std::size_t kMostAboutLetters = 240;  ///< Of what it says of itself.
/// Litres that a description may ask for: what hands shape on this wheel.
inline constexpr double kLeastLitres = 0.1, kMostLitres = 3.0;

/// The missions of a file and everything found wrong in it, with line and column.
struct MissionsRead {
  std::vector<Mission> missions;  ///< The good ones, off or on, in the file's order.
  std::vector<Problem> problems;
  int keys_checked = 0;
};

/// Reads content/missions.toml: a [[mission]] each (kiosk/docs/missions.md), with a title and words
/// in every one of `languages`. `shelf`: the ids of the vessels that a mission may name; none
/// given, it may name any. A mission that could not be played as it is written is left out; one
/// that only lacks a language stands. A file without missions is good.
MissionsRead read_missions(const std::filesystem::path& file,
                           const std::vector<std::string>& languages = {},
                           const std::vector<std::string>& shelf = {});

}  // namespace onggi::settings
