#include "kiosk/render/canvas.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace onggi::render {

view::Rect reach_of(const view::PotView& pot, double height, double radius, int width,
                    int frame_height) {
  // Rings that hold everything: the dark round the foot, the wheel head, the pot, and the shadow of
  // its rim with the soft edge that the window's size gives it.
  struct Ring {
    double x, y, z, r;
  };
  const glm::vec3 light = window_direction();
  const double table = pot.wheel ? -0.024 : 0.0;
  const double along = (height - table) / light.y, foot = pot.wheel ? pot.wheel_radius : radius;
  const Ring rings[] = {{0, table, 0, foot + 0.25},
                        {0, 0, 0, foot},
                        {0, 0.5 * height, 0, 1.25 * radius},
                        {0, height * 1.03 + 0.004, 0, 1.25 * radius},
                        {-light.x * along, table, -light.z * along, radius + 0.14 * along}};
  float left = 1e9f, right = -1e9f, top = 1e9f, bottom = -1e9f;
  const auto take = [&](Vec3 p, double around) {
    const auto at = pot.camera.project(p);
    if (!at) {
      left = top = 0;
      right = static_cast<float>(width);
      bottom = static_cast<float>(frame_height);
      return;
    }
    const auto pad = static_cast<float>(around * pot.camera.height /
                                        (pot.camera.distance * 2 * std::tan(pot.camera.fov / 2)));
    left = std::min(left, at->first - pad);
    right = std::max(right, at->first + pad);
    top = std::min(top, at->second - pad);
    bottom = std::max(bottom, at->second + pad);
  };
  for (const Ring& ring : rings) {
    for (int i = 0; i < 24; ++i) {
      const double a = i * 0.2617993877991494;
      take({ring.x + ring.r * std::cos(a), ring.y, ring.z + ring.r * std::sin(a)}, 0);
    }
  }
  for (const HandView& hand : pot.hands) {
    if (hand.present) take(hand.at, ToolPainter::reach(hand));
  }
  left = std::clamp(std::floor(left) - 2, 0.0f, static_cast<float>(width));
  top = std::clamp(std::floor(top) - 2, 0.0f, static_cast<float>(frame_height));
  right = std::clamp(std::ceil(right) + 2, left, static_cast<float>(width));
  bottom = std::clamp(std::ceil(bottom) + 2, top, static_cast<float>(frame_height));
  return {left, top, right - left, bottom - top};
}

void Canvas::resize(int width, int height) {
  if (plaster_.width() == width && plaster_.height() == height) return;
  plaster_ = Target();
  picture_ = Target();
  before_ = Target();
  has_before_ = painted_ = false;
}

const Target& Canvas::kept(Target& target) const {
  if (target.width() == 0) target = Target(plaster_.width(), plaster_.height(), false, 0);
  return target;
}

void Canvas::paint_pot(Stage& stage, const view::Frame& frame, const Quality& quality,
                       double scale) {
  const int w = std::max(1, static_cast<int>(std::lround(frame.width * scale)));
  const int h = std::max(1, static_cast<int>(std::lround(frame.height * scale)));
  if (space_.width() != w || space_.height() != h || samples_ != quality.samples) {
    samples_ = quality.samples;
    space_ = Target(w, h, samples_ == 0, 0);
    space_samples_ = samples_ > 0 ? Target(w, h, true, samples_) : Target();
  }
  const Target& target = samples_ > 0 ? space_samples_ : space_;
  target.bind();
  stage.draw_pot(*frame.pot, quality, scale);
  if (samples_ > 0) space_samples_.resolve_to(space_);
}

void Canvas::turn_to(const view::Frame& frame, ItemPainter& items,
                     const ItemPainter::Pictures& pictures) {
  resize(frame.width, frame.height);
  if (!painted_ || frame.screen_serial == frame_.screen_serial) return;
  frame_.fade = 0;
  compose(kept(before_).framebuffer(), items, pictures);
  has_before_ = true;
  frame_.screen_serial = frame.screen_serial;  // Kept once.
}

void Canvas::paint(Stage& stage, ItemPainter& items, const ItemPainter::Pictures& pictures,
                   const view::Frame& frame, const Quality& quality, double scale, Onto onto,
                   Space space) {
  turn_to(frame, items, pictures);
  // The plaster never changes: once per size.
  if (plaster_.width() == 0) {
    plaster_ = Target(frame.width, frame.height, false, 0);
    plaster_.bind();
    stage.draw_plaster(frame.width, frame.height);
  }
  frame_ = frame;
  painted_ = true;

  if (frame.pot)
    reach_ = reach_of(*frame.pot, stage.clay().height(), stage.clay().max_radius(), frame.width,
                      frame.height);
  if (frame.pot && space == Space::draw) {
    // Nothing outside can be touched, so nothing outside is cleared, resolved or laid over.
    glEnable(GL_SCISSOR_TEST);
    const auto s = static_cast<float>(scale);
    glScissor(static_cast<int>(reach_.x * s),
              static_cast<int>((static_cast<float>(frame.height) - reach_.y - reach_.h) * s),
              static_cast<int>(std::ceil(reach_.w * s)) + 1,
              static_cast<int>(std::ceil(reach_.h * s)) + 1);
    paint_pot(stage, frame, quality, scale);
    glDisable(GL_SCISSOR_TEST);
  }
  compose(onto == Onto::window ? 0 : kept(picture_).framebuffer(), items, pictures);
}

void Canvas::compose(GLuint framebuffer, ItemPainter& items,
                     const ItemPainter::Pictures& pictures) {
  const int width = frame_.width, height = frame_.height;
  calls::bind_framebuffer(GL_READ_FRAMEBUFFER, plaster_.framebuffer());
  calls::bind_framebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  calls::copy(width, height);
  calls::bind_framebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, width, height);
  items.begin(width, height);
  const auto w = static_cast<float>(width), h = static_cast<float>(height);
  if (frame_.pot)
    items.draw_layer(space_.color(), reach_,
                     {reach_.x / w, reach_.y / h, reach_.w / w, reach_.h / h},
                     static_cast<float>(std::clamp(frame_.pot->opacity, 0.0, 1.0)));
  for (const view::Item& item : frame_.items) items.draw(item, pictures);
  if (frame_.fade > 0 && has_before_)
    items.draw_layer(before_.color(), {0, 0, w, h}, {0, 0, 1, 1},
                     std::clamp(frame_.fade, 0.0f, 1.0f));
}

void Canvas::show(ItemPainter& items, const ItemPainter::Pictures& pictures) {
  if (painted_) compose(0, items, pictures);
}

view::Image Canvas::read(ItemPainter& items, const ItemPainter::Pictures& pictures) {
  view::Image image{painted_ ? frame_.width : 0, painted_ ? frame_.height : 0, {}};
  const auto row = static_cast<std::size_t>(image.width) * 4;
  std::vector<std::uint8_t> rows(row * static_cast<std::size_t>(image.height));
  if (rows.empty()) return image;
  compose(kept(picture_).framebuffer(), items, pictures);
  calls::bind_framebuffer(GL_READ_FRAMEBUFFER, picture_.framebuffer());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, rows.data());
  image.rgba.resize(rows.size());
  for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) {
    std::memcpy(&image.rgba[y * row], &rows[rows.size() - (y + 1) * row], row);
  }
  // The ground is plaster everywhere; what layers left of alpha has no meaning.
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 255;
  return image;
}

}  // namespace onggi::render
