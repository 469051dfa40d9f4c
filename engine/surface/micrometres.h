#pragma once

#include <cmath>
#include <cstdint>

namespace onggi::surface {

/// A length in m, or any other number, in whole millionths: the nearest.
inline std::int64_t micrometres(double metres) {
  return static_cast<std::int64_t>(std::floor(metres * 1e6 + 0.5));
}
inline std::int64_t nanometres(double metres) {
  return static_cast<std::int64_t>(std::floor(metres * 1e9 + 0.5));
}

}  // namespace onggi::surface
