#pragma once

#include "kiosk/visit/screens/page.h"

namespace onggi::screens {

/// What tells the two outlines of a section drawing apart without colour: a vessel's line goes on,
/// a pot's is dashed and heavier. Lines are in proportion to the page's text.
void draw_vessels_line(Page& page, const std::vector<std::pair<float, float>>& points);
void draw_pots_line(Page& page, const std::vector<std::pair<float, float>>& points);

/// `vessel` and `pot` as pots are drawn in the field, one over the other on one foot and one axis:
/// section with both walls on the left, view on the right, the vessel's wall toned. As large as
/// `room` holds and at most `pixels_per_metre`, standing on the room's lower edge.
void draw_section(Page& page, const view::Rect& room, const Profile& vessel, const Profile& pot,
                  double pixels_per_metre);

}  // namespace onggi::screens
