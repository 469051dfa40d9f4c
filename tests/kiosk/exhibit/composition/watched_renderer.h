#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "kiosk/picture/render/renderer.h"

namespace onggi::exhibit::test {

/// What a test sees of a renderer, and what it adds to the input.
struct Watch {
  std::vector<view::InputEvent> input;      ///< Comes with the next poll(), after the window's own.
  std::function<void(const char*)> called;  ///< At the start of each call that draws or keeps.
  std::function<void(const view::Frame&)> drawn, drawn_offscreen;
  view::PictureId made = 0;  ///< The last picture.
};

/// A real renderer that tells a Watch, which outlives it, what it is asked.
class WatchedRenderer final : public render::Renderer {
 public:
  WatchedRenderer(std::unique_ptr<render::Renderer> real, Watch& watch)
      : real_(std::move(real)), watch_(watch) {}

  int width() const override { return real_->width(); }
  int height() const override { return real_->height(); }
  std::vector<view::InputEvent> poll() override {
    std::vector<view::InputEvent> events = real_->poll();
    for (const view::InputEvent& event : std::exchange(watch_.input, {})) events.push_back(event);
    return events;
  }
  int fingers() const override { return real_->fingers(); }
  void sleep(bool on) override { real_->sleep(on); }
  std::vector<std::string> remarks() override { return real_->remarks(); }
  void show_clay(const ClayView& clay) override {
    tell("show_clay");
    real_->show_clay(clay);
  }
  void update_clay(const ClayView& clay) override {
    tell("update_clay");
    real_->update_clay(clay);
  }
  void show_decoration(const decoration::CoatPicture* coat) override {
    tell("show_decoration");
    real_->show_decoration(coat);
  }
  void show_vessel(const TriangleMesh& mesh, std::array<float, 3> color,
                   const content::Coloring& coloring, double size) override {
    tell("show_vessel");
    real_->show_vessel(mesh, color, coloring, size);
  }
  void draw(const view::Frame& frame) override {
    tell("draw");
    if (watch_.drawn) watch_.drawn(frame);
    real_->draw(frame);
  }
  void present() override { real_->present(); }
  view::Image read_pixels() override { return real_->read_pixels(); }
  bool prepare_offscreen(const view::Frame& frame) override {
    tell("prepare_offscreen");
    return real_->prepare_offscreen(frame);
  }
  view::Image draw_offscreen(const view::Frame& frame) override {
    tell("draw_offscreen");
    if (watch_.drawn_offscreen) watch_.drawn_offscreen(frame);
    return real_->draw_offscreen(frame);
  }
  std::vector<view::SkinPoint> read_skin(const ClayMesh& mesh,
                                         const std::optional<view::Glazing>& glazing) override {
    tell("read_skin");
    return real_->read_skin(mesh, glazing);
  }
  std::shared_ptr<const render::Portrait> prepare_picture(const TriangleMesh& mesh,
                                                          std::array<float, 3> color,
                                                          const content::Coloring& coloring,
                                                          int width, int height) override {
    tell("prepare_picture");
    return real_->prepare_picture(mesh, color, coloring, width, height);
  }
  view::PictureId draw_picture(const render::Portrait& portrait) override {
    tell("draw_picture");
    return watch_.made = real_->draw_picture(portrait);
  }
  view::PictureId make_picture(const view::Image& image) override {
    tell("make_picture");
    return watch_.made = real_->make_picture(image);
  }
  void drop_picture(view::PictureId id) override {
    tell("drop_picture");
    real_->drop_picture(id);
  }
  const view::TextMeasure& measure() const override {
    tell("measure");
    return real_->measure();
  }
  render::RenderStatus status() const override { return real_->status(); }
  void set_full_quality(bool on) override { real_->set_full_quality(on); }
  void count_shading(bool on) override { real_->count_shading(on); }

 private:
  void tell(const char* call) const {
    if (watch_.called) watch_.called(call);
  }

  std::unique_ptr<render::Renderer> real_;
  Watch& watch_;
};

}  // namespace onggi::exhibit::test
