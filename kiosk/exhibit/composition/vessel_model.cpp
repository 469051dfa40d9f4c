#include "kiosk/exhibit/composition/vessel_model.h"

namespace onggi::exhibit {

namespace {

/// The same without pictures: each corner has its picture's colour.
content::Coloring at_corners(const content::Coloring& coloring) {
  content::Coloring out;
  for (const auto& light : content::baked(coloring))
    out.colors.push_back({content::display_of(light[0]), content::display_of(light[1]),
                          content::display_of(light[2])});
  return out;
}

}  // namespace

void show_vessel(render::Renderer& renderer, const screens::ShelfCard& card) {
  const content::Vessel& vessel = *card.vessel;
  if (vessel.turning.triangles.empty())
    return renderer.show_vessel(vessel.mesh, vessel.color, vessel.coloring, card.scale);
  TriangleMesh light = vessel.mesh;
  light.triangles = vessel.turning.triangles;
  renderer.show_vessel(light, vessel.color,
                       vessel.turning.coarse ? at_corners(vessel.coloring) : vessel.coloring,
                       card.scale);
}

}  // namespace onggi::exhibit
