#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/picture/view/image.h"

namespace onggi::encoding {

enum class Format { png, jpeg, gif };

/// Metadata of a picture file, in any script. UTF-8.
struct Caption {
  std::string title, copyright, description;
};

/// Pictures of one size, shown in a loop.
struct Turning {
  int width = 0, height = 0;       ///< Pixels.
  int frames = 0;                  ///< 1..kMostFrames
  double seconds = 4.0;            ///< Duration of the loop; at least 0.02 s a frame.
  std::vector<std::uint8_t> rgba;  ///< Frame after frame, in the format of view::Image.
};
inline constexpr int kMostFrames = 120;

/// Largest width and height, pixels.
inline constexpr int kLargestSide = 16384;

/// Encodes in a helper process (onggi-encode, beside this program), which keeps OpenImageIO's
/// start-up, its 260 libraries and its exits on error out of the kiosk. sRGB, 300 dots an inch; PNG
/// keeps alpha if there is any, JPEG (quality 92) is laid on white. Blocks; call it off the main
/// thread. If a helper dies or takes over `timeout_s`, a second one tries. Problem (exit 1) if the
/// helper is missing, the second one fails too, or the picture is incomplete.
Result<std::vector<std::byte>> encode(const view::Image& image, Format format,
                                      const Caption& caption, double timeout_s = 20.0);

/// The same with another helper program, to test faulty helpers.
Result<std::vector<std::byte>> encode_with(const std::filesystem::path& helper,
                                           const view::Image& image, Format format,
                                           const Caption& caption, double timeout_s);

/// `turning` as an endless animated GIF, with the same helper. Transparent pixels are laid on
/// white. A frame's duration is rounded to hundredths of a second.
Result<std::vector<std::byte>> encode(const Turning& turning, const Caption& caption,
                                      double timeout_s = 20.0);
Result<std::vector<std::byte>> encode_with(const std::filesystem::path& helper,
                                           const Turning& turning, const Caption& caption,
                                           double timeout_s);

}  // namespace onggi::encoding
