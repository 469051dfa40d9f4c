#include "kiosk/visit/screens/idle.h"

#include <algorithm>

namespace onggi::screens {

IdleWatch::Word IdleWatch::look(double now, double warn_after, double countdown) {
  // s: a person with slow hands needs this long to answer (WCAG 2.2.1)
  constexpr double kLeast = 20.0;
  if (!started_) touched(now);
  countdown_ = std::max(countdown, kLeast);
  left_ = warn_after + countdown_ - (now - last_);
  if (now - last_ < warn_after) return Word::none;
  return left_ > 0 ? Word::warn : Word::over;
}

}  // namespace onggi::screens
