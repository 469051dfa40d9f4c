#include "kiosk/picture/render/portrait.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "tests/kiosk/picture/render/studio_fixture.h"

namespace onggi::render::testing::portrait_test {
namespace {

int light_of(Pixel p) { return p.r + p.g + p.b; }

class APortrait : public StudioTest {
 protected:
  static view::Image drawn(const TriangleMesh& mesh, std::array<float, 3> color,
                           const content::Coloring& coloring, int width, int height,
                           const std::string& name) {
    const auto id =
        renderer().draw_picture(*renderer().prepare_picture(mesh, color, coloring, width, height));
    view::Frame frame;
    frame.width = width;
    frame.height = height;
    frame.items.emplace_back(
        view::Picture{{0, 0, static_cast<float>(width), static_cast<float>(height)}, id, 1});
    renderer().draw(frame);
    view::Image image = renderer().read_pixels();
    renderer().drop_picture(id);
    keep_for_looking(image, name);
    return image;
  }
  void draw_plate(const std::vector<Vec2>& outline, const std::string& name) {
    Section plate;
    plate.outline = outline;
    const TriangleMesh mesh = revolve(plate, 128);
    image_ = drawn(mesh, {0.62f, 0.44f, 0.31f}, {}, 400, 300, name);
    camera_ = portrait_of(mesh, {1, 1, 1}, {}, 400, 300).camera;
  }
  /// Of the place at `x` and `y`, m, of a plate, which is drawn 0.2 m wide.
  int light_at(double x, double y) const {
    const auto p = *camera_.project({x * 0.2 / 0.228, y * 0.2 / 0.228, 0});
    return light_of(pixel_at(image_, static_cast<int>(p.first), static_cast<int>(p.second)));
  }

 private:
  view::Image image_;
  view::Camera camera_;
};

TEST_F(APortrait, ThePlatesFloorIsLitAsItsRimIs) {
  draw_plate(
      {{0, 0}, {0.06, 0}, {0.11, 0.016}, {0.114, 0.019}, {0.11, 0.019}, {0.06, 0.0045}, {0, 0.004}},
      "a_plate");
  EXPECT_GT(light_at(0, 0.004), 0.6 * light_at(0.09, 0.012));
  EXPECT_GT(light_at(0, 0.004), 200);
}

TEST_F(APortrait, AWellInThePlatesMiddleIsLitAsTheFloorAboutItIs) {
  draw_plate({{0, 0},
              {0.06, 0},
              {0.11, 0.016},
              {0.114, 0.019},
              {0.11, 0.019},
              {0.085, 0.013},
              {0.045, 0.0065},
              {0.03, 0.0033},
              {0, 0.0033}},
             "a_well");
  EXPECT_GT(light_at(0, 0.0033), 0.6 * light_at(0.06, 0.009));
}

/// A wall all round, 0.2 m high, with v from its rim down.
struct Wall {
  TriangleMesh mesh;
  content::Coloring coloring;
};
Wall wall(const textures::TexturePixels& pixels, content::Coloring::Wrap wrap, float rounds) {
  Wall out;
  Section tube;
  tube.outline = {{0, 0}, {0.06, 0}, {0.06, 0.2}, {0, 0.2}};
  out.mesh = revolve(tube, 96);
  for (const auto& p : out.mesh.positions) {
    out.coloring.colors.push_back({255, 255, 255});
    out.coloring.places.push_back({0.5f, rounds * (1.0f - p[1] / 0.2f)});
    out.coloring.picture.push_back(1);
  }
  out.coloring.pictures.push_back({std::make_shared<textures::TexturePixels>(pixels), wrap, wrap});
  return out;
}

textures::TexturePixels blue_over_red() {
  textures::TexturePixels out;
  out.width = out.height = 64;
  for (int i = 0; i < 64 * 64; ++i)
    for (const std::uint8_t c : i < 32 * 64 ? std::array<std::uint8_t, 3>{20, 40, 200}
                                            : std::array<std::uint8_t, 3>{190, 30, 25})
      out.rgb.push_back(c);
  return out;
}

class APaintedPortrait : public APortrait {
 protected:
  /// The pixel on the wall that faces the eye, `height` above the foot.
  static Pixel on_wall(const view::Image& image, const TriangleMesh& mesh, double height) {
    const auto eye = portrait_of(mesh, {1, 1, 1}, {}, 300, 400).camera.eye();
    const double to = 0.06 / std::hypot(eye.x, eye.z);
    const auto p = *portrait_of(mesh, {1, 1, 1}, {}, 300, 400)
                        .camera.project({eye.x * to, height, eye.z * to});
    return pixel_at(image, static_cast<int>(p.first), static_cast<int>(p.second));
  }
};

TEST_F(APaintedPortrait, HasThePicturesFirstRowAtTheRimWhereItsPlacesSaySo) {
  const Wall w = wall(blue_over_red(), content::Coloring::Wrap::clamp, 1.0f);
  const view::Image image = drawn(w.mesh, {}, w.coloring, 300, 400, "blue_over_red");
  const Pixel above = on_wall(image, w.mesh, 0.16), below = on_wall(image, w.mesh, 0.06);
  EXPECT_GT(above.b, above.r + 50) << above.r << ' ' << above.g << ' ' << above.b;
  EXPECT_GT(below.r, below.b + 50) << below.r << ' ' << below.g << ' ' << below.b;
}

TEST_F(APaintedPortrait, IsLitAsAVesselOfThatColourIs) {
  textures::TexturePixels plain;
  plain.width = plain.height = 8;
  for (int i = 0; i < 64; ++i) plain.rgb.insert(plain.rgb.end(), {137, 96, 60});
  const Wall w = wall(plain, content::Coloring::Wrap::repeat, 1.0f);
  const view::Image painted = drawn(w.mesh, {}, w.coloring, 300, 400, "painted");
  const std::array<float, 3> color{content::light_of(137), content::light_of(96),
                                   content::light_of(60)};
  const view::Image fired = drawn(w.mesh, color, {}, 300, 400, "fired");
  int worst = 0;
  for (std::size_t i = 0; i < painted.rgba.size(); ++i)
    worst = std::max(worst, std::abs(painted.rgba[i] - fired.rgba[i]));
  EXPECT_LE(worst, 2);
}

TEST_F(APaintedPortrait, RepeatsItsPictureAsTheScanWantsIt) {
  using Wrap = content::Coloring::Wrap;
  // Twice down the wall: blue, red, and again; mirrored red, blue; or the last row to the foot.
  for (const auto& [wrap, red_below, name] :
       {std::tuple{Wrap::repeat, false, "repeated"}, std::tuple{Wrap::mirror, true, "mirrored"},
        std::tuple{Wrap::clamp, true, "clamped"}}) {
    const Wall w = wall(blue_over_red(), wrap, 2.0f);
    const view::Image image = drawn(w.mesh, {}, w.coloring, 300, 400, name);
    const Pixel third = on_wall(image, w.mesh, 0.08), last = on_wall(image, w.mesh, 0.025);
    EXPECT_EQ(third.r > third.b, red_below) << name;
    EXPECT_EQ(last.r > last.b, wrap != Wrap::mirror) << name;
  }
}

}  // namespace
}  // namespace onggi::render::testing::portrait_test
