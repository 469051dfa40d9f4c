#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/scene/scene_def.h"

namespace onggi::settings {

/// One exhibit, as config/exhibit.toml writes it. Every default stands here.
struct Exhibit {
  std::filesystem::path file;  ///< Where it was read.
  std::map<std::string, std::string> title{{"en", "Throw a pot"},
                                           {"ko", "도자기 빚기"}};  ///< By language.
  std::string credit = "Onggi";                                     ///< Printed on the keepsake.
  std::vector<std::string> languages{"en", "ko"};                   ///< First is the default.
  struct Idle {
    double warn_after = 60.0;     ///< s without input before "are you still there?", 20..3600.
    double countdown = 25.0;      ///< s shown counting down, 20..300.
    double result_after = 120.0;  ///< s on result and keepsake before the warning, 20..3600.
  } idle;
  std::filesystem::path
      shelf;  ///< Folder of vessels; relative to the file's folder. content/vessels.
  std::filesystem::path scene;  ///< TOML of the scene; config/scenes/first_touch.toml.
  struct Keepsake {
    std::filesystem::path
        folder;           ///< Where postcards go; relative to the file's folder. keepsakes.
    int quota_mb = 2000;  ///< Oldest visits are removed beyond this, 10..1000000.
  } keepsake;
  struct Screen {
    double viewing_distance_mm = 600;  ///< 200..5000.
    double diagonal_mm = 600;          ///< 100..5000.
    bool reduced_motion = false;
    bool left_handed = false;  ///< Mirrors the layout and the wheel.
    double force = 1.0;        ///< 0 (off) .. 1 of the device's cap.
  } screen;
};

/// Everything found wrong; empty is good. Each has file:line:column, meaning, remedy, and names the
/// nearest right key where one is close.
using Problems = std::vector<Problem>;

/// Reads an exhibit. On problems, `exhibit` still holds every value that was good (defaults
/// elsewhere).
struct ExhibitRead {
  Exhibit exhibit;
  Problems problems;
  int keys_checked = 0;
};
ExhibitRead read_exhibit(const std::filesystem::path& file);

struct SceneRead {
  SceneDef def;
  Problems problems;
  int keys_checked = 0;
};
SceneRead read_scene(const std::filesystem::path& file);

}  // namespace onggi::settings
