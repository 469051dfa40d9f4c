#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/picture/view/image.h"

namespace onggi::encoding {

enum class Format { png, jpeg, gif };

/// What goes into a picture file's metadata, in any script. UTF-8.
struct Caption {
  std::string title, copyright, description;
};

/// Pictures of one size, shown one after the other and from the first again.
struct Turning {
  int width = 0, height = 0;       ///< Pixels.
  int frames = 0;                  ///< 1..kMostFrames
  double seconds = 4.0;            ///< From the first to the first again; 0.02 s a frame or more.
  std::vector<std::uint8_t> rgba;  ///< Frame after frame, as view::Image has one.
};
inline constexpr int kMostFrames = 120;

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

/// `turning` as an animated GIF without end, by the same helper in the same way. See-through pixels
/// lie on white. A frame's time is whole hundredths of a second, the nearest.
Result<std::vector<std::byte>> encode(const Turning& turning, const Caption& caption,
                                      double timeout_s = 20.0);
Result<std::vector<std::byte>> encode_with(const std::filesystem::path& helper,
                                           const Turning& turning, const Caption& caption,
                                           double timeout_s);

}  // namespace onggi::encoding
