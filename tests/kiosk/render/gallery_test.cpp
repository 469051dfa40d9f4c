#include <cmath>

#include "kiosk/view/palette.h"
#include "tests/kiosk/render/studio_fixture.h"

// Pictures for people to look at ($ONGGI_GALLERY names the folder), with the few things about them
// that a program can tell.

namespace onggi::render::testing {
namespace {

using Gallery = StudioTest;

double vase(double t) {
  return 0.034 + 0.030 * std::sin(3.5 * t + 0.1) * (1.0 - 0.35 * t) + 0.004 * t;
}
double bowl(double t) { return 0.028 + 0.062 * std::sqrt(t); }
double jar(double t) { return 0.056 + 0.004 * std::sin(3.1 * t); }

const view::GridShape kVase{400, 360, 0.20, 0.010};

TEST_F(Gallery, AVaseDryAndWetAndFiredAndOpened) {
  Renderer& r = renderer();
  r.set_grid(kVase);
  r.update_rows(thrown_rows(kVase, vase, 0.006, 0.00022));
  view::Frame frame = frame_with_pot(kWidth, kHeight, 0.20, 0.066);
  frame.pot->wheel_angle = 1.2;
  r.draw(frame);
  keep_for_looking(r.read_pixels(), "vase_dry");
  frame.pot->wetness = 0.9;
  frame.pot->tools[0] = {true, {0.070, 0.09, 0.018}, 0.008};
  r.draw(frame);
  keep_for_looking(r.read_pixels(), "vase_wet");
  frame.pot->wetness = 0.3;
  frame.pot->tools[0].visible = false;
  frame.pot->cut_away = 1.0;
  r.draw(frame);
  keep_for_looking(r.read_pixels(), "vase_open");
  frame.pot->cut_away = 0;
  frame.pot->finish = view::Finish::fired;
  r.draw(frame);
  keep_for_looking(r.read_pixels(), "vase_fired");

  view::Frame card = frame_with_pot(1500, 2100, 0.20, 0.066);
  card.pot->wheel = false;
  card.pot->finish = view::Finish::fired;
  keep_for_looking(r.draw_offscreen(card), "postcard");
}

TEST_F(Gallery, ABowlAndADeepJar) {
  Renderer& r = renderer();
  const view::GridShape shape{300, 360, 0.08, 0.008};
  r.set_grid(shape);
  r.update_rows(thrown_rows(shape, bowl, 0.005, 0.0002));
  view::Frame frame = frame_with_pot(kWidth, kHeight, 0.08, 0.09);
  r.draw(frame);
  keep_for_looking(r.read_pixels(), "bowl_dry");
  frame.pot->finish = view::Finish::fired;
  frame.pot->camera.elevation = 0.5;
  r.draw(frame);
  keep_for_looking(r.read_pixels(), "bowl_fired");

  const view::GridShape deep{400, 360, 0.20, 0.010};
  r.set_grid(deep);
  r.update_rows(thrown_rows(deep, jar, 0.007, 0.00015));
  frame = frame_with_pot(kWidth, kHeight, 0.20, 0.06);
  frame.pot->camera.elevation = 0.6;
  frame.pot->wetness = 0.6;
  r.draw(frame);
  keep_for_looking(r.read_pixels(), "jar");
}

}  // namespace
}  // namespace onggi::render::testing
