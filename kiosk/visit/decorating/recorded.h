#pragma once

#include "kiosk/collection/decoration/decoration.h"
#include "kiosk/visit/decorating/decorated_pot.h"

namespace onggi::decorating {

/// What hands did on `pot`, which keeps_work(), as the steps of a decoration.toml, with the
/// pigments that they took, and each tool's English words. `scale`: the pot's size over the real
/// vessel's, decoration::wheel_scale(). Colours of clay and glaze, sources and words are left to
/// the caller.
///
/// A ring becomes a ring, a figure its motif, and lines that follow each other with one tool a
/// motif of lines, within 0.1 mm of the hand's way on the pot. What the file does not know is left
/// out: that a brush takes wet slip along. Allocates.
decoration::Decoration recorded(const DecoratedPot& pot, double scale);

}  // namespace onggi::decorating
