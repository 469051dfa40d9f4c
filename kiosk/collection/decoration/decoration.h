#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"
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
  enum Kind { coat, band, paint, cut, wipe, resist, smoke, burnish };

  Kind kind = coat;
  bool inside = false;
  /// Shares of the side's outline: outside from the foot (0) to the lip (1), inside from the middle
  /// of the floor to the lip.
  double from = 0.0, to = 1.0, at = 0.5;
  int pigment = 0;          ///< In Decoration::pigments, or kGlaze.
  double thickness = 1e-4;  ///< Of a coat or of paint, m; it does not scale.
  double width = 0.002;     ///< Of a band, a line or a finger, m.
  double depth = 5e-4;      ///< Of a cut, m.
  bool sunk = false;        ///< A cut that is deep on the left of its way and rises to the right.
  double soft = 0.012, wander = 0.010;  ///< Of smoke's edge, m.
  Motif motif;                          ///< None: once round the pot.
  double size = 0.02;                   ///< Height of a motif, m.
  int repeat = 1;
  double turn = 0.0;  ///< Of the first one, round the pot, 0..1.
  std::string says;   ///< What was done, in a sentence.
};
inline constexpr int kGlaze = -1;

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
