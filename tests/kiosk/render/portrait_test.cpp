#include "kiosk/render/portrait.h"

#include "tests/kiosk/render/studio_fixture.h"

namespace onggi::render::testing {
namespace {

using APortrait = StudioTest;

int light_of(Pixel p) { return p.r + p.g + p.b; }

TEST_F(APortrait, ThePlatesFloorIsLitAsItsRimIs) {
  Section plate;
  plate.outline = {{0, 0},        {0.06, 0},      {0.11, 0.016}, {0.114, 0.019},
                   {0.11, 0.019}, {0.06, 0.0045}, {0, 0.004}};
  const TriangleMesh mesh = revolve(plate, 128);
  const auto id = renderer().make_picture(mesh, {0.62f, 0.44f, 0.31f}, 400, 300);
  view::Frame frame;
  frame.width = 400;
  frame.height = 300;
  frame.items.emplace_back(view::Picture{{0, 0, 400, 300}, id, 1});
  renderer().draw(frame);
  const view::Image image = renderer().read_pixels();
  keep_for_looking(image, "a_plate");
  const Portrait portrait = portrait_of(mesh, 400, 300);
  // As large as every vessel is pictured: 0.2 m wide.
  const auto at = [&](double x, double y) {
    const auto p = *portrait.camera.project({x * 0.2 / 0.228, y * 0.2 / 0.228, 0});
    return light_of(pixel_at(image, static_cast<int>(p.first), static_cast<int>(p.second)));
  };
  EXPECT_GT(at(0, 0.004), 0.6 * at(0.09, 0.012));
  EXPECT_GT(at(0, 0.004), 200);
  renderer().drop_picture(id);
}

}  // namespace
}  // namespace onggi::render::testing
