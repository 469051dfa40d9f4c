#include "tests/kiosk/picture/render/edges_fixture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace onggi::render::testing {
namespace {

constexpr int kFiner = 8;             // along and across a pixel of the finer picture
constexpr int kNearEdge = 2;          // pixels from an edge
constexpr double kEdgeApart = 0.008;  // m: a step of depth that is an edge
constexpr float kFarAway = 100.0f;    // m
constexpr int kOdd = 16;              // of 255: beyond all that is about a pixel

}  // namespace

std::unique_ptr<Stage> AnEdge::stage_;
std::unique_ptr<ItemPainter> AnEdge::items_;

void AnEdge::SetUp() {
  StudioTest::SetUp();
  if (IsSkipped() || stage_) return;
  auto stage = Stage::create();
  auto items = ItemPainter::create();
  ASSERT_TRUE(stage && items);
  stage_ = std::move(*stage);
  items_ = std::move(*items);
}

void AnEdge::TearDownTestSuite() {
  items_.reset();
  stage_.reset();
}

view::Frame AnEdge::show(const ClayDef& grid, double (*outer)(double), double height,
                         double radius) {
  clay_ = thrown_clay(grid, outer, 0.006, 0.0004);
  stage_->clay().show(clay_);
  reference_.clear();
  return frame_with_pot(kWide, kTall, height, radius);
}

view::Image AnEdge::drawn(const view::Frame& frame, double scale) {
  Canvas canvas;
  const Painters with{*stage_, *items_, {}};
  canvas.paint(with, frame, {.samples = 0}, scale, Canvas::Onto::own);
  return canvas.read(with);
}

view::Image AnEdge::laid(const view::Frame& frame, double scale, std::vector<float>* metres,
                         bool edges) {
  const view::PotView& pot = *frame.pot;
  const Target plaster(frame.width, frame.height, false, 0);
  const Target ground(frame.width, frame.height, false, 0);
  plaster.bind();
  stage_->backdrop().draw_plaster(frame.width, frame.height, pot.window);
  stage_->prepare(pot, {.samples = 0});
  calls::bind_framebuffer(GL_READ_FRAMEBUFFER, plaster.framebuffer());
  calls::bind_framebuffer(GL_DRAW_FRAMEBUFFER, ground.framebuffer());
  calls::copy(0, 0, frame.width, frame.height);
  ground.bind();
  stage_->draw_ground(
      pot, plaster.color(),
      Backdrop::darkened(stage_->clay().height(), stage_->clay().max_radius(), pot.wheel,
                         stage_->foot(pot), window_direction(pot.window)));
  if (pot.beside) stage_->draw_vessel_ground(pot, frame.width, frame.height);
  const Target space(static_cast<int>(frame.width * scale), static_cast<int>(frame.height * scale),
                     true, 0);
  if (edges) stage_->prepare_edges(pot, scale);
  space.bind();
  glScissor(0, 0, space.width(), space.height());
  // Only a whole frame has a line round the section.
  stage_->draw_pot(pot, {.samples = pot.cut_away > 0.0 && scale >= 1.0 ? 4 : 0}, scale);
  glDisable(GL_SCISSOR_TEST);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  if (metres != nullptr) {
    metres->resize(static_cast<std::size_t>(space.width() * space.height()));
    calls::bind_framebuffer(GL_READ_FRAMEBUFFER, space.framebuffer());
    glReadPixels(0, 0, space.width(), space.height(), GL_DEPTH_COMPONENT, GL_FLOAT, metres->data());
    float view[16], projection[16];
    pot.camera.matrices(view, projection);
    for (float& d : *metres)
      d = d >= 1.0f ? kFarAway : projection[14] / (2.0f * d - 1.0f + projection[10]);
  }
  plaster.bind();
  const view::Rect all{0, 0, static_cast<float>(frame.width), static_cast<float>(frame.height)};
  stage_->backdrop().lay(space, ground.color(), all, 1.0f, frame.width, frame.height);
  if (edges) stage_->draw_edges(pot, space, {}, ground.color(), frame.width, frame.height);
  view::Image image{frame.width, frame.height, {}};
  const auto row = static_cast<std::size_t>(frame.width) * 4;
  std::vector<std::uint8_t> rows(row * static_cast<std::size_t>(frame.height));
  calls::bind_framebuffer(GL_READ_FRAMEBUFFER, plaster.framebuffer());
  glReadPixels(0, 0, frame.width, frame.height, GL_RGBA, GL_UNSIGNED_BYTE, rows.data());
  for (std::size_t y = static_cast<std::size_t>(frame.height); y-- > 0;)
    image.rgba.insert(image.rgba.end(), rows.begin() + static_cast<std::ptrdiff_t>(y * row),
                      rows.begin() + static_cast<std::ptrdiff_t>((y + 1) * row));
  return image;
}

void AnEdge::sample(view::Frame frame, const std::string& name) {
  frame.width *= kFiner;
  frame.height *= kFiner;
  const auto finer = [](view::Camera& camera) {
    camera.width *= kFiner;
    camera.height *= kFiner;
    camera.centre_x *= kFiner;
    camera.centre_y *= kFiner;
  };
  finer(frame.pot->camera);
  if (frame.pot->beside) finer(frame.pot->beside->camera);
  std::vector<float> metres;
  const view::Image many = laid(frame, 1.0, &metres);
  reference_.assign(static_cast<std::size_t>(kWide) * kTall * 3, 0.0);
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) {
      const Pixel p = pixel_at(many, x, y);
      const std::size_t at = 3 * pixel(x / kFiner, y / kFiner);
      for (const auto& [k, value] : {std::pair(0u, p.r), std::pair(1u, p.g), std::pair(2u, p.b)})
        reference_[at + k] += value / static_cast<double>(kFiner * kFiner);
    }
  near_.assign(reference_.size() / 3, false);
  const auto w = static_cast<std::size_t>(frame.width), h = static_cast<std::size_t>(frame.height);
  for (std::size_t y = 0; y + 1 < h; ++y)
    for (std::size_t x = 0; x + 1 < w; ++x) {
      const float here = metres[y * w + x];
      if (std::abs(here - metres[y * w + x + 1]) > kEdgeApart ||
          std::abs(here - metres[(y + 1) * w + x]) > kEdgeApart)
        mark(static_cast<int>(x) / kFiner, kTall - 1 - static_cast<int>(y) / kFiner);
    }
  for (int y = 0; only_ && y < kTall; ++y)
    for (int x = 0; x < kWide; ++x) near_[pixel(x, y)] = only_(x, y);
  for (int y = 0; part_ && y < kTall; ++y)
    for (int x = 0; x < kWide; ++x) near_[pixel(x, y)] = near_[pixel(x, y)] && part_(x, y);
  view::Image shown{kWide, kTall, {}}, mask = shown;
  for (std::size_t i = 0; i < near_.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k) {
      shown.rgba.push_back(
          static_cast<std::uint8_t>(k < 3 ? std::lround(reference_[3 * i + k]) : 255));
      mask.rgba.push_back(near_[i] ? 255 : 0);
    }
  keep_for_looking(shown, "ref_" + name);
  keep_for_looking(mask, "mask_" + name);
}

void AnEdge::mark(int x, int y) {
  for (int i = std::max(x - kNearEdge, 0); i <= std::min(x + kNearEdge, kWide - 1); ++i)
    for (int j = std::max(y - kNearEdge, 0); j <= std::min(y + kNearEdge, kTall - 1); ++j)
      near_[pixel(i, j)] = true;
}

double AnEdge::difference(const view::Image& image) const {
  double sum = 0.0, count = 0.0;
  for (int y = 0; y < kTall; ++y)
    for (int x = 0; x < kWide; ++x) {
      const std::size_t at = pixel(x, y);
      if (!near_[at]) continue;
      const Pixel p = pixel_at(image, x, y);
      sum += std::abs(p.r - reference_[3 * at]) + std::abs(p.g - reference_[3 * at + 1]) +
             std::abs(p.b - reference_[3 * at + 2]);
      count += 3.0;
    }
  EXPECT_GT(count, only_ ? 600.0 : 3000.0);
  return sum / count;
}

double AnEdge::odd(const view::Image& image) const {
  double odd = 0.0, count = 0.0;
  for (int y = 2; y + 2 < kTall; ++y)
    for (int x = 2; x + 2 < kWide; ++x) {
      if (!near_[pixel(x, y)]) continue;
      double least = 255.0, most = 0.0;
      for (int i = -2; i <= 2; ++i)
        for (int j = -2; j <= 2; ++j) {
          const double v = reference_[3 * pixel(x + i, y + j) + 1];
          least = std::min(least, v);
          most = std::max(most, v);
        }
      const int g = pixel_at(image, x, y).g;
      odd += g < least - kOdd || g > most + kOdd;
      ++count;
    }
  return odd / count;
}

void AnEdge::expect_smooth(const view::Frame& frame, const std::string& name,
                           std::array<Most, 2> most) {
  sample(frame, name);
  for (const std::size_t k : {0u, 1u}) {
    const double scale = k == 0 ? 0.5 : 0.25;
    const std::string file = name + (k == 0 ? "0.50" : "0.25");
    const view::Image with = drawn(frame, scale), without = laid(frame, scale);
    keep_for_looking(with, "edges_" + file);
    keep_for_looking(without, "plain_" + file);
    const double error = difference(with), before = difference(without);
    std::printf("%s: %.2f of 255 near the edges, without edges %.2f; odd %.4f, without %.4f\n",
                file.c_str(), error, before, odd(with), odd(without));
    EXPECT_LT(error, most[k].error * before) << file;
    EXPECT_LE(odd(with), most[k].odd) << file;
  }
}

}  // namespace onggi::render::testing
