#include "engine/surface/strata.h"

#include <bit>

namespace onggi::surface {

int code_within(std::int64_t nm) {
  if (nm < thickness_of(1)) return 0;
  if (nm >= thickness_of(kCodes - 1)) return kCodes - 1;
  const int octave =
      static_cast<int>(std::bit_width(static_cast<std::uint64_t>(nm / thickness_of(1)))) - 1;
  int code = 1 + 4 * octave;
  while (code + 1 < kCodes && thickness_of(code + 1) <= nm) ++code;
  return code;
}

}  // namespace onggi::surface
