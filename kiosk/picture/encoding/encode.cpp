#include "kiosk/picture/encoding/encode.h"

#include <algorithm>
#include <cmath>

#include "kiosk/ground/files/helper_process.h"
#include "kiosk/ground/files/json.h"
#include "kiosk/picture/encoding/picture_bytes.h"

#ifndef ONGGI_VERSION
#error "The build gives ONGGI_VERSION."
#endif

namespace onggi::encoding {
namespace {

namespace fs = std::filesystem;

constexpr const char* name_of(Format format) {
  return format == Format::png ? "png" : format == Format::jpeg ? "jpeg" : "gif";
}

/// The line of JSON before the pixels in onggi-encode's input.
files::Json header(int width, int height, Format format, const Caption& caption) {
  // Broken UTF-8 in a caption costs a letter, never the picture.
  return files::Json::object({{"width", width},
                              {"height", height},
                              {"format", name_of(format)},
                              {"title", caption.title},
                              {"copyright", caption.copyright},
                              {"description", caption.description},
                              {"software", "Onggi " ONGGI_VERSION}});
}

Result<fs::path> own_helper() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) {
    return problem("/proc/self/exe",
                   "The kiosk cannot find its own folder: " + error.message() + ".", "Mount /proc.",
                   1);
  }
  return program.parent_path() / "onggi-encode";
}

/// Bytes of one of `frames` in a row; 0: there is no such picture.
std::size_t pixels_of(int width, int height) {
  const bool sized = width > 0 && height > 0 && width <= kLargestSide && height <= kLargestSide;
  return sized ? static_cast<std::size_t>(width) * static_cast<std::size_t>(height) : 0;
}

tl::unexpected<Problem> no_picture(int width, int height) {
  return problem("picture " + std::to_string(width) + " x " + std::to_string(height),
                 "The picture has no pixels, too many, or not as many as its size says.",
                 "This is a fault of the program: report it with the log.", 1);
}

Result<std::vector<std::byte>> run(const fs::path& helper, const files::Json& head,
                                   const std::vector<std::uint8_t>& rgba, Format format,
                                   double timeout_s) {
  // Noise does not compress, so a PNG may need all bytes and a little more; the rest is for
  // metadata.
  const files::Helper work{.program = helper.string(),
                           .head = head.text(-1) + "\n",
                           .body = rgba,
                           .timeout_s = timeout_s,
                           .most_bytes = 5 * rgba.size() / 4 + (1u << 20),
                           .answer = "picture"};
  auto picture = files::run_helper(work);
  // If the helper was killed or hung (little memory, a driver), a second one tries; if the picture
  // is impossible, the second one reports that.
  if (!picture) picture = files::run_helper(work);
  if (picture && !is_whole(*picture, format)) {
    return problem(helper.string(), "The helper gave an incomplete picture.",
                   "Free memory, and build the kiosk again if this happens again.", 1);
  }
  return picture;
}

}  // namespace

Result<std::vector<std::byte>> encode(const view::Image& image, Format format,
                                      const Caption& caption, double timeout_s) {
  const auto helper = own_helper();
  if (!helper) return tl::unexpected(helper.error());
  return encode_with(*helper, image, format, caption, timeout_s);
}

Result<std::vector<std::byte>> encode_with(const fs::path& helper, const view::Image& image,
                                           Format format, const Caption& caption,
                                           double timeout_s) {
  const std::size_t pixels = pixels_of(image.width, image.height);
  if (pixels == 0 || image.rgba.size() != 4 * pixels) return no_picture(image.width, image.height);
  return run(helper, header(image.width, image.height, format, caption), image.rgba, format,
             timeout_s);
}

Result<std::vector<std::byte>> encode(const Turning& turning, const Caption& caption,
                                      double timeout_s) {
  const auto helper = own_helper();
  if (!helper) return tl::unexpected(helper.error());
  return encode_with(*helper, turning, caption, timeout_s);
}

Result<std::vector<std::byte>> encode_with(const fs::path& helper, const Turning& turning,
                                           const Caption& caption, double timeout_s) {
  const std::size_t pixels = pixels_of(turning.width, turning.height);
  const bool counted = turning.frames > 0 && turning.frames <= kMostFrames;
  if (pixels == 0 || !counted ||
      turning.rgba.size() != 4 * pixels * static_cast<std::size_t>(turning.frames))
    return no_picture(turning.width, turning.height);
  files::Json head = header(turning.width, turning.height, Format::gif, caption);
  head["frames"] = turning.frames;
  head["hundredths"] = std::max(2L, std::lround(100.0 * turning.seconds / turning.frames));
  return run(helper, head, turning.rgba, Format::gif, timeout_s);
}

}  // namespace onggi::encoding
