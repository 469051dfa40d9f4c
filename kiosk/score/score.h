#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/profile/measures.h"

namespace onggi::score {

/// A remark in a language's words: a key of content/languages with its places.
struct Remark {
  std::string key;                            ///< "remark.neck_wide"
  std::map<std::string, std::string> places;  ///< {"mm", "8"}
};

/// What a pot is worth as an answer to a vessel.
struct Score {
  double points = 0;  ///< 0..100
  int stars = 0;      ///< 1..5
  Measures measures;
  std::vector<Remark> alike;  ///< What is alike, best first; at least one.
  std::vector<Remark>
      try_next;  ///< What to try, largest difference first; may be empty above 97 points.
};

/// Policy: scale-free by default. Both profiles valid, metres.
Score judge(const Profile& target, const Profile& made, bool scale_free = true);

}  // namespace onggi::score
