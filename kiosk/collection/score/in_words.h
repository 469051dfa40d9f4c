#pragma once

#include <string>
#include <vector>

#include "kiosk/collection/score/score.h"

namespace onggi::score {

/// Says a remark of Score::alike or try_next without figures, for a visitor's first pots:
/// "remark.belly_narrow {mm}" becomes "plain.much_wider {place}". Remarks without figures are
/// returned unchanged. Allocates.
Remark in_words(const Remark& remark);

/// A difference from this share of the vessel's own width on is called "much".
inline constexpr double kMuch = 0.15;

/// Every key that in_words() can add.
std::vector<std::string> word_keys();

}  // namespace onggi::score
