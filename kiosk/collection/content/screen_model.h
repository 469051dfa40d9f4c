#pragma once

#include <cstddef>

#include "engine/profile/mesh.h"
#include "kiosk/collection/content/coloring.h"

namespace onggi::content {

/// What of a vessel's surface is kept for the screen. A frame makes the picture for its card, or
/// the turning one, and 0.5 s is the longest that a frame may take on a machine without a GPU. As
/// fine as a card's pixels: 480 x 600.
inline constexpr std::size_t kScreenTriangles = 200'000;
/// Of all its pictures together.
inline constexpr std::size_t kScreenPixels = std::size_t{2048} * 2048;

/// Reduces a surface to that, and drops positions that no triangle has. A surface within it stays
/// as it is, to the bit. Where triangles must cross the seams of its pictures, each corner gets its
/// picture's colour instead. Allocates; any thread; about 0.5 s a million triangles.
void fit_to_screen(TriangleMesh& mesh, Coloring& coloring);

}  // namespace onggi::content
