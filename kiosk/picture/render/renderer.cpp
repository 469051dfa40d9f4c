#include "kiosk/picture/render/renderer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <optional>
#include <thread>
#include <utility>

#include "kiosk/picture/render/calls.h"
#include "kiosk/picture/render/canvas.h"
#include "kiosk/picture/render/items.h"
#include "kiosk/picture/render/pacing.h"
#include "kiosk/picture/render/portrait.h"
#include "kiosk/picture/render/stage.h"
#include "kiosk/picture/render/window.h"
#include "kiosk/picture/view/looks_same.h"
#include "kiosk/picture/view/palette.h"

namespace onggi::render {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int kPictureSamples = 4;
constexpr auto kStands = std::chrono::milliseconds(25);
constexpr auto kShownAgain = std::chrono::milliseconds(500);
constexpr std::uint64_t kOffscreenFrames = 120;  ///< A second postcard comes sooner.

double ms_since(Clock::time_point then) {
  return std::chrono::duration<double, std::milli>(Clock::now() - then).count();
}

bool is_software(const std::string& device) {
  return device.find("llvmpipe") != std::string::npos ||
         device.find("softpipe") != std::string::npos ||
         device.find("Software") != std::string::npos;
}

/// With a GPU 60 frames a second. Without one, at least 30 at 1280 x 720 and 20 at 1920 x 1080:
/// smooth motion looks better than sharp pictures, and still pictures are drawn in full.
Pacing pacing_for(bool software, int width, int height) {
  if (!software) return {15.0, 7.0};
  const double small = 1280.0 * 720.0, large = 1920.0 * 1080.0;
  const double share = std::clamp((1.0 * width * height - small) / (large - small), 0.0, 1.0);
  const double late = 32.0 + 16.0 * share;
  return {late, 0.85 * late};
}

/// On flat plaster: the studio's is not there yet.
void show_opening(const view::Frame& frame, Window& window, ItemPainter& items) {
  calls::bind_framebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, frame.width, frame.height);
  glClearColor(view::kPlaster.r, view::kPlaster.g, view::kPlaster.b, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  items.draw(frame.items, {}, frame.width, frame.height);
  window.swap();
  glFinish();
}

class GlRenderer final : public Renderer {
 public:
  GlRenderer(std::unique_ptr<Window> window, std::unique_ptr<Stage> stage,
             std::unique_ptr<ItemPainter> items)
      : window_(std::move(window)), stage_(std::move(stage)), items_(std::move(items)) {
    device_ = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    software_ = is_software(device_);
    frame_slot_ = std::chrono::microseconds(software_ ? 30000 : 16667);
  }

  int width() const override { return window_->width(); }
  int height() const override { return window_->height(); }
  std::vector<view::InputEvent> poll() override { return window_->poll(); }
  void sleep(bool on) override { window_->sleep(on); }
  int fingers() const override { return window_->fingers(); }
  std::vector<std::string> remarks() override {
    std::vector<std::string> lines = window_->remarks();
    for (std::string& line : stage_->remarks()) lines.push_back(std::move(line));
    return lines;
  }

  void show_clay(const ClayView& clay) override { stage_->clay().show(clay); }
  void update_clay(const ClayView& clay) override { stage_->clay().update(clay); }
  void show_decoration(const decoration::CoatPicture* coat) override { stage_->coat().show(coat); }

  void show_vessel(const TriangleMesh& mesh, std::array<float, 3> color,
                   const content::Coloring& coloring, double size) override {
    const auto scaled = static_cast<float>(size);
    stage_->show_vessel(model_of(mesh, color, coloring, scaled), edges_of(mesh, scaled));
    drawn_.reset();
  }

  void draw(const view::Frame& frame) override;

  void present() override;

  view::Image read_pixels() override { return screen_.read(painters()); }

  bool prepare_offscreen(const view::Frame& frame) override {
    return offscreen().prepare(painters(), alone(frame), Quality{});
  }

  view::Image draw_offscreen(const view::Frame& frame) override {
    Canvas& canvas = offscreen();
    canvas.paint(painters(), alone(frame), Quality{}, 1.0, Canvas::Onto::own);
    return canvas.read(painters());
  }

  std::vector<view::SkinPoint> read_skin(const ClayMesh& mesh,
                                         const std::optional<view::Glazing>& glazing) override {
    return stage_->read_skin(mesh, glazing);
  }

  std::shared_ptr<const Portrait> prepare_picture(const TriangleMesh& mesh,
                                                  std::array<float, 3> color,
                                                  const content::Coloring& coloring, int width,
                                                  int height) override {
    return std::make_shared<const Portrait>(portrait_of(mesh, color, coloring, width, height));
  }

  view::PictureId draw_picture(const Portrait& portrait) override {
    const int width = portrait.camera.width, height = portrait.camera.height;
    const Target many(width, height, true, kPictureSamples);
    Target one(width, height, false, 0);
    many.bind();
    stage_->draw_portrait(portrait);
    many.resolve_to(one);
    return keep({one.take_color(), true});
  }

  view::PictureId make_picture(const view::Image& image) override {
    // Input has straight alpha; layers are mixed premultiplied.
    std::vector<std::uint8_t> rgba = image.rgba;
    rgba.resize(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4);
    for (std::size_t i = 0; i + 3 < rgba.size(); i += 4) {
      for (std::size_t k = 0; k < 3; ++k) {
        rgba[i + k] = static_cast<std::uint8_t>((rgba[i + k] * rgba[i + 3] + 127) / 255);
      }
    }
    return keep({Texture::create(GL_RGBA8, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE,
                                 rgba.data()),
                 false});
  }

  /// Dropped with the next frame, because the fading screen may have shown it.
  void drop_picture(view::PictureId id) override { dropped_.push_back(id); }
  const view::TextMeasure& measure() const override { return items_->typesetter(); }

  RenderStatus status() const override {
    return {.frame_ms = mean_ms_,
            .render_scale = present_scale(),
            .software = software_,
            .full_quality = drawn_full_,
            .device = device_,
            .embedded = embedded(),
            .frames = frames_,
            .text_overflows = items_->text_overflows(),
            .last_overflow = items_->last_overflow(),
            .work = calls::so_far(),
            .shading_counted = calls::Shading::counted()};
  }
  void set_full_quality(bool on) override { full_quality_ = on; }
  void count_shading(bool on) override { shading_ = on; }

 private:
  Painters painters() { return {*stage_, *items_, pictures_}; }
  double present_scale() const { return full_quality_ ? 1.0 : pacing_.scale(); }
  Quality moving_quality() const {
    if (!software_) return {};
    return {.samples = 0, .shadow_apart = 0.001};
  }
  Canvas& offscreen() {
    offscreen_until_ = frames_ + kOffscreenFrames;
    return offscreen_ ? *offscreen_ : offscreen_.emplace();
  }
  /// Of no screen, so that none fades.
  static view::Frame alone(view::Frame frame) {
    frame.fade = 0;
    frame.screen_serial = 0;
    frame.width = std::clamp(frame.width, 1, 4096);
    frame.height = std::clamp(frame.height, 1, 4096);
    return frame;
  }
  /// It can be drawn straight into the window.
  bool fits(const view::Frame& frame) const {
    return window_->visible() && frame.width == window_->width() &&
           frame.height == window_->height();
  }
  view::PictureId keep(ItemPainter::Stored stored) {
    // Pictures are shown reduced; mipmap levels keep them clean.
    calls::bind_texture(stored.texture.name.get());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 12);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glGenerateMipmap(GL_TEXTURE_2D);
    pictures_[++last_picture_] = std::move(stored);
    return last_picture_;
  }

  // Destroy the window last, because the others hold names of its context.
  std::unique_ptr<Window> window_;
  std::unique_ptr<Stage> stage_;
  std::unique_ptr<ItemPainter> items_;
  ItemPainter::Pictures pictures_;
  view::PictureId last_picture_ = 0;
  std::vector<view::PictureId> dropped_;
  Canvas screen_;
  std::optional<Canvas> offscreen_;
  std::uint64_t offscreen_until_ = 0;  ///< The frame at which it goes.
  Pacing pacing_{15.0, 7.0};
  std::string device_;
  bool software_ = false, full_quality_ = false, drawn_full_ = false, shading_ = false;
  std::uint64_t frames_ = 0;
  Clock::time_point started_ = Clock::now(), shown_ = Clock::now(), moved_ = started_,
                    swapped_ = started_;
  Clock::duration frame_slot_{};
  double drew_ms_ = 0, mean_ms_ = 0;
  std::optional<view::Frame> drawn_;  ///< The canvas' content; its pot as last drawn.
  std::uint64_t drawn_coat_ = 0;      ///< CoatTexture::change() then.
  bool changed_ = true;               ///< The last draw() changed something.
  bool timed_ = true;                 ///< It drew the 3-D picture; pacing needs to know.
};

void GlRenderer::draw(const view::Frame& frame) {
  started_ = Clock::now();
  if (!drawn_ || drawn_->width != frame.width || drawn_->height != frame.height)
    pacing_ = pacing_for(software_, frame.width, frame.height);
  const bool still =
      drawn_ && drawn_->width == frame.width && drawn_->height == frame.height &&
      drawn_->screen_serial == frame.screen_serial && drawn_coat_ == stage_->coat().change() &&
      drawn_->pot.has_value() == frame.pot.has_value() &&
      (!frame.pot || (!stage_->clay().changed() && view::looks_same(*drawn_->pot, *frame.pot)));
  if (!still) moved_ = started_;
  // A still picture is drawn once in the full quality of a GPU.
  const bool finer = still && !drawn_full_ && started_ - moved_ > kStands;
  changed_ = !still || finer || drawn_->items != frame.items || drawn_->fade != frame.fade;
  timed_ = !still;
  changed_ = changed_ || !dropped_.empty();
  if (!changed_) return;
  const calls::Shading counted(shading_);
  screen_.turn_to(frame, painters());
  for (const view::PictureId id : dropped_) pictures_.erase(id);
  dropped_.clear();
  if (!still || finer) drawn_full_ = finer || full_quality_ || !software_;
  const auto space = still && !finer ? Canvas::Space::keep : Canvas::Space::draw;
  screen_.paint(painters(), frame, drawn_full_ ? Quality{} : moving_quality(),
                drawn_full_ ? 1.0 : pacing_.scale(),
                fits(frame) ? Canvas::Onto::window : Canvas::Onto::own, space);
  glFinish();
  drew_ms_ = ms_since(started_);
  std::optional<view::PotView> pot = still ? std::move(drawn_->pot) : frame.pot;
  drawn_ = frame;
  drawn_->pot = std::move(pot);
  drawn_coat_ = stage_->coat().change();
}

void GlRenderer::present() {
  const auto begun = Clock::now();
  // Something that covered the window may be gone, so show it again now and then.
  if (drawn_ && fits(*drawn_) && (changed_ || begun - swapped_ > kShownAgain)) {
    if (!changed_) {
      const calls::Shading counted(shading_);
      screen_.show(painters());
    }
    window_->swap();
    glFinish();
    swapped_ = begun;
  }
  const double ms = drew_ms_ + ms_since(begun);
  // A mean over about a second. It starts with the second frame, because the first one compiles
  // shaders.
  if (timed_) mean_ms_ = frames_ < 2 ? ms : mean_ms_ + 0.08 * (ms - mean_ms_);
  if (++frames_ > offscreen_until_) offscreen_.reset();
  if (full_quality_) return;
  if (timed_) pacing_.frame(ms);
  // Draw no more frames than the eye or the machine can use: the 1 kHz loop needs the rest.
  const auto next = shown_ + frame_slot_;
  if (window_->visible() && Clock::now() < next) std::this_thread::sleep_until(next);
  shown_ = Clock::now();
}

}  // namespace

Result<std::unique_ptr<Renderer>> Renderer::create(const WindowOptions& options) {
  auto window = Window::create(options);
  if (!window) return tl::unexpected(window.error());
  const bool enough =
      embedded() ? epoxy_gl_version() >= 31 && epoxy_has_gl_extension("GL_EXT_color_buffer_float")
                 : epoxy_gl_version() >= 33;
  if (!enough) {
    return problem("display",
                   "The graphics driver offers neither OpenGL 3.3 nor OpenGL ES 3.1 with targets "
                   "of floats.",
                   "Install a newer driver (Debian: libgl1-mesa-dri), or run with "
                   "LIBGL_ALWAYS_SOFTWARE=1.",
                   1);
  }
  auto items = ItemPainter::create();
  if (!items) return tl::unexpected(items.error());
  if (options.opening && (*window)->visible())
    show_opening(options.opening((*window)->width(), (*window)->height()), **window, **items);
  auto stage = Stage::create();
  if (!stage) return tl::unexpected(stage.error());
  return std::make_unique<GlRenderer>(std::move(*window), std::move(*stage), std::move(*items));
}

}  // namespace onggi::render
