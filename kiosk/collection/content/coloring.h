#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "kiosk/collection/textures/texture_pixels.h"

namespace onggi::content {

/// Colour of a vessel without colours of its own: fired clay, linear.
inline constexpr std::array<float, 3> kClayColor{0.62f, 0.44f, 0.31f};

/// The colours of a scan, beside its mesh. Empty if it has one colour or none.
struct Coloring {
  enum class Wrap : std::uint8_t { repeat, clamp, mirror };
  struct Picture {
    std::shared_ptr<const textures::TexturePixels> pixels;
    Wrap across = Wrap::repeat, down = Wrap::repeat;
  };
  std::vector<Picture> pictures;  ///< At most 255.
  /// Of each position: its colour, sRGB, which is also laid over its picture (as light times
  /// light);
  std::vector<std::array<std::uint8_t, 3>> colors;
  /// where it lies in the picture, (0, 0) the first pixel's outer corner, y down, 1 the whole side;
  std::vector<std::array<float, 2>> places;
  /// and in which: 0 none, else 1 + its place in `pictures`. A triangle's corners name the same.
  /// Both may be empty: no picture at all.
  std::vector<std::uint8_t> picture;

  bool empty() const { return colors.empty(); }
  /// The colouring of a run of the positions.
  Coloring part(std::size_t first, std::size_t count) const;
};

/// The colour at every position as linear light, 0..1, from the nearest pixel of a picture: what a
/// mesh without pictures can carry. Empty if `coloring` is.
std::vector<std::array<float, 3>> baked(const Coloring& coloring);

/// sRGB of linear light, clamped to 0..1, and back (IEC 61966-2-1).
std::uint8_t display_of(float light);
float light_of(std::uint8_t display);

}  // namespace onggi::content
