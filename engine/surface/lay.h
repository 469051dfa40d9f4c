#pragma once

#include "engine/surface/surface.h"

namespace onggi::surface {

/// What a law moved. No law but those that take away takes anything.
struct Work {
  Volume slip_laid = 0, glaze_laid = 0;
  Volume slip_taken = 0, glaze_taken = 0, clay_taken = 0;
  Volume clay_laid = 0;

  friend bool operator==(const Work&, const Work&) = default;
};

/// Lays `volume` of slip on a cell: on its top stratum if that has this pigment, else as a new one;
/// a fourth joins the two lowest under the thicker one's pigment. A cell can only have a code's
/// thickness, so the nearer one is taken, and the difference stays the row's rest until the next
/// cell. Returns what was taken up: less than `volume` (>= 0) where the cell is full.
Volume lay_slip(Surface& surface, int j, int i, int pigment, Volume volume);

/// Lifts `volume` off a cell's top stratum, of which there is more: as lay_slip() it leaves the
/// nearer code, and the difference is the row's rest. The slip on the pot is less by just that
/// volume. `volume` >= 0.
void lift_slip(Surface& surface, int j, int i, Volume volume);

/// Gives a cell a top stratum of exactly `code` (> 0): its own if that has this pigment and is not
/// thicker, else a new one. Returns the volume that was laid.
Volume coat_slip(Surface& surface, int j, int i, int pigment, int code);

/// As lay_slip() with glaze, in whole units.
Volume lay_glaze(Surface& surface, int j, int i, Volume volume);

/// Takes away all that stands higher than `height` nm over the reference body: glaze, slip, then
/// clay. A cut surface has no wax and no polish. Adds to `work`. True if there was something.
bool trim(Surface& surface, int j, int i, std::int64_t height, Work& work);

}  // namespace onggi::surface
