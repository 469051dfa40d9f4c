#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/surface/cut.h"
#include "kiosk/collection/decoration/motif.h"

namespace onggi::decoration {

/// Slip, gloss or oxide as it looks after the fire.
struct Pigment {
  std::string id;
  std::array<float, 3> color{};  ///< Linear.
  double hides = 5e-5;           ///< The coat that hides 63 % of what lies below, m.
};

/// What smoke leaves in the clay, linear.
inline constexpr std::array<float, 3> kCarbon{0.022f, 0.019f, 0.017f};

/// One thing that the makers did, in their order. Lengths are those of the real vessel.
struct Step {
  enum Kind { coat, band, paint, cut, wipe, resist, smoke, burnish, scrape, stamp, coil };

  Kind kind = coat;
  bool inside = false;
  bool zone = false;  ///< Burnish: all from `from` to `to`; else at `at`.
  /// Shares of the side's outline: outside from the foot (0) to the lip (1), inside from the middle
  /// of the floor to the lip.
  double from = 0.0, to = 1.0, at = 0.5;
  int pigment = 0;          ///< In Decoration::pigments, or kGlaze.
  double thickness = 1e-4;  ///< Of a coat or of paint, m; it does not scale.
  double width = 0.002;     ///< Of a band, a line or a finger, m.
  double fill = 0.0;        ///< Of a hollow, the share that a band or a line of paint fills.
  double load = 0.0;        ///< The way of a full brush, m; 0: it never runs dry.
  double depth = 5e-4;      ///< Of a cut or a stamp, m.
  double height = 0.002;    ///< Of a coil, m.
  int marks = 60;           ///< Of the fingernail on a coil, once round.
  surface::CutDef::Section section = surface::CutDef::v;
  int teeth = 1;                        ///< Of a cut, side by side, and
  double spacing = 2e-3;                ///< from one to the next, m.
  double soft = 0.012, wander = 0.010;  ///< Of smoke's edge, m,
  int seed = 1;                         ///< and how it wanders.
  Motif motif;                          ///< None: once round the pot.
  double size = 0.02;                   ///< Height of a motif, m.
  int repeat = 1;
  double turn = 0.0;  ///< Of the first one, round the pot, 0..1.
  std::string says;   ///< What was done, in a sentence.
};
inline constexpr int kGlaze = -1;

/// As a file has them: by Step::Kind, and by surface::CutDef::Section without `sunk`.
inline constexpr std::array<std::string_view, 11> kKindNames{"coat",   "band",   "paint", "cut",
                                                             "wipe",   "resist", "smoke", "burnish",
                                                             "scrape", "stamp",  "coil"};
inline constexpr std::array<std::string_view, 3> kSectionNames{"v", "u", "flat"};

/// Of a decoration.toml.
inline constexpr std::size_t kMostSteps = 2000;

/// A decoration.toml: how a vessel was decorated (kiosk/docs/decorate_a_vessel.md).
struct Decoration {
  std::array<float, 3> body{};   ///< The fired clay, linear.
  std::array<float, 3> glaze{};  ///< What 0.4 mm of glaze lets through, linear.
  std::vector<Pigment> pigments;
  std::vector<Step> steps;
  std::string sources, simplified, checked_by;
};

/// A decoration and everything found wrong with it; use it only where `problems` is empty.
struct DecorationRead {
  Decoration decoration;
  std::vector<Problem> problems;  ///< With file, line and column.
  int keys_checked = 0;
};
DecorationRead check_decoration(const std::filesystem::path& toml);

/// The decoration, or the first Problem of check_decoration().
Result<Decoration> read_decoration(const std::filesystem::path& toml);

}  // namespace onggi::decoration
