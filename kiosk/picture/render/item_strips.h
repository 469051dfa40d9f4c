#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "kiosk/picture/view/frame.h"

namespace onggi::render {

/// A corner of a flat item. Colours premultiplied, 8 bits a channel.
struct ItemVertex {
  glm::vec2 at;   ///< Pixels from the top left.
  glm::vec2 own;  ///< Depends on the item: from a box's middle; across a line; texels of a mask;
                  ///< share of a picture.
  std::array<std::uint8_t, 4> fill{}, border_fill{};
  /// Half width, half height, radius and border of a box (a line is a box without ends). Negative
  /// border: `own` reads a mask.
  glm::vec4 shape{0.0f};
  friend bool operator==(const ItemVertex&, const ItemVertex&) = default;
};

/// Flat items as one sequence of triangle strips, joined by degenerate triangles, so that a run of
/// them is one draw call. Plain numbers.
struct ItemStrips {
  std::vector<ItemVertex> vertices;
  std::vector<std::uint32_t> indices;

  void clear();
  void add(const view::Box& box);
  void add(const view::Line& line);
  /// Texels from (x, y) of a mask, as many as `rect` has pixels, in `color`.
  void add_mask(const view::Rect& rect, int x, int y, view::Color color);
  /// The `part` of a picture (x, y, w, h, shares of it) in `rect`.
  void add_picture(const view::Rect& rect, glm::vec4 part, float opacity);

 private:
  /// The corners must be in zigzag order.
  void join(std::size_t from);
  void quad(const view::Rect& rect, glm::vec4 own, ItemVertex corner);
};

}  // namespace onggi::render
