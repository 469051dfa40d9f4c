#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/view/image.h"

namespace onggi::souvenir {

enum class Format { png, jpeg };

/// What goes into a picture file's metadata, in any script. UTF-8.
struct Caption {
  std::string title, copyright, description;
};

/// Largest width and height that is encoded, pixels.
inline constexpr int kLargestSide = 16384;

/// Encodes in a helper process (onggi-encode, beside this program), so that OpenImageIO's start-up,
/// its 260 libraries and its exits on error never reach the kiosk. sRGB, 300 dots an inch; PNG
/// keeps alpha where there is any, JPEG (quality 92) lies on white. Blocks; call off the main
/// thread. A helper that dies or takes over `timeout_s` is followed by one other. Problem (exit 1)
/// when it is missing, that does so too, or gives less than a whole picture.
Result<std::vector<std::byte>> encode(const view::Image& image, Format format,
                                      const Caption& caption, double timeout_s = 20.0);

/// The same with another helper program; for tests of what a helper may do wrong.
Result<std::vector<std::byte>> encode_with(const std::filesystem::path& helper,
                                           const view::Image& image, Format format,
                                           const Caption& caption, double timeout_s);

}  // namespace onggi::souvenir
