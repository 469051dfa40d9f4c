#pragma once

#include <vector>

#include "kiosk/visit/screens/visit.h"

namespace onggi::screens {

/// For each of the kiln's glazes, whether hardly anything of what was drawn on `pot` is seen
/// through it after the fire. All false where no glaze shows it better. Looks at some thousand
/// places of the outside, about 5 ms.
std::vector<bool> hiding(const decorating::DecoratedPot& pot, const Kiln& kiln);

}  // namespace onggi::screens
