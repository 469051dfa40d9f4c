#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>

#include "engine/base/result.h"
#include "kiosk/render/gl.h"
#include "kiosk/render/text.h"
#include "kiosk/view/frame.h"

namespace onggi::render {

/// Flat items over the picture: boxes, text, lines, pictures; and whole layers of pixels.
class ItemPainter {
 public:
  static Result<std::unique_ptr<ItemPainter>> create();

  struct Stored {
    Texture texture;         // premultiplied
    bool bottom_up = false;  // drawn by GL, not uploaded
  };
  using Pictures = std::unordered_map<view::PictureId, Stored>;

  /// Starts a run of items for a frame of this size. Sets the blending they need.
  void begin(int width, int height);
  void draw(const view::Item& item, const Pictures& pictures);
  /// A premultiplied layer over `rect`; `part` is the share of the texture to take (x, y, w, h,
  /// from the top left, 0..1) of a target drawn by GL (rows from the bottom).
  void draw_layer(const Texture& layer, const view::Rect& rect, glm::vec4 part, float opacity);

  const Typesetter& typesetter() const { return typesetter_; }
  std::uint64_t text_overflows() const { return overflows_; }
  const std::string& last_overflow() const { return last_overflow_; }

 private:
  ItemPainter() = default;
  void draw_box(const view::Box& box);
  void draw_text(const view::Text& text);
  void draw_line(const view::Line& line);
  void draw_picture(const view::Picture& picture, const Stored& stored);

  const Program& use(int mode) const;

  std::array<Program, 4> programs_;  // by mode
  glm::vec2 size_{1.0f};
  Mesh quad_;
  ArrayName line_array_;
  BufferName line_vertices_;
  Typesetter typesetter_;
  std::uint64_t overflows_ = 0;
  std::string last_overflow_;
};

}  // namespace onggi::render
