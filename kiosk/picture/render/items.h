#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/picture/render/gl.h"
#include "kiosk/picture/render/item_strips.h"
#include "kiosk/picture/render/text.h"
#include "kiosk/picture/view/frame.h"

namespace onggi::render {

/// Draws flat items over the picture: boxes, text, lines, pictures. Everything between two pictures
/// is one draw call, and only changed parts of a buffer are uploaded.
class ItemPainter {
 public:
  static Result<std::unique_ptr<ItemPainter>> create();

  struct Stored {
    Texture texture;         // premultiplied
    bool bottom_up = false;  // drawn by GL, not uploaded
  };
  using Pictures = std::unordered_map<view::PictureId, Stored>;

  /// Draws `items` in order into the bound target, which is a frame of this size.
  void draw(const std::vector<view::Item>& items, const Pictures& pictures, int width, int height);
  /// Draws `layer`, premultiplied and made by GL, over the whole target.
  void draw_layer(const Texture& layer, float opacity, int width, int height);

  const Typesetter& typesetter() const { return typesetter_; }
  std::uint64_t text_overflows() const { return overflows_; }
  const std::string& last_overflow() const { return last_overflow_; }

 private:
  ItemPainter() = default;
  /// A range of indices with one texture.
  struct Run {
    bool picture = false;
    std::uint64_t name = 0;  // of the atlas page (0: no text yet), or of the picture
    std::size_t first = 0;   // index
  };
  void add(const view::Item& item, const Pictures& pictures);
  void add_text(const view::Text& text);
  void add_picture(const view::Picture& picture, const Stored& stored);
  /// Continues the run with text of this atlas page (0: items without text), or with this picture.
  void go_on(bool picture, std::uint64_t name);
  void upload();
  void begin(int width, int height);

  std::array<Program, 2> programs_;  // MODE of item.glsl
  ArrayName array_;
  BufferName vertices_, indices_;
  Texture no_text_;
  ItemStrips strips_, uploaded_;
  std::vector<Run> runs_;
  std::size_t room_ = 0, index_room_ = 0;  // capacity of the buffers
  glm::vec2 size_{1.0f};
  Typesetter typesetter_;
  std::uint64_t overflows_ = 0;
  std::string last_overflow_;
};

}  // namespace onggi::render
