#pragma once

#include <span>
#include <vector>

#include "kiosk/collection/score/score.h"
#include "kiosk/visit/screens/page.h"

namespace onggi::screens {

/// The two outlines of a section drawing differ without colour: the vessel's line is solid, the
/// pot's is dashed and heavier. Lines scale with the page's text.
void draw_vessels_line(Page& page, const std::vector<std::pair<float, float>>& points);
void draw_pots_line(Page& page, const std::vector<std::pair<float, float>>& points);

/// Draws `vessel` and `pot` over each other as archaeologists do, with a common foot and axis: the
/// section with both walls on the left, the view on the right, the vessel's wall shaded. As large
/// as `room` allows, at most `pixels_per_metre`, on the room's lower edge. Beside the view, an
/// arrow for each of `tries` that is seen somewhere points from the pot's line to the vessel's.
void draw_section(Page& page, const view::Rect& room, const Profile& vessel, const Profile& pot,
                  double pixels_per_metre, std::span<const score::Remark> tries);

}  // namespace onggi::screens
