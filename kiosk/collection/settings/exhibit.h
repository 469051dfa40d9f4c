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

namespace onggi::settings {

/// One exhibit, as config/exhibit.toml writes it. Every default stands here; config/README.md tells
/// them to curators. A path that is not absolute is taken from the folder that holds the file, and
/// so are the defaults of paths.
struct Exhibit {
  std::filesystem::path file;  ///< Where it was read.
  std::map<std::string, std::string> title{{"en", "Make a pot"},
                                           {"ko", "도자기 빚기"}};  ///< By language.
  std::string credit = "Onggi";                    ///< Printed on the keepsake; 1..120 letters.
  std::vector<std::string> languages{"en", "ko"};  ///< First is the default; 1..12 of them.
  /// What attract mode shows, pot by pot: "follow" a vessel, or a script for an effect
  /// (ScriptInfo::shows), which is left out where a vessel's scene has not that effect. 1..32.
  std::vector<std::string> attract_scripts{"follow",    "centre", "follow",
                                           "pull_tall", "follow", "collapse"};
  struct Idle {
    double warn_after = 60.0;     ///< s without input before "are you still there?", 20..3600.
    double countdown = 25.0;      ///< s shown counting down, 20..300.
    double result_after = 120.0;  ///< s on result and keepsake before the warning, 20..3600.
  } idle;
  std::filesystem::path shelf = "../content/vessels";       ///< Folder of vessels.
  std::filesystem::path scene = "scenes/first_touch.toml";  ///< TOML of the scene.
  /// By a vessel's name on the shelf: the scene in which it is thrown instead.
  std::map<std::string, std::filesystem::path> vessel_scenes;
  std::filesystem::path rubric_file = "rubric.toml";  ///< TOML of the rubric; may be absent.
  Rubric rubric;                                      ///< What it says, or the defaults.
  std::filesystem::path glazes =
      "../content/glazes.toml";  ///< The glazes to choose from; used where the scene has a kiln.
  /// TOML of the lesson of the first minute; nothing where there is none.
  std::optional<std::filesystem::path> lesson;
  /// TOML of the missions that may be chosen before a vessel; nothing where there is none.
  std::optional<std::filesystem::path> missions;
  struct Keepsake {
    std::filesystem::path folder = "../keepsakes";  ///< Where postcards go; made when first needed.
    int quota_mb = 2000;  ///< Oldest visits are removed beyond this, 10..1000000.
    int days = 0;         ///< After which a visit is removed, 1..3650; 0: only beyond the quota.
    bool gallery = true;  ///< Pots kept today are shown to visitors, without a name.
    bool turning = true;  ///< A picture of the pot that turns is kept, too.
  } keepsake;
  struct Store {
    bool count = true;  ///< Visits are counted, beside the keepsakes.
    int months = 36;    ///< After which a visit's count is forgotten, 1..240.
  } store;
  struct Screen {
    double viewing_distance_mm = 600;  ///< Eye to screen, 200..5000.
    double diagonal_mm = 600;          ///< Of the picture, corner to corner, 100..5000.
    double lower_edge_mm = 900;        ///< Floor to the lower edge of the picture, 0..1000.
    // As every visitor finds the exhibit; each may choose otherwise for a visit.
    bool reduced_motion = false;
    bool left_handed = false;    ///< Mirrors the layout and the wheel.
    bool high_contrast = false;  ///< Words 7:1 on what they stand on, heavier lines.
    bool larger_text = false;
    bool low_reach = false;     ///< Everything between 380 and 1,220 mm above the floor.
    bool spoken = false;        ///< What is on the screen is said aloud.
    bool one_switch = false;    ///< Any key, button or touch is the one switch of the visitor,
    double scan_seconds = 1.5;  ///< and this long each thing stands to be chosen, s, 0.5..5.
    bool silent = false;        ///< No sound, whatever [sound] says.
    double force = 1.0;         ///< 0 (off) .. 1 of the device's cap.
  } screen;
  struct Sound {
    double volume = 0.5;  ///< 0 (none is made) .. 1.
  } sound;
  struct Access {
    /// s that a finger or a key is held for what is on the screen to be said aloud, 1..10; 0: it is
    /// not begun so. Held twice as long it is the one switch too.
    double hold_to_speak = 3.0;
  } access;
  struct Phone {
    std::string
        address;  ///< Where phones reach onggi-console, "http://192.168.4.1:8080"; "": nowhere.
    double hours = 24;     ///< That a visitor's page is there, 1..720.
    std::string network;   ///< Name of the kiosk's own access point, 32 bytes; "": there is none.
    std::string password;  ///< Of that, 8..63 printable letters; "": it has none.
  } phone;
  Hours hours;          ///< [hours]: when the museum is open.
  ReaderLimits reader;  ///< [reader]: what is allowed of a vessel's file.
};

/// Everything found wrong; empty is good. Each has file:line:column, meaning, remedy, and names the
/// nearest right key where one is close. In file order.
using Problems = std::vector<Problem>;

struct ExhibitRead {
  Exhibit exhibit;
  Problems problems;
  int keys_checked = 0;
};

/// Reads an exhibit and looks whether the shelf, the scene and (where `language_folder` is given)
/// a <code>.toml for every language are there. On problems, `exhibit` still holds every value that
/// was good, and defaults elsewhere: a visitor's kiosk opens with it.
ExhibitRead read_exhibit(const std::filesystem::path& file,
                         const std::filesystem::path& language_folder = {});

}  // namespace onggi::settings
