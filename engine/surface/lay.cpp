#include "engine/surface/lay.h"

#include <algorithm>

namespace onggi::surface {

namespace {

/// The code for `volume` on one of row j's cells: of the two round it the nearer one when the rest
/// of `pigment` is counted, which it changes by the difference.
int code_for(Surface& surface, int j, int pigment, Volume volume) {
  const Volume area = surface.row(j).area;
  const Volume want = volume + surface.rest(j, pigment);
  const int below = code_within(volume / area);
  const int above = std::min(below + 1, kCodes - 1);
  const bool up = 2 * want > (Volume{thickness_of(below)} + thickness_of(above)) * area;
  const int code = up ? above : below;
  surface.set_rest(j, pigment, want - thickness_of(code) * area);
  return code;
}

void make_room_on_top(Surface& surface, int j, Strata& strata) {
  if (const Stratum low = strata.at(2); low.code != 0) {
    const Stratum high = strata.at(1);
    const int pigment = high.code > low.code ? high.pigment : low.pigment;
    const Volume both = Volume{thickness_of(low.code)} + thickness_of(high.code);
    strata.set(1, {code_for(surface, j, pigment, both * surface.row(j).area), pigment});
    strata.set(2, {});
  }
  strata.push();
}

}  // namespace

Volume lay_slip(Surface& surface, int j, int i, int pigment, Volume volume) {
  const Volume area = surface.row(j).area;
  Strata strata = surface.slip(j, i);
  const Stratum top = strata.at(0);
  const bool joins = top.code == 0 || top.pigment == pigment;
  const Volume old = joins ? thickness_of(top.code) : 0;
  volume = std::min(volume, (thickness_of(kCodes - 1) - old) * area);
  if (volume <= 0) return 0;
  const int code = code_for(surface, j, pigment, old * area + volume);
  if (code == 0) return volume;  // all of it is the row's rest
  if (!joins) make_room_on_top(surface, j, strata);
  strata.set(0, {code, pigment});
  surface.set_slip(j, i, strata);
  return volume;
}

void lift_slip(Surface& surface, int j, int i, Volume volume) {
  Strata strata = surface.slip(j, i);
  const Stratum top = strata.at(0);
  const Volume old = Volume{thickness_of(top.code)} * surface.row(j).area;
  const int code = code_for(surface, j, top.pigment, old - volume);
  if (code == 0)
    strata.pop();
  else
    strata.set(0, {code, top.pigment});
  surface.set_slip(j, i, strata);
}

Volume coat_slip(Surface& surface, int j, int i, int pigment, int code) {
  Strata strata = surface.slip(j, i);
  const Stratum top = strata.at(0);
  const bool joins = top.code == 0 || top.pigment == pigment;
  if (joins && top.code >= code) return 0;
  if (!joins) make_room_on_top(surface, j, strata);
  strata.set(0, {code, pigment});
  surface.set_slip(j, i, strata);
  const int old = joins ? thickness_of(top.code) : 0;
  return Volume{thickness_of(code) - old} * surface.row(j).area;
}

Volume lay_glaze(Surface& surface, int j, int i, Volume volume) {
  const Volume unit = Volume{surface.row(j).area} * kGlazeUnit;
  const Volume old = surface.glaze(j, i) * unit;
  volume = std::min(volume, kMostGlaze * unit - old);
  if (volume <= 0) return 0;
  const Volume want = old + volume + surface.rest(j, Surface::kGlazeRest);
  const Volume below = (old + volume) / unit;
  const Volume above = std::min<Volume>(below + 1, kMostGlaze);
  const Volume units = 2 * want > (below + above) * unit ? above : below;
  surface.set_rest(j, Surface::kGlazeRest, want - units * unit);
  surface.set_glaze(j, i, static_cast<int>(units));
  return volume;
}

bool trim(Surface& surface, int j, int i, std::int64_t height, Work& work) {
  if (surface.top(j, i) <= height) return false;
  const Volume area = surface.row(j).area;
  const std::int64_t clay = surface.relief(j, i) * kNanometres;
  Strata strata = surface.slip(j, i);
  const int before = strata.thickness();

  // Glaze: the whole units that stay under the height.
  const int glaze = surface.glaze(j, i);
  const auto room =
      static_cast<int>(std::max<std::int64_t>(height - clay - before, 0) / kGlazeUnit);
  surface.set_glaze(j, i, std::min(glaze, room));
  work.glaze_taken += (glaze - surface.glaze(j, i)) * area * kGlazeUnit;

  // Slip: from the top down.
  while (strata.at(0).code != 0) {
    const std::int64_t over = clay + strata.thickness() - height;
    if (over <= 0) break;
    const Stratum top = strata.at(0);
    const int left = code_within(thickness_of(top.code) - over);
    if (left == 0)
      strata.pop();
    else
      strata.set(0, {left, top.pigment});
  }
  surface.set_slip(j, i, strata);
  work.slip_taken += (before - strata.thickness()) * area;

  if (clay > height) {
    surface.set_relief(j, i, static_cast<int>(floor_div(height, kNanometres)));
    surface.set_coil(j, i, false);
    work.clay_taken += (clay - surface.relief(j, i) * kNanometres) * area;
  }
  surface.set_resist(j, i, false);
  surface.set_burnish(j, i, 0);
  return true;
}

}  // namespace onggi::surface
