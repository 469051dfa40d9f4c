#pragma once

#include <optional>
#include <string>

namespace onggi::screens {

/// The next thing to do, as a language key, and its place on the pot, if any.
struct Hint {
  std::string key;
  std::string place;  ///< Key of the named place or button; may be empty.
  struct Press {
    double height = 0;  ///< Metres above the wheel.
    bool inward = true;
  };
  std::optional<Press> press;
};

}  // namespace onggi::screens
