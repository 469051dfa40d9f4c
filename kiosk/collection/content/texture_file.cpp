#include "kiosk/collection/content/texture_file.h"

#include <algorithm>
#include <filesystem>
#include <string>

#include "kiosk/collection/content/texture_answer.h"
#include "kiosk/ground/files/helper_process.h"

namespace onggi::content {
namespace {

constexpr unsigned kFewSide = 1024, kManySide = 512, kFew = 4;  // the shelf's picture has 480 x 600
/// Limits for decoding beyond the pictures themselves: MiB, bytes a pixel of the largest picture (a
/// progressive JPEG keeps every coefficient), seconds of processor time for all of them.
constexpr std::size_t kTextureMib = 256, kBytesAPixel = 10;
constexpr int kTextureSeconds = 20;

}  // namespace

Result<std::vector<textures::Decoded>> read_textures(
    const std::vector<std::span<const std::uint8_t>>& pictures,
    const settings::ReaderLimits& limits) {
  if (pictures.empty()) return std::vector<textures::Decoded>{};
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error)
    return problem("/proc/self/exe",
                   "The kiosk cannot find its own folder: " + error.message() + ".", "Mount /proc.",
                   1);
  const auto side = static_cast<std::size_t>(limits.texture_px);
  const unsigned wanted = pictures.size() > kFew ? kManySide : kFewSide;
  const std::vector<std::byte> order = order_bytes(pictures);
  const std::size_t decoded = std::size_t{3} * wanted * wanted * pictures.size();
  const std::size_t mib =
      kTextureMib + ((3 * order.size() + kBytesAPixel * side * side + 3 * decoded) >> 20);
  const auto answer = files::run_helper(
      {.program = (self.parent_path() / "onggi-texture").string(),
       .arguments = {std::to_string(side), std::to_string(wanted), std::to_string(mib),
                     std::to_string(kTextureSeconds)},
       .body = std::span(reinterpret_cast<const std::uint8_t*>(order.data()), order.size()),
       .timeout_s = 2.0 * kTextureSeconds,
       .most_bytes = decoded + 256 * pictures.size(),
       .answer = "picture"});
  if (!answer) return tl::unexpected<Problem>(answer.error());
  auto out = answers_of(*answer, pictures.size(), wanted);
  if (out.size() != pictures.size())
    return problem("onggi-texture", "it gave an incomplete answer.", "Start the kiosk again.", 1);
  return out;
}

}  // namespace onggi::content
