#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/math/vec.h"
#include "kiosk/ground/toml/toml_reader.h"

namespace onggi::decoration {

/// A figure that is set on a pot. x: to the right as seen from outside, y: up; 1 is the figure's
/// height as a step sets it (size_mm). Its middle is (0, 0).
struct Motif {
  std::vector<std::vector<Vec2>> fills;  ///< Corners of areas, each painted whole.
  std::vector<std::vector<Vec2>> lines;  ///< Ways of a brush or a cutting tool.

  /// The points that a file has of them, through which they are smooth.
  struct Drawn {
    using Way = std::vector<toml::OutlinePoint>;
    std::vector<Way> fills, lines;
    friend bool operator==(const Drawn&, const Drawn&) = default;
  };
  std::string id = {};
  Drawn drawn = {};
};

/// Of an area or a line of a file.
inline constexpr std::size_t kMostPoints = 500;

/// The motif that a file with these points has. Each area has 3 to kMostPoints, each line 2 to
/// kMostPoints. Allocates.
Motif motif_of(std::string id, Motif::Drawn drawn);

/// Reads the table [motif.ID]: its areas and lines. Notes what is wrong, and leaves that out.
Motif read_motif(toml::TomlReader::Table& table, const std::string& id);

/// Reads a text that must be there and say something; `remedy` for a Problem of either.
void read_source(toml::TomlReader::Table& table, const char* key, const char* remedy,
                 std::string& out);

/// A length in `unit`s of m, 1e-3 or 1e-6, under `key`; `low` and `high` are in that unit, too.
bool read_length(toml::TomlReader::Table& table, const std::string& key, double unit, double low,
                 double high, double& out);

/// A way through `points` that is smooth but at corners (Catmull and Rom 1974), eight links from
/// each point to the next; `closed`: from the last back to the first. Allocates.
std::vector<Vec2> smooth(const std::vector<toml::OutlinePoint>& points, bool closed);

}  // namespace onggi::decoration
