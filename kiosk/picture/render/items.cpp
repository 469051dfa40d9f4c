#include "kiosk/picture/render/items.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "kiosk/picture/render/changed_part.h"
#include "kiosk/picture/render/shaders.h"

namespace onggi::render {
namespace {

constexpr std::size_t kFlat = 0, kPicture = 1;  // MODE of item.glsl

}  // namespace

Result<std::unique_ptr<ItemPainter>> ItemPainter::create() {
  std::unique_ptr<ItemPainter> painter(new ItemPainter);
  for (std::size_t mode = 0; mode < painter->programs_.size(); ++mode) {
    const std::string which = "#define MODE " + std::to_string(mode) + "\n";
    auto program = Program::create("item", {which.c_str(), k_common_glsl, k_item_glsl});
    if (!program) return tl::unexpected(program.error());
    painter->programs_[mode] = std::move(*program);
  }
  painter->no_text_ = Texture::create(GL_R8, 1, 1, GL_RED, GL_UNSIGNED_BYTE, nullptr);
  GLuint name = 0;
  glGenVertexArrays(1, &name);
  painter->array_ = ArrayName(name);
  calls::bind_array(name);
  glGenBuffers(1, &name);
  painter->vertices_ = BufferName(name);
  glBindBuffer(GL_ARRAY_BUFFER, name);
  glGenBuffers(1, &name);
  painter->indices_ = BufferName(name);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, name);
  const auto attribute = [](GLuint at, int size, GLenum type, std::size_t offset) {
    glEnableVertexAttribArray(at);
    glVertexAttribPointer(at, size, type, type == GL_UNSIGNED_BYTE ? GL_TRUE : GL_FALSE,
                          sizeof(ItemVertex), reinterpret_cast<const void*>(offset));
  };
  attribute(0, 2, GL_FLOAT, offsetof(ItemVertex, at));
  attribute(1, 2, GL_FLOAT, offsetof(ItemVertex, own));
  attribute(2, 4, GL_UNSIGNED_BYTE, offsetof(ItemVertex, fill));
  attribute(3, 4, GL_UNSIGNED_BYTE, offsetof(ItemVertex, border_fill));
  attribute(4, 4, GL_FLOAT, offsetof(ItemVertex, shape));
  return painter;
}

void ItemPainter::begin(int width, int height) {
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  size_ = glm::vec2(width, height);
  strips_.clear();
  runs_.clear();
}

void ItemPainter::go_on(bool picture, std::uint64_t name) {
  if (!runs_.empty() && runs_.back().picture == picture) {
    Run& run = runs_.back();
    if (run.name == name || (!picture && name == 0)) return;
    if (!picture && run.name == 0) {
      run.name = name;
      return;
    }
  }
  runs_.push_back({picture, name, strips_.indices.size()});
}

void ItemPainter::add(const view::Item& item, const Pictures& pictures) {
  if (const auto* box = std::get_if<view::Box>(&item)) {
    go_on(false, 0);
    strips_.add(*box);
  } else if (const auto* text = std::get_if<view::Text>(&item)) {
    add_text(*text);
  } else if (const auto* line = std::get_if<view::Line>(&item)) {
    go_on(false, 0);
    strips_.add(*line);
  } else if (const auto* picture = std::get_if<view::Picture>(&item)) {
    const auto found = pictures.find(picture->id);
    if (found != pictures.end()) add_picture(*picture, found->second);
  }
}

void ItemPainter::add_text(const view::Text& text) {
  if (text.text.empty()) return;
  const Typesetter::Block& block = typesetter_.set(text.text, text.style, text.box.w);
  if (block.height > text.box.h + 1.0f || (text.box.w > 0 && block.width > text.box.w + 1.0f)) {
    ++overflows_;
    last_overflow_ = text.text;
  }
  if (block.w == 0) return;
  go_on(false, block.mask.page);
  strips_.add_mask({std::round(text.box.x) + static_cast<float>(block.x),
                    std::round(text.box.y) + static_cast<float>(block.y),
                    static_cast<float>(block.w), static_cast<float>(block.h)},
                   block.mask.x, block.mask.y, text.color);
}

void ItemPainter::add_picture(const view::Picture& picture, const Stored& stored) {
  const Texture& texture = stored.texture;
  const float w = static_cast<float>(texture.width), h = static_cast<float>(texture.height);
  const float fit = std::min(picture.box.w / w, picture.box.h / h);
  view::Rect at{picture.box.x + 0.5f * (picture.box.w - w * fit),
                picture.box.y + 0.5f * (picture.box.h - h * fit), w * fit, h * fit};
  at.x = std::round(at.x);
  at.y = std::round(at.y);
  go_on(true, picture.id);
  strips_.add_picture(at, stored.bottom_up ? glm::vec4(0, 1, 1, -1) : glm::vec4(0, 0, 1, 1),
                      picture.opacity);
}

void ItemPainter::upload() {
  calls::bind_array(array_.get());
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.get());
  upload_difference(GL_ARRAY_BUFFER, uploaded_.vertices, strips_.vertices, room_);
  upload_difference(GL_ELEMENT_ARRAY_BUFFER, uploaded_.indices, strips_.indices, index_room_);
}

void ItemPainter::draw(const std::vector<view::Item>& items, const Pictures& pictures, int width,
                       int height) {
  begin(width, height);
  for (const view::Item& item : items) add(item, pictures);
  if (!strips_.indices.empty()) upload();
  for (std::size_t n = 0; n < runs_.size(); ++n) {
    const Run& run = runs_[n];
    const std::size_t end = n + 1 < runs_.size() ? runs_[n + 1].first : strips_.indices.size();
    if (end == run.first) continue;
    const Program& program = programs_[run.picture ? kPicture : kFlat];
    program.use();
    program.set("size", size_);
    program.set("image", 0);
    if (run.picture)
      pictures.at(static_cast<view::PictureId>(run.name)).texture.bind(0);
    else if (run.name != 0)
      typesetter_.masks().use(static_cast<std::uint32_t>(run.name)).bind(0);
    else  // the target's own texture may still be bound there
      no_text_.bind(0);
    calls::draw_elements(GL_TRIANGLE_STRIP, static_cast<GLsizei>(end - run.first), GL_UNSIGNED_INT,
                         run.first);
  }
  typesetter_.masks().end_of_use();
}

void ItemPainter::draw_layer(const Texture& layer, float opacity, int width, int height) {
  begin(width, height);
  // Targets store rows from the bottom.
  strips_.add_picture({0, 0, static_cast<float>(width), static_cast<float>(height)}, {0, 1, 1, -1},
                      opacity);
  upload();
  const Program& program = programs_[kPicture];
  program.use();
  program.set("size", size_);
  program.set("image", 0);
  layer.bind(0);
  calls::draw_elements(GL_TRIANGLE_STRIP, static_cast<GLsizei>(strips_.indices.size()),
                       GL_UNSIGNED_INT, 0);
}

}  // namespace onggi::render
