#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"

namespace onggi::settings {

/// Every problem in a line of its own, for the message of a test.
inline std::string all(const std::vector<Problem>& problems) {
  std::string out;
  for (const Problem& p : problems) out += to_text(p) + "\n";
  return out;
}

}  // namespace onggi::settings
