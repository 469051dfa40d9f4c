#pragma once

#include <optional>
#include <string>

namespace onggi::screens {

/// What to do next, as a key of the languages, and where on the pot, if anywhere.
struct Hint {
  std::string key;
  std::string place;  ///< Key of the place named in it; may be empty.
  struct Press {
    double height = 0;  ///< Metres above the wheel.
    bool inward = true;
  };
  std::optional<Press> press;
};

}  // namespace onggi::screens
