#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/collection/settings/hours.h"
#include "kiosk/collection/settings/reader_limits.h"
#include "kiosk/collection/settings/rubric.h"
#include "kiosk/collection/settings/translations.h"

namespace onggi::settings {

/// One exhibit, as config/exhibit.toml describes it. All defaults are here; config/README.md
/// explains them to curators. Relative paths, also default ones, start at the folder of the file.
struct Exhibit {
  std::filesystem::path file;  ///< The file that was read.
  std::map<std::string, std::string> title{{"en", "Make a pot"},
                                           {"ko", "도자기 빚기"}};  ///< By language.
  std::string credit = "Onggi";                    ///< Printed on the keepsake; 1..120 letters.
  std::vector<std::string> languages{"en", "ko"};  ///< The first is the default; 1..12 of them.
  /// What attract mode shows, pot by pot: "follow" a vessel, or a script for an effect
  /// (ScriptInfo::shows), which is skipped if the vessel's scene lacks that effect. 1..32.
  std::vector<std::string> attract_scripts{"follow",    "centre", "follow",
                                           "pull_tall", "follow", "collapse"};
  struct Idle {
    double warn_after = 60.0;     ///< s without input before "are you still there?", 20..3600.
    double countdown = 25.0;      ///< s of visible countdown, 20..300.
    double result_after = 120.0;  ///< s on result and keepsake before the warning, 20..3600.
  } idle;
  std::filesystem::path shelf = "../content/vessels";  ///< Folder of vessels.
  /// Ids of the vessels that stand first, in this order. The others follow in the order of ids.
  std::vector<std::string> order{"moon_jar"};
  std::vector<std::string> hidden;  ///< Ids of the vessels that visitors do not see.
  std::filesystem::path scene = "scenes/first_touch.toml";  ///< TOML of the scene.
  /// By a vessel's id on the shelf: the scene for it, instead of `scene`.
  std::map<std::string, std::filesystem::path> vessel_scenes;
  std::filesystem::path rubric_file = "rubric.toml";  ///< TOML of the rubric; may be absent.
  Rubric rubric;                                      ///< Its values, or the defaults.
  std::filesystem::path glazes =
      "../content/glazes.toml";  ///< The glazes to choose from; used where the scene has a kiln.
  bool build = true;  ///< Visitors may build the vessels that were built (Vessel::built),
  std::optional<std::filesystem::path> built_scene;  ///< in this scene; absent: they throw them.
  std::optional<std::filesystem::path>
      build_lesson;  ///< What they are taught then; absent: nothing.
  /// Folder of the ways to decorate a pot, a TOML each; absent: none.
  std::optional<std::filesystem::path> ways;
  bool decorate = true;  ///< Visitors may decorate their pots.
  /// TOML of the lesson of the first minute; absent: none.
  std::optional<std::filesystem::path> lesson;
  /// TOML of the missions that visitors can choose before a vessel; absent: none.
  std::optional<std::filesystem::path> missions;
  struct Keepsake {
    /// Folder of the postcards; created when first needed.
    std::filesystem::path folder = "../keepsakes";
    int quota_mb = 2000;  ///< MB; beyond it the oldest visits are removed, 10..1000000.
    int days = 0;  ///< Days after which a visit is removed, 1..3650; 0: only beyond the quota.
    bool gallery = true;  ///< Visitors see the pots of today, without a name.
    bool turning = true;  ///< A turning picture of the pot is kept too.
  } keepsake;
  struct Store {
    bool count = true;  ///< Visits are counted in a file beside the keepsakes.
    int months = 36;    ///< Months after which a visit's count is deleted, 1..240.
  } store;
  struct Screen {
    double viewing_distance_mm = 600;  ///< Eye to screen, 200..5000.
    double diagonal_mm = 600;          ///< Of the picture, corner to corner, 100..5000.
    double lower_edge_mm = 900;        ///< Floor to the lower edge of the picture, 0..1000.
    // Defaults for every visitor; visitors can change them for their visit.
    bool reduced_motion = false;
    bool left_handed = false;    ///< Mirrors the layout and the wheel.
    bool high_contrast = false;  ///< Text contrast 7:1, heavier lines.
    bool larger_text = false;
    bool low_reach = false;     ///< Everything between 380 and 1,220 mm above the floor.
    bool spoken = false;        ///< The screen's content is read aloud.
    bool one_switch = false;    ///< Any key, button or touch is the visitor's one switch;
    double scan_seconds = 1.5;  ///< each choice is offered for this long, s, 0.5..5.
    bool silent = false;        ///< No sound, whatever [sound] contains.
    double force = 1.0;         ///< 0 (off) .. 1 of the device's limit.
  } screen;
  struct Sound {
    double volume = 0.5;  ///< 0 (no sound) .. 1.
  } sound;
  struct Access {
    /// s to hold a finger or a key to start speech, 1..10; 0: never. Holding twice as long also
    /// turns on the one switch.
    double hold_to_speak = 3.0;
  } access;
  struct Phone {
    std::string
        address;  ///< Where phones reach onggi-console, "http://192.168.4.1:8080"; "": not at all.
    double hours = 24;     ///< Hours that a visitor's page stays available, 1..720.
    std::string network;   ///< Name of the kiosk's own access point, 32 bytes; "": none.
    std::string password;  ///< Its password, 8..63 printable letters; "": none.
  } phone;
  Hours hours;          ///< [hours]: the museum's opening hours.
  ReaderLimits reader;  ///< [reader]: limits for a vessel's file.
  /// What the languages' files say of vessels, glazes, steps and missions. read_exhibit() leaves it
  /// empty; content::read_translations() reads it.
  Translations translations;
};

/// All problems; empty if there are none. Each has file:line:column, meaning and remedy, and names
/// the nearest right key. In file order.
using Problems = std::vector<Problem>;

struct ExhibitRead {
  Exhibit exhibit;
  Problems problems;
  int keys_checked = 0;
};

/// Reads an exhibit, and checks that it has settings at all, and that the shelf, the scene and (if
/// `language_folder` is given) a <code>.toml for every language exist. On problems, `exhibit` holds
/// every valid value and defaults elsewhere, so that the kiosk can open.
ExhibitRead read_exhibit(const std::filesystem::path& file,
                         const std::filesystem::path& language_folder = {});

}  // namespace onggi::settings
