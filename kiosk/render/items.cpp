#include "kiosk/render/items.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "kiosk/render/shaders.h"

namespace onggi::render {
namespace {

enum Mode { kBox = 0, kMask = 1, kPicture = 2, kLine = 3 };

glm::vec4 premultiplied(view::Color c) { return {c.r * c.a, c.g * c.a, c.b * c.a, c.a}; }
glm::vec4 as_vec(const view::Rect& r) { return {r.x, r.y, r.w, r.h}; }

struct LineVertex {
  glm::vec2 at;
  glm::vec4 tint;
  float across;
};

// A strip along the points, mitred at the corners and half a pixel longer at both ends. The strip
// is wider than the line by a pixel, over which the shader fades it.
std::vector<LineVertex> strip_of(const view::Line& line) {
  std::vector<glm::vec2> p;
  std::vector<glm::vec4> tint;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const glm::vec2 at(line.points[i].first, line.points[i].second);
    if (!p.empty() && glm::length(at - p.back()) < 0.01f) continue;
    p.push_back(at);
    const view::Color c = line.colors.empty()      ? view::Color{0, 0, 0, 1}
                          : line.colors.size() > i ? line.colors[i]
                                                   : line.colors.front();
    tint.push_back(premultiplied(c));
  }
  std::vector<LineVertex> out;
  if (p.size() < 2) return out;
  const float half = 0.5f * line.width + 1.0f;
  const bool closed = p.size() > 3 && glm::length(p.front() - p.back()) < 0.5f;
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i) {
    const bool first = i == 0, last = i + 1 == n;
    glm::vec2 in = first ? (closed ? p[0] - p[n - 2] : p[1] - p[0]) : p[i] - p[i - 1];
    glm::vec2 on = last ? (closed ? p[1] - p[0] : in) : p[i + 1] - p[i];
    in = glm::normalize(in);
    on = glm::normalize(on);
    const glm::vec2 normal_in(-in.y, in.x), normal_on(-on.y, on.x);
    glm::vec2 miter = normal_in + normal_on;
    const float length = glm::length(miter);
    miter = length < 0.2f ? normal_in : miter / length;
    const float stretch = 1.0f / std::max(glm::dot(miter, normal_in), 0.4f);
    glm::vec2 at = p[i];
    if (!closed && first) at -= on * 0.5f;
    if (!closed && last) at += in * 0.5f;
    out.push_back({at + miter * (half * stretch), tint[i], half});
    out.push_back({at - miter * (half * stretch), tint[i], -half});
  }
  return out;
}

}  // namespace

Result<std::unique_ptr<ItemPainter>> ItemPainter::create() {
  std::unique_ptr<ItemPainter> painter(new ItemPainter);
  for (std::size_t mode = 0; mode < painter->programs_.size(); ++mode) {
    const std::string which = "#define MODE " + std::to_string(mode) + "\n";
    auto program = Program::create("item", {which.c_str(), k_common_glsl, k_item_glsl});
    if (!program) return tl::unexpected(program.error());
    painter->programs_[mode] = std::move(*program);
  }
  painter->quad_ = unit_grid(1, 1);
  GLuint name = 0;
  glGenVertexArrays(1, &name);
  painter->line_array_ = ArrayName(name);
  calls::bind_array(name);
  glGenBuffers(1, &name);
  painter->line_vertices_ = BufferName(name);
  glBindBuffer(GL_ARRAY_BUFFER, name);
  const auto attribute = [](GLuint at, int size, std::size_t offset) {
    glEnableVertexAttribArray(at);
    glVertexAttribPointer(at, size, GL_FLOAT, GL_FALSE, sizeof(LineVertex),
                          reinterpret_cast<const void*>(offset));
  };
  attribute(0, 2, offsetof(LineVertex, at));
  attribute(1, 4, offsetof(LineVertex, tint));
  attribute(2, 1, offsetof(LineVertex, across));
  return painter;
}

void ItemPainter::begin(int width, int height) {
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  size_ = glm::vec2(width, height);
}

const Program& ItemPainter::use(int mode) const {
  const Program& program = programs_[static_cast<std::size_t>(mode)];
  program.use();
  program.set("size", size_);
  program.set("image", 0);
  return program;
}

void ItemPainter::draw(const view::Item& item, const Pictures& pictures) {
  if (const auto* box = std::get_if<view::Box>(&item)) {
    draw_box(*box);
  } else if (const auto* text = std::get_if<view::Text>(&item)) {
    draw_text(*text);
  } else if (const auto* line = std::get_if<view::Line>(&item)) {
    draw_line(*line);
  } else if (const auto* picture = std::get_if<view::Picture>(&item)) {
    const auto found = pictures.find(picture->id);
    if (found != pictures.end()) draw_picture(*picture, found->second);
  }
}

void ItemPainter::draw_box(const view::Box& box) {
  if (box.rect.w <= 0 || box.rect.h <= 0) return;
  const Program& program = use(kBox);
  program.set("rect", as_vec(box.rect));
  program.set("fill", premultiplied(box.fill));
  program.set("border_fill", premultiplied(box.border_color));
  program.set("radius", box.radius);
  program.set("border", box.border);
  quad_.draw();
}

void ItemPainter::draw_text(const view::Text& text) {
  if (text.text.empty()) return;
  const Typesetter::Block& block = typesetter_.set(text.text, text.style, text.box.w);
  if (block.height > text.box.h + 1.0f || (text.box.w > 0 && block.width > text.box.w + 1.0f)) {
    ++overflows_;
    last_overflow_ = text.text;
  }
  const auto pad = static_cast<float>(block.pad);
  const Program& program = use(kMask);
  program.set("rect", glm::vec4(std::round(text.box.x) - pad, std::round(text.box.y) - pad,
                                block.mask.width, block.mask.height));
  program.set("fill", premultiplied(text.color));
  block.mask.bind(0);
  quad_.draw();
}

void ItemPainter::draw_line(const view::Line& line) {
  const std::vector<LineVertex> strip = strip_of(line);
  if (strip.empty()) return;
  const Program& program = use(kLine);
  program.set("radius", 0.5f * line.width);
  calls::bind_array(line_array_.get());
  glBindBuffer(GL_ARRAY_BUFFER, line_vertices_.get());
  calls::buffer_data(GL_ARRAY_BUFFER, strip.size() * sizeof(LineVertex), strip.data(),
                     GL_STREAM_DRAW);
  calls::draw_arrays(GL_TRIANGLE_STRIP, 0, static_cast<GLsizei>(strip.size()));
}

void ItemPainter::draw_picture(const view::Picture& picture, const Stored& stored) {
  const Texture& texture = stored.texture;
  const float w = static_cast<float>(texture.width), h = static_cast<float>(texture.height);
  const float fit = std::min(picture.box.w / w, picture.box.h / h);
  view::Rect at{picture.box.x + 0.5f * (picture.box.w - w * fit),
                picture.box.y + 0.5f * (picture.box.h - h * fit), w * fit, h * fit};
  at.x = std::round(at.x);
  at.y = std::round(at.y);
  const Program& program = use(kPicture);
  program.set("rect", as_vec(at));
  program.set("part", stored.bottom_up ? glm::vec4(0, 1, 1, -1) : glm::vec4(0, 0, 1, 1));
  program.set("opacity", picture.opacity);
  texture.bind(0);
  quad_.draw();
}

void ItemPainter::draw_layer(const Texture& layer, const view::Rect& rect, glm::vec4 part,
                             float opacity) {
  const Program& program = use(kPicture);
  program.set("rect", as_vec(rect));
  // Targets keep their rows from the bottom.
  program.set("part", glm::vec4(part.x, 1.0f - part.y, part.z, -part.w));
  program.set("opacity", opacity);
  layer.bind(0);
  quad_.draw();
}

}  // namespace onggi::render
