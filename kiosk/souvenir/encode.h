#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/view/image.h"

namespace onggi::souvenir {

enum class Format { png, jpeg };

/// What goes into a picture file's metadata.
struct Caption {
  std::string title, copyright, description;
};

/// Encodes in a helper process (onggi-encode, beside this program), so that OpenImageIO's start-up,
/// its 260 libraries and its exits on error never reach the kiosk. Blocks; call off the main
/// thread. Problem (exit 1) when the helper is missing, dies or takes over `timeout_s`.
Result<std::vector<std::byte>> encode(const view::Image& image, Format format,
                                      const Caption& caption, double timeout_s = 20.0);

}  // namespace onggi::souvenir
