#pragma once

#include <cstddef>
#include <ctime>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/ground/files/wall_clock.h"
#include "kiosk/keepsake/souvenir/small_pot.h"
#include "kiosk/picture/encoding/encode.h"
#include "kiosk/picture/view/image.h"

namespace onggi::souvenir {

/// Access to a keepsake by phone, before it is open.
struct ByPhone {
  std::string token;     ///< Passes::new_token(); in the code on `card`.
  double hours = 24.0;   ///< Hours that it is valid.
  std::string language;  ///< Language code of the visit.
  view::Image card;      ///< The postcard with the code, for the desk's printer.
};

/// What a decorated pot has besides.
struct Painted {
  view::Image skin;       ///< All of its surface, unrolled, for its model,
  view::Image roughness;  ///< and how rough it is there.
  view::Image rollout;    ///< The outside as it is seen, unrolled.
  /// JPEGs.
  struct Pictures {
    std::vector<std::byte> skin, roughness, normals;
  };
  // Called on the worker thread, in this order.
  std::function<view::Image()> normals;  ///< Of its surface: where it faces.
  std::function<std::vector<std::byte>(Pictures pictures)> model;  ///< The GLB.
  /// What its STL is made of: relief_file() for that GLB.
  std::function<std::vector<std::byte>(std::span<const std::byte> model)> relief;
  /// It drawn on a page; `spoken`: Keepsake's.
  std::function<view::Image(const std::string& spoken)> sheet;
};

/// All files that a visitor gets from one visit.
struct Keepsake {
  /// The visit's folder: "2026-05-04_141503_" and the vessel's id. Characters that do not belong in
  /// a file name become '_'; a name that exists gets "_2", "_3"...
  std::string name;
  view::Image postcard;  ///< 1500 x 2100; without the code of the visitor's page.
  encoding::Caption caption;
  std::vector<std::byte> glb;     ///< Made by content::write_glb; empty if it is `painted`.
  std::vector<std::byte> replay;  ///< May be empty.
  std::string spoken{};           ///< The id of its name (content::KeepsakeNames); "": none.
  /// For the gallery of today's pots; absent: not shown there.
  std::optional<SmallPot> small{};
  std::optional<ByPhone> phone{};  ///< Absent: no phone can fetch it.
  std::optional<Painted> painted{};
};

/// The paths of the files. A path is empty if nothing was written.
struct KeepsakeFiles {
  std::filesystem::path folder;
  std::filesystem::path postcard, print, glb, replay, rollout;
  std::string spoken{};  ///< As Keepsake's.
  std::string token{};   ///< Token of its pass; "": no phone can fetch it.
};

/// Limits of a folder of keepsakes. tidy() says what is removed.
struct KeepsakeLimits {
  int quota_mb = 0;  ///< MB of 10^6 bytes; beyond it the oldest are removed.
  /// Days after which a visit is removed, by the date in its name (tidy()); 0: never.
  int days = 0;
};

/// Writes `<folder>/<name>/{postcard.jpg,pot.glb,visit.onggi,name.txt}`, the replay packed
/// (files::packed()), print.jpg for a phone's visitor, rollout.jpg, sheet.jpg and
/// relief.onggi of a decorated pot, and for the gallery small.jpg and pot.txt. Then it tidies, but
/// never removes the visit just written; Problems of tidy() are dropped here and come back at its
/// next call. A visit is complete or absent even after a power cut, because it is written as
/// `<name>.partial` and then renamed. Only folders that save() wrote are ever removed. On a Problem
/// (exit 1) nothing unfinished is left. Blocks (worker thread); not twice at once for the same
/// folder. With `keepsake.phone` the pass is created just before the folder is complete, and it is
/// valid from then on; print.jpg is written only if the pass exists. postcard.jpg, which goes to
/// the phone and may be passed on, never has the code, because the code allows deleting.
Result<KeepsakeFiles> save(const Keepsake& keepsake, const std::filesystem::path& folder,
                           const KeepsakeLimits& limits);

/// Removes from `folder` the visits that are older than `limits.days`, then the oldest until the
/// rest fits the quota, but never the one named `keep`; also unfinished visits over an hour old,
/// which a power cut left. A visit dated before the first onggi, by a wrong clock, ages from the
/// first tidying with a right clock. A visit is a folder whose name begins with a date and time and
/// that holds only save()'s files; everything else stays. A missing folder counts as tidy. After
/// the clock jumped ahead by over a year (files::clock_jumped), nothing is removed by age for a
/// day. `now`: s since 1970. Problem, exit 1: the first visit that could not be removed; the others
/// were tried too. Blocks, like save().
Result<void> tidy(const std::filesystem::path& folder, const KeepsakeLimits& limits,
                  const std::string& keep = {}, std::time_t now = files::wall_now());

}  // namespace onggi::souvenir
