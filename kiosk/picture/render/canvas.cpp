#include "kiosk/picture/render/canvas.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace onggi::render {

view::Rect reach_of(const view::PotView& pot, double height, double radius, int width,
                    int frame_height, Reach reach) {
  // Rings that contain everything drawn: the dark area around the foot, the wheel head, the pot,
  // and the rim's shadow with the soft edge that comes from the window's size.
  struct Ring {
    double x, y, z, r;
  };
  const glm::vec3 light = window_direction(pot.window);
  const double table = pot.wheel ? -0.024 : 0.0;
  const double along = (height - table) / light.y, foot = pot.wheel ? pot.wheel_radius : radius;
  const Ring rings[] = {{0, table, 0, foot},
                        {0, 0, 0, foot},
                        {0, 0.5 * height, 0, 1.25 * radius},
                        {0, height * 1.03 + 0.004, 0, 1.25 * radius},
                        {0, table, 0, foot + 0.25},
                        {-light.x * along, table, -light.z * along, radius + 0.14 * along}};
  const std::size_t count = reach == Reach::solid ? 4 : 6;
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
  for (const Ring& ring : std::span(rings).first(count)) {
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

namespace {

view::Rect around(const view::Rect& a, const view::Rect& b) {
  const float left = std::min(a.x, b.x), top = std::min(a.y, b.y);
  return {left, top, std::max(a.x + a.w, b.x + b.w) - left, std::max(a.y + a.h, b.y + b.h) - top};
}

view::Rect reach_of_vessel(const Stage& stage, const view::Frame& frame) {
  view::PotView alone;
  alone.camera = frame.pot->beside->camera;
  alone.wheel = false;
  return reach_of(alone, stage.vessel().levels.height, stage.vessel().radius, frame.width,
                  frame.height, Reach::solid);
}

constexpr double kPlasterStep = 0.05;  // rad of the window

}  // namespace

void Canvas::resize(int width, int height) {
  if (plaster_.width() == width && plaster_.height() == height) return;
  plaster_ = Target();
  picture_ = Target();
  before_ = Target();
  ground_ = Target();
  of_ground_.reset();
  has_before_ = painted_ = composed_ = false;
}

const Target& Canvas::kept(Target& target) const {
  if (target.width() == 0) target = Target(plaster_.width(), plaster_.height(), false, 0);
  return target;
}

void Canvas::make_space(const view::Frame& frame, const Quality& quality, double scale) {
  const int w = std::max(1, static_cast<int>(std::lround(frame.width * scale)));
  const int h = std::max(1, static_cast<int>(std::lround(frame.height * scale)));
  if (space_.width() == w && space_.height() == h && samples_ == quality.samples) return;
  samples_ = quality.samples;
  space_ = Target();
  space_ = Target(w, h, true, samples_);
}

void Canvas::paint_pot(Stage& stage, const view::Frame& frame, const Quality& quality,
                       double scale) {
  make_space(frame, quality, scale);
  if (samples_ == 0) {
    glDisable(GL_SCISSOR_TEST);
    stage.prepare_edges(*frame.pot, scale);
    glEnable(GL_SCISSOR_TEST);
  }
  space_.bind();
  stage.draw_pot(*frame.pot, quality, scale, &space_, samples_ == 0 ? &bare_ : nullptr);
}

void Canvas::paint_ground(Stage& stage, const view::PotView& pot) {
  const float foot = stage.foot(pot);
  Ground now{pot.camera,
             pot.wheel,
             pot.window,
             pot.opacity,
             foot,
             Backdrop::darkened(stage.clay().height(), stage.clay().max_radius(), pot.wheel, foot,
                                window_direction(pot.window)),
             stage.backdrop().cast_serial(),
             {},
             0};
  if (pot.beside) {
    now.beside = pot.beside->camera;
    now.its_shadow = stage.backdrop().cast_serial(Backdrop::Of::mesh);
  }
  if (of_ground_ == now) return;
  // Ground without a shadow stays, unless it has moved.
  if (!of_ground_ || of_ground_->camera != now.camera || of_ground_->wheel != now.wheel ||
      of_ground_->window != now.window || of_ground_->extent != now.extent || of_ground_->beside ||
      now.beside) {
    kept(ground_);
    calls::bind_framebuffer(GL_READ_FRAMEBUFFER, plaster_.framebuffer());
    calls::bind_framebuffer(GL_DRAW_FRAMEBUFFER, ground_.framebuffer());
    calls::copy(0, 0, ground_.width(), ground_.height());
  }
  ground_.bind();
  stage.draw_ground(pot, plaster_.color(), now.extent);
  if (pot.beside) stage.draw_vessel_ground(pot, ground_.width(), ground_.height());
  of_ground_ = now;
}

void Canvas::turn_to(const view::Frame& frame, const Painters& with) {
  resize(frame.width, frame.height);
  if (!painted_ || frame.screen_serial == frame_.screen_serial) return;
  frame_.fade = 0;
  composed_ = false;
  compose(kept(before_).framebuffer(), with);
  has_before_ = true;
  frame_.screen_serial = frame.screen_serial;  // kept once
}

void Canvas::paint_plaster(const Painters& with, const view::Frame& frame) {
  // It depends on its size and on where its window is.
  const double window = frame.pot ? frame.pot->window : view::kWindowLeft;
  // A moving light paints all of it anew only in steps, which nobody sees.
  if (plaster_.width() != 0 && std::abs(plaster_window_ - window) < kPlasterStep) return;
  if (plaster_.width() == 0) plaster_ = Target(frame.width, frame.height, false, 0);
  plaster_window_ = window;
  plaster_.bind();
  with.stage.backdrop().draw_plaster(frame.width, frame.height, window);
}

bool Canvas::prepare(const Painters& with, const view::Frame& frame, const Quality& quality,
                     double scale) {
  turn_to(frame, with);
  if (plaster_.width() == 0) {
    paint_plaster(with, frame);
    kept(picture_);
    if (frame.pot) kept(ground_);
    return frame.pot.has_value();
  }
  if (frame.pot) make_space(frame, quality, scale);
  return false;
}

void Canvas::paint(const Painters& with, const view::Frame& frame, const Quality& quality,
                   double scale, Onto onto, Space space) {
  Stage& stage = with.stage;
  turn_to(frame, with);
  paint_plaster(with, frame);
  // What stays looks as it was drawn.
  const double opening = space == Space::keep && frame_.pot ? frame_.pot->cut_away : -1.0;
  frame_ = frame;
  painted_ = true;

  if (frame_.pot && (space == Space::draw || !of_ground_)) {
    view::PotView& pot = *frame_.pot;
    if (quality.samples == 0) pot.cut_away = stage.shown_opening(pot, scale);
    stage.prepare(pot, quality);
    const double coil = pot.coil.centre.empty() ? 0.0 : pot.coil.diameter;
    solid_ = reach_of(pot, stage.clay().height() + coil, stage.clay().max_radius() + coil,
                      frame.width, frame.height, Reach::solid);
    if (pot.beside) solid_ = around(solid_, reach_of_vessel(stage, frame_));
    paint_ground(stage, pot);
    // Nothing outside can change, so nothing outside is cleared or composed.
    glEnable(GL_SCISSOR_TEST);
    const auto s = static_cast<float>(scale);
    glScissor(static_cast<int>(solid_.x * s),
              static_cast<int>((static_cast<float>(frame.height) - solid_.y - solid_.h) * s),
              static_cast<int>(std::ceil(solid_.w * s)) + 1,
              static_cast<int>(std::ceil(solid_.h * s)) + 1);
    paint_pot(stage, frame_, quality, scale);
    glDisable(GL_SCISSOR_TEST);
  } else if (frame_.pot && opening >= 0.0) {
    frame_.pot->cut_away = opening;
  }
  composed_ = onto == Onto::own;
  compose(composed_ ? kept(picture_).framebuffer() : 0, with);
}

void Canvas::compose(GLuint framebuffer, const Painters& with) {
  const int width = frame_.width, height = frame_.height;
  const bool pot = frame_.pot.has_value();
  const view::Rect box = pot ? solid_ : view::Rect{};
  const Target& ground = pot ? ground_ : plaster_;
  calls::bind_framebuffer(GL_READ_FRAMEBUFFER, ground.framebuffer());
  calls::bind_framebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  const int left = static_cast<int>(box.x), right = static_cast<int>(box.x + box.w),
            low = static_cast<int>(static_cast<float>(height) - box.y - box.h),
            high = static_cast<int>(static_cast<float>(height) - box.y);
  calls::copy(0, 0, width, low);
  calls::copy(0, low, left, high - low);
  calls::copy(right, low, width - right, high - low);
  calls::copy(0, high, width, height - high);
  calls::bind_framebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, width, height);
  if (pot) {
    const auto opacity = static_cast<float>(std::clamp(frame_.pot->opacity, 0.0, 1.0));
    with.stage.backdrop().lay(space_, ground.color(), box, opacity, width, height);
    if (samples_ == 0)
      with.stage.draw_edges(*frame_.pot, space_, bare_, ground.color(), width, height);
  }
  with.items.draw(frame_.items, with.pictures, width, height);
  if (frame_.fade > 0 && has_before_)
    with.items.draw_layer(before_.color(), std::clamp(frame_.fade, 0.0f, 1.0f), width, height);
}

void Canvas::show(const Painters& with) {
  if (painted_) compose(0, with);
}

view::Image Canvas::read(const Painters& with) {
  view::Image image{painted_ ? frame_.width : 0, painted_ ? frame_.height : 0, {}};
  const auto row = static_cast<std::size_t>(image.width) * 4;
  image.rgba.resize(row * static_cast<std::size_t>(image.height));
  if (image.rgba.empty()) return image;
  if (!composed_) compose(kept(picture_).framebuffer(), with);
  calls::bind_framebuffer(GL_READ_FRAMEBUFFER, picture_.framebuffer());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  // OpenGL's first row is the lowest. Turned in place: a second picture's memory costs more.
  auto low = image.rgba.begin(), high = image.rgba.end() - static_cast<std::ptrdiff_t>(row);
  for (; low < high;
       low += static_cast<std::ptrdiff_t>(row), high -= static_cast<std::ptrdiff_t>(row))
    std::swap_ranges(low, low + static_cast<std::ptrdiff_t>(row), high);
  // The ground is plaster everywhere, so the alpha that layers leave has no meaning.
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 255;
  return image;
}

}  // namespace onggi::render
