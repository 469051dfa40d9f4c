#pragma once

#include <cstddef>
#include <ctime>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/profile/mesh.h"
#include "kiosk/ground/files/wall_clock.h"
#include "kiosk/keepsake/souvenir/small_pot.h"
#include "kiosk/picture/encoding/encode.h"
#include "kiosk/picture/view/image.h"

namespace onggi::souvenir {

/// The way to a keepsake by phone, before anybody may go it.
struct ByPhone {
  std::string token;     ///< Passes::new_token(); in the code on `card`.
  double hours = 24.0;   ///< That it is good for.
  std::string language;  ///< Code of the visit's.
  view::Image card;      ///< The postcard with the code, for the printer.
};

/// Everything a visitor takes home from one visit.
struct Keepsake {
  /// The visit's folder: "2026-05-04_141503_" and the vessel's id. What no file name should hold
  /// becomes '_'; a name that is taken gets "_2", "_3"...
  std::string name;
  view::Image postcard;  ///< 1500 x 2100; without a code of the visitor's own page.
  encoding::Caption caption;
  std::vector<std::byte> glb;     ///< Made by content::write_glb.
  TriangleMesh pot;               ///< For the STL, metres (written in millimetres).
  std::vector<std::byte> replay;  ///< May be empty.
  /// For the gallery of the day's pots; absent: it is not shown there.
  std::optional<SmallPot> small{};
  std::optional<ByPhone> phone{};  ///< Nothing: no phone reaches it.
};

/// Where they lie. A path is empty where there was nothing to write.
struct KeepsakeFiles {
  std::filesystem::path folder;
  std::filesystem::path png, jpeg, glb, stl, replay;
  std::string token{};  ///< Of the pass that was given; "": a phone cannot fetch it.
};

/// What a folder of keepsakes may hold. What goes is said at tidy().
struct KeepsakeLimits {
  int quota_mb = 0;  ///< MB of 10^6 bytes; the oldest go beyond it.
  int days = 0;      ///< After which a visit goes, by the date in its name (tidy()); 0: never.
};

/// Writes `<folder>/<name>/{postcard.png,postcard.jpg,pot.glb,pot.stl,visit.onggi}` and, for the
/// gallery, small.jpg and pot.txt, then
/// tidies, never removing the one just written (what tidy() has to say waits for the next one that
/// is asked for). A visit is whole or absent, whenever the power goes: it is written as
/// `<name>.partial` and renamed. Nothing is ever removed but folders that save() wrote. On a
/// Problem (exit 1) nothing half-written is left. Blocks (worker thread); not two at once for the
/// same folder. With `keepsake.phone` its pass is given before the folder is whole, and is good
/// from then on. Only then has postcard.png the code: the way is there, or no code is.
/// postcard.jpg, which goes to the phone and from there to anybody, never has it: who has the code
/// may delete.
Result<KeepsakeFiles> save(const Keepsake& keepsake, const std::filesystem::path& folder,
                           const KeepsakeLimits& limits);

/// Removes from `folder` the visits that are older than `limits.days`, then the oldest until the
/// rest is within the quota, but never the one named `keep`; the days of one dated before there was
/// an onggi, by a clock that was years back, count from the first tidying by a clock that is right;
/// and what a power cut left of visits more than an hour ago. A visit is a folder whose name begins
/// with a date and time and that holds nothing but save()'s files; all else stays. A folder that is
/// not there is tidy. After a clock leapt ahead by over a year (files::clock_leapt) nothing goes by
/// its days for a day. `now`: s since 1970. Problem, exit 1: a visit that was to go is still there;
/// the first of them, and the others were tried. Blocks, as save() does.
Result<void> tidy(const std::filesystem::path& folder, const KeepsakeLimits& limits,
                  const std::string& keep = {}, std::time_t now = files::wall_now());

}  // namespace onggi::souvenir
