#pragma once

#include <string>
#include <unordered_map>

#include "kiosk/picture/view/measure.h"

namespace onggi::screens {

/// Caches text sizes, because a screen sets the same words sixty times a second.
class Measuring {
 public:
  explicit Measuring(const view::TextMeasure& measure) : measure_(measure) {}
  view::TextMeasure::Size operator()(const std::string& words, const view::TextStyle& style,
                                     float width);

 private:
  const view::TextMeasure& measure_;
  std::unordered_map<std::string, view::TextMeasure::Size> known_;
};

}  // namespace onggi::screens
