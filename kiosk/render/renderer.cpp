#include "kiosk/render/renderer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <thread>

#include "kiosk/render/canvas.h"
#include "kiosk/render/items.h"
#include "kiosk/render/pacing.h"
#include "kiosk/render/portrait.h"
#include "kiosk/render/stage.h"
#include "kiosk/render/window.h"

namespace onggi::render {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int kPictureSamples = 4;

double ms_since(Clock::time_point then) {
  return std::chrono::duration<double, std::milli>(Clock::now() - then).count();
}

bool is_software(const std::string& device) {
  return device.find("llvmpipe") != std::string::npos ||
         device.find("softpipe") != std::string::npos ||
         device.find("Software") != std::string::npos;
}

class GlRenderer final : public Renderer {
 public:
  GlRenderer(std::unique_ptr<Window> window, std::unique_ptr<Stage> stage,
             std::unique_ptr<ItemPainter> items)
      : window_(std::move(window)), stage_(std::move(stage)), items_(std::move(items)) {
    device_ = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    software_ = is_software(device_);
    // Without a GPU 10 frames a second are owed and 20 are welcome; with one, 60.
    pacing_ = software_ ? Pacing(70.0, 36.0) : Pacing(15.0, 7.0);
    frame_slot_ = std::chrono::microseconds(software_ ? 33333 : 16667);
  }

  int width() const override { return window_->width(); }
  int height() const override { return window_->height(); }
  std::vector<view::InputEvent> poll() override { return window_->poll(); }

  void show_clay(const ClayView& clay) override { stage_->clay().show(clay); }
  void update_clay(const ClayView& clay) override { stage_->clay().update(clay); }

  void draw(const view::Frame& frame) override {
    started_ = Clock::now();
    screen_.paint(*stage_, *items_, pictures_, frame, present_quality(), present_scale());
    glFinish();
    drew_ms_ = ms_since(started_);
  }

  void present() override;

  view::Image read_pixels() override { return screen_.read(); }

  view::Image draw_offscreen(const view::Frame& frame) override {
    view::Frame still = frame;
    still.fade = 0;
    still.width = std::clamp(frame.width, 1, 4096);
    still.height = std::clamp(frame.height, 1, 4096);
    Canvas canvas;
    canvas.paint(*stage_, *items_, pictures_, still, Quality{}, 1.0);
    return canvas.read();
  }

  view::PictureId make_picture(const TriangleMesh& mesh, std::array<float, 3> color, int width,
                               int height) override {
    const Portrait portrait = portrait_of(mesh, width, height);
    const Target many(width, height, true, kPictureSamples);
    Target one(width, height, false, 0);
    many.bind();
    stage_->draw_mesh(portrait.mesh, portrait.levels, portrait.camera,
                      {color[0], color[1], color[2]});
    many.resolve_to(one);
    return keep({one.take_color(), true});
  }

  view::PictureId make_picture(const view::Image& image) override {
    // Straight alpha comes in; layers are mixed premultiplied.
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

  void drop_picture(view::PictureId id) override { pictures_.erase(id); }
  const view::TextMeasure& measure() const override { return items_->typesetter(); }

  RenderStatus status() const override {
    return {.frame_ms = mean_ms_,
            .render_scale = present_scale(),
            .software = software_,
            .device = device_,
            .frames = frames_,
            .text_overflows = items_->text_overflows(),
            .last_overflow = items_->last_overflow()};
  }
  void set_full_quality(bool on) override { full_quality_ = on; }

 private:
  double present_scale() const { return full_quality_ ? 1.0 : pacing_.scale(); }
  Quality present_quality() const {
    if (full_quality_ || !software_) return {};
    return {.samples = 0, .reflection = pacing_.scale() > 0.6};
  }
  view::PictureId keep(ItemPainter::Stored stored) {
    // Pictures are shown smaller than made: levels keep them clean.
    glBindTexture(GL_TEXTURE_2D, stored.texture.name.get());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 12);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glGenerateMipmap(GL_TEXTURE_2D);
    pictures_[++last_picture_] = std::move(stored);
    return last_picture_;
  }

  // The window goes last: the others hold names of its context.
  std::unique_ptr<Window> window_;
  std::unique_ptr<Stage> stage_;
  std::unique_ptr<ItemPainter> items_;
  ItemPainter::Pictures pictures_;
  view::PictureId last_picture_ = 0;
  Canvas screen_;
  Pacing pacing_{15.0, 7.0};
  std::string device_;
  bool software_ = false, full_quality_ = false;
  std::uint64_t frames_ = 0;
  Clock::time_point started_ = Clock::now(), shown_ = Clock::now();
  Clock::duration frame_slot_{};
  double drew_ms_ = 0, mean_ms_ = 0;
};

void GlRenderer::present() {
  const auto begun = Clock::now();
  if (window_->visible()) {
    screen_.show(window_->width(), window_->height());
    window_->swap();
    glFinish();
  }
  const double ms = drew_ms_ + ms_since(begun);
  // A mean over about a second; one that starts with the second frame, as the first compiles.
  mean_ms_ = frames_ < 2 ? ms : mean_ms_ + 0.08 * (ms - mean_ms_);
  ++frames_;
  if (full_quality_) return;
  pacing_.frame(ms);
  // No more frames than the eye or the machine has use for: the 1 kHz loop wants the rest.
  const auto next = shown_ + frame_slot_;
  if (window_->visible() && Clock::now() < next) std::this_thread::sleep_until(next);
  shown_ = Clock::now();
}

}  // namespace

Result<std::unique_ptr<Renderer>> Renderer::create(const WindowOptions& options) {
  auto window = Window::create(options);
  if (!window) return tl::unexpected(window.error());
  if (epoxy_gl_version() < 33) {
    return problem("display", "The graphics driver offers no OpenGL 3.3.",
                   "Install a newer driver (Debian: libgl1-mesa-dri), or run with "
                   "LIBGL_ALWAYS_SOFTWARE=1.",
                   1);
  }
  auto stage = Stage::create();
  if (!stage) return tl::unexpected(stage.error());
  auto items = ItemPainter::create();
  if (!items) return tl::unexpected(items.error());
  return std::make_unique<GlRenderer>(std::move(*window), std::move(*stage), std::move(*items));
}

}  // namespace onggi::render
