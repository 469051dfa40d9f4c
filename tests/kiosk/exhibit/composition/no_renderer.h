#pragma once

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "kiosk/picture/render/renderer.h"

namespace onggi::exhibit::test {

/// Has no window and draws nothing: a test says what it wants of one.
class NoRenderer : public render::Renderer {
 public:
  int width() const override { return 1280; }
  int height() const override { return 720; }
  std::vector<view::InputEvent> poll() override { return {}; }
  int fingers() const override { return 0; }
  void sleep(bool) override {}
  std::vector<std::string> remarks() override { return {}; }
  void show_clay(const ClayView&) override {}
  void update_clay(const ClayView&) override {}
  void show_decoration(const decoration::CoatPicture*) override {}
  void show_vessel(const TriangleMesh&, std::array<float, 3>, const content::Coloring&,
                   double) override {}
  void draw(const view::Frame&) override {}
  void present() override {}
  view::Image read_pixels() override { return {}; }
  bool prepare_offscreen(const view::Frame&) override { return false; }
  view::Image draw_offscreen(const view::Frame&) override { return {}; }
  std::vector<view::SkinPoint> read_skin(const ClayMesh&,
                                         const std::optional<view::Glazing>&) override {
    return {};
  }
  std::shared_ptr<const render::Portrait> prepare_picture(const TriangleMesh&, std::array<float, 3>,
                                                          const content::Coloring&, int,
                                                          int) override {
    return nullptr;
  }
  view::PictureId draw_picture(const render::Portrait&) override { return 0; }
  view::PictureId make_picture(const view::Image&) override { return 0; }
  void drop_picture(view::PictureId) override {}
  const view::TextMeasure& measure() const override { throw std::logic_error("not asked"); }
  render::RenderStatus status() const override { return {}; }
  void set_full_quality(bool) override {}
  void count_shading(bool) override {}
};

}  // namespace onggi::exhibit::test
