#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/surface/laws.h"
#include "kiosk/collection/decoration/coat_picture.h"
#include "kiosk/collection/decoration/motif.h"

namespace onggi::decoration {

/// Words by language code.
using Words = std::map<std::string, std::string>;

/// A tool in a visitor's hand.
struct WayTool {
  /// How it is led: along the finger's own way, as a figure set where it touches, once round the
  /// turning pot, all over at a button, or from the touched height on.
  enum Hand { line, figure, ring, all, up };

  /// What a pot goes through, in this order.
  enum State { soft, leather, dry, fired, glazed };

  std::string id;
  Hand hand = line;
  /// The clay is at least so far; absent: the tool does not mind.
  std::optional<State> state;
  /// Its law with all its figures; pigment or coat is that of `pigments.front()`.
  surface::Tool law;
  std::vector<int> pigments;  ///< To choose from, in Way::pigments; none where it lays no slip.
  std::vector<int> motifs;    ///< Of a figure, in Way::motifs.
  double size = 0.03;         ///< Height of a figure, m.
  int repeats = 8;            ///< Round the pot, to begin with.
  bool more = false;          ///< Stands behind the button *More*.
  int needs = -1;  ///< The tool that must have been used before, in Way::tools; -1: none.
  Words name, how, did;
};

/// How visitors may decorate a pot: the pigments, figures and tools of some potters.
struct Way {
  struct Pigment {
    std::string id;
    Words name;
  };
  struct Figure {
    std::string id;
    Motif motif;
    Words name;
  };
  std::string id;  ///< The file's name without ".toml".
  Words name, about;
  std::string sources, simplified;
  Palette palette;                ///< In the order of
  std::vector<Pigment> pigments;  ///< these.
  std::vector<Figure> figures;
  std::vector<WayTool> tools;  ///< In the makers' order; at least one.
};

/// Tools that are shown at once, and as many more behind a button.
inline constexpr std::size_t kMostTools = 6, kMostMore = 6, kMostFigures = 5;
/// Cells across the picture of a stamp, which a tool's law gets with its figure.
inline constexpr int kStampSide = 64;
/// The repeats that a visitor may choose. Free strokes are never fewer.
inline constexpr int kRepeats[] = {5, 8, 10, 12};

/// A way and everything wrong with its file, with line and column; use it only where `problems` is
/// empty. Each text is needed in all `languages`.
struct WayRead {
  Way way;
  std::vector<Problem> problems;
  int keys_checked = 0;
};
WayRead read_way(const std::filesystem::path& toml, const std::vector<std::string>& languages);

}  // namespace onggi::decoration
