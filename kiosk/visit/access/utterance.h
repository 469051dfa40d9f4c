#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "kiosk/visit/screens/reading.h"

namespace onggi::access {

/// Something that is said; without words: silence, at once.
struct Utterance {
  std::string language;  ///< Its code.
  std::string text;
  /// One that is being said is ended by a newer one of as much weight or more. 3: the warning that
  /// a visit ends; 2: what the visitor did or asked; 1: news.
  int weight = 1;
  std::uint64_t id = 0;  ///< Greater than those before it.
};

/// A control by name, what it is, and how it stands: "Water, button", "Silent, off".
std::string spoken(const screens::Control& control, const content::Language& language);

/// Sentences one after the other, each ended by a full stop where it has no ending of its own.
std::string joined(const std::vector<std::string>& sentences);

}  // namespace onggi::access
