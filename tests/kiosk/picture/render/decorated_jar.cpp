#include "tests/kiosk/picture/render/decorated_jar.h"

#include <algorithm>
#include <cmath>

namespace onggi::render::testing {
namespace {

decoration::Palette palette() {
  decoration::Palette out;
  out.pigments = {{{0.72f, 0.66f, 0.57f}, {0.80f, 0.76f, 0.69f}, 3e-5},
                  {{0.10f, 0.05f, 0.035f}, {0.028f, 0.020f, 0.017f}, 2e-5},
                  {{0.16f, 0.17f, 0.20f}, {0.028f, 0.070f, 0.20f}, 1e-5}};
  return out;
}

double belly(double t) { return 0.045 + 0.02 * std::sin(3.0 * t); }

}  // namespace

DecoratedJar::DecoratedJar(double height, double grooves)
    : clay(thrown_clay(grid_of(360, 180, height, 0.012), belly, 0.006, grooves)),
      profile(clay.profile()),
      surface(*surface::Surface::create(profile, "jar")),
      picture(surface, palette()) {}

void DecoratedJar::lay(const surface::Stroke& stroke, int times) {
  const auto strokes = surface::repeated(stroke, times);
  ASSERT_TRUE(strokes);
  for (const surface::Stroke& one : *strokes) ASSERT_TRUE(surface::apply(surface, one));
}

surface::Stroke DecoratedJar::way(surface::Tool tool,
                                  const std::vector<std::array<double, 2>>& places) const {
  surface::Tracer tracer(surface, 100.0);
  for (const auto& [along, turns] : places) tracer.go({along, turns});
  tracer.lift();
  return {std::move(tool), tracer.stations(), false};
}

surface::Stroke DecoratedJar::ring(surface::Tool tool, double share) const {
  return way(std::move(tool), {{along(share), 0.0}, {along(share), 1.0}});
}

surface::Stroke DecoratedJar::area(int pigment, double share, double turns,
                                   const std::vector<std::array<double, 2>>& corners) const {
  const double middle = along(share);
  const auto row = static_cast<int>(1e6 * middle) / surface::kRowHeight;
  const double radius = surface.row(row).radius;
  surface::Stroke out{surface::FillDef{.pigment = pigment}, {}, false};
  for (const auto& [x, y] : corners) {
    surface::Station station;
    station.along = static_cast<std::int32_t>(std::lround(1e6 * middle + 1e3 * y));
    station.round = static_cast<std::int32_t>(
        std::lround((turns + 1e-3 * x / (2.0 * 3.141592654 * radius)) * surface::kTurn));
    out.stations.push_back(station);
  }
  return out;
}

double DecoratedJar::along(double share) const {
  int j = 0;
  while (surface.row(j).height < share * profile.height()) ++j;
  return 1e-6 * surface::kRowHeight * (j + 0.5);
}

const decoration::CoatPicture* DecoratedJar::draw(bool fired) {
  picture.fire(fired);
  picture.touch_all();
  picture.draw(surface, 1 << 20);
  return &picture;
}

surface::BrushDef brush_of(int pigment, double width) {
  return {.pigment = pigment, .width = width, .reach = 100.0};
}

}  // namespace onggi::render::testing
