#include "kiosk/picture/render/item_strips.h"

#include <algorithm>
#include <cmath>

namespace onggi::render {
namespace {

constexpr float kEndless = 1e6f;

std::array<std::uint8_t, 4> premultiplied(view::Color c) {
  const auto byte = [](float v) {
    return static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(v, 0.0f, 1.0f)));
  };
  return {byte(c.r * c.a), byte(c.g * c.a), byte(c.b * c.a), byte(c.a)};
}

}  // namespace

void ItemStrips::clear() {
  vertices.clear();
  indices.clear();
}

void ItemStrips::join(std::size_t from) {
  const auto first = static_cast<std::uint32_t>(from);
  if (!indices.empty()) {
    indices.push_back(indices.back());
    indices.push_back(first);
  }
  for (std::size_t i = from; i < vertices.size(); ++i)
    indices.push_back(static_cast<std::uint32_t>(i));
}

void ItemStrips::quad(const view::Rect& rect, glm::vec4 own, ItemVertex corner) {
  const std::size_t from = vertices.size();
  for (const auto& [x, y] : {std::pair(0.0f, 0.0f), std::pair(0.0f, 1.0f), std::pair(1.0f, 0.0f),
                             std::pair(1.0f, 1.0f)}) {
    corner.at = {rect.x + x * rect.w, rect.y + y * rect.h};
    corner.own = {own.x + x * own.z, own.y + y * own.w};
    vertices.push_back(corner);
  }
  join(from);
}

void ItemStrips::add(const view::Box& box) {
  if (box.rect.w <= 0 || box.rect.h <= 0) return;
  const float half_w = 0.5f * box.rect.w, half_h = 0.5f * box.rect.h;
  ItemVertex corner;
  corner.fill = premultiplied(box.fill);
  corner.border_fill = premultiplied(box.border_color);
  corner.shape = {half_w, half_h, std::min(box.radius, std::min(half_w, half_h)),
                  std::max(box.border, 0.0f)};
  // One pixel larger all round, where the box fades out.
  quad({box.rect.x - 1, box.rect.y - 1, box.rect.w + 2, box.rect.h + 2},
       {-half_w - 1, -half_h - 1, box.rect.w + 2, box.rect.h + 2}, corner);
}

// A strip along the points, mitred at the corners and half a pixel longer at both ends. It is a
// pixel wider than the line, where the shader fades it out.
void ItemStrips::add(const view::Line& line) {
  std::vector<glm::vec2> p;
  std::vector<view::Color> tint;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const glm::vec2 at(line.points[i].first, line.points[i].second);
    if (!p.empty() && glm::length(at - p.back()) < 0.01f) continue;
    p.push_back(at);
    tint.push_back(line.colors.empty()      ? view::Color{0, 0, 0, 1}
                   : line.colors.size() > i ? line.colors[i]
                                            : line.colors.front());
  }
  if (p.size() < 2) return;
  const std::size_t from = vertices.size();
  const float half = 0.5f * line.width + 1.0f;
  const bool closed = p.size() > 3 && glm::length(p.front() - p.back()) < 0.5f;
  const std::size_t n = p.size();
  ItemVertex corner;
  corner.shape = {kEndless, 0.5f * line.width, 0.0f, 0.0f};
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
    corner.fill = premultiplied(tint[i]);
    for (const float side : {half, -half}) {
      corner.at = at + miter * (side * stretch);
      corner.own = {0.0f, side};
      vertices.push_back(corner);
    }
  }
  join(from);
}

void ItemStrips::add_mask(const view::Rect& rect, int x, int y, view::Color color) {
  ItemVertex corner;
  corner.fill = premultiplied(color);
  corner.shape = {0.0f, 0.0f, 0.0f, -1.0f};
  quad(rect, {x, y, rect.w, rect.h}, corner);
}

void ItemStrips::add_picture(const view::Rect& rect, glm::vec4 part, float opacity) {
  ItemVertex corner;
  corner.fill = premultiplied({1, 1, 1, opacity});
  quad(rect, part, corner);
}

}  // namespace onggi::render
