#include "kiosk/souvenir/encode.h"

#include "kiosk/files/helper_process.h"
#include "kiosk/files/json.h"
#include "kiosk/souvenir/picture_bytes.h"

#ifndef ONGGI_VERSION
#error "The build gives ONGGI_VERSION."
#endif

namespace onggi::souvenir {
namespace {

namespace fs = std::filesystem;

/// One line of JSON that onggi-encode reads before the pixels.
std::string header(const view::Image& image, Format format, const Caption& caption) {
  // A caption with broken UTF-8 costs a letter, never the picture.
  return files::Json::object({{"width", image.width},
                              {"height", image.height},
                              {"format", format == Format::png ? "png" : "jpeg"},
                              {"title", caption.title},
                              {"copyright", caption.copyright},
                              {"description", caption.description},
                              {"software", "Onggi " ONGGI_VERSION}})
             .text(-1) +
         "\n";
}

}  // namespace

Result<std::vector<std::byte>> encode(const view::Image& image, Format format,
                                      const Caption& caption, double timeout_s) {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) {
    return problem("/proc/self/exe",
                   "The kiosk cannot tell where it lies: " + error.message() + ".", "Mount /proc.",
                   1);
  }
  return encode_with(program.parent_path() / "onggi-encode", image, format, caption, timeout_s);
}

Result<std::vector<std::byte>> encode_with(const fs::path& helper, const view::Image& image,
                                           Format format, const Caption& caption,
                                           double timeout_s) {
  const bool sized = image.width > 0 && image.height > 0 && image.width <= kLargestSide &&
                     image.height <= kLargestSide;
  const std::size_t pixels =
      sized ? static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) : 0;
  if (!sized || image.rgba.size() != 4 * pixels) {
    return problem("picture " + std::to_string(image.width) + " x " + std::to_string(image.height),
                   "The picture has no pixels, too many, or not as many as its size says.",
                   "This is a fault of the program: report it with the log.", 1);
  }
  // Noise does not compress, so PNG may need all bytes and a little; the rest is metadata.
  const std::size_t most = 5 * pixels + (1u << 20);
  const files::Helper work{.program = helper.string(),
                           .head = header(image, format, caption),
                           .body = image.rgba,
                           .timeout_s = timeout_s,
                           .most_bytes = most,
                           .answer = "picture"};
  auto picture = files::run_helper(work);
  // What was killed or hung (memory that ran short, a driver) is done by another; what cannot be
  // done is told by the second.
  if (!picture) picture = files::run_helper(work);
  if (picture && !is_whole(*picture, format)) {
    return problem(helper.string(), "The helper gave less than a whole picture.",
                   "Free memory, and build the kiosk again if this returns.", 1);
  }
  return picture;
}

}  // namespace onggi::souvenir
