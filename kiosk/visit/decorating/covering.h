#pragma once

#include <cstddef>
#include <vector>

#include "engine/surface/laws.h"

namespace onggi::decorating {

/// m at the foot that no dip covers: glaze would stick to the shelf.
inline constexpr double kBareFoot = 0.005;

/// A way from station `from` on as strokes of at most `piece` steps, each for its frame.
std::vector<surface::Stroke> in_pieces(const surface::Tool& tool,
                                       const std::vector<surface::Station>& stations,
                                       std::size_t from, std::size_t piece);

/// The strokes, each for its frame, by which `tool` covers a pot from the foot up to `end`, m along
/// the outline: a dip rises to `end_of_outline` whatever `end` is, all others go round and round.
/// Allocates.
std::vector<surface::Stroke> covering(const surface::Surface& surface, const surface::Tool& tool,
                                      double end, double end_of_outline);

}  // namespace onggi::decorating
