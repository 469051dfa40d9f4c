#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "kiosk/visit/screens/screen_text.h"

namespace onggi::access {

/// Something to speak. No words: silence at once.
struct Utterance {
  std::string language;  ///< Language code.
  std::string text;
  /// A newer utterance of the same or a higher weight interrupts it. 3: the warning that a visit
  /// ends; 2: an answer to the visitor; 1: news.
  int weight = 1;
  std::uint64_t id = 0;  ///< Rises from one to the next.
};

/// A control's name, kind and state: "Water, button", "Silent, off".
std::string spoken(const screens::Control& control, const content::Language& language);

/// The sentences in sequence, each ended with a full stop if it has no ending.
std::string joined(const std::vector<std::string>& sentences);

}  // namespace onggi::access
