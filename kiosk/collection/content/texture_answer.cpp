#include "kiosk/collection/content/texture_answer.h"

#include <cstring>

#include "kiosk/ground/files/byte_writer.h"

namespace onggi::content {
namespace {

constexpr std::size_t kLongestWhy = 200;

/// Reads numbers and runs of bytes from the front; whole() tells whether all were there.
template <class Byte>
class Taken {
 public:
  explicit Taken(std::span<const Byte> bytes) : rest_(bytes) {}
  std::uint32_t u32() {
    const auto four = run(4);
    std::uint32_t out = 0;
    for (std::size_t i = 0; i < four.size(); ++i)
      out |= static_cast<std::uint32_t>(four[i]) << (8 * i);
    return out;
  }
  std::span<const Byte> run(std::size_t size) {
    whole_ = whole_ && size <= rest_.size();
    const auto out = rest_.first(whole_ ? size : 0);
    rest_ = rest_.subspan(out.size());
    return out;
  }
  bool whole() const { return whole_; }
  bool over() const { return rest_.empty(); }

 private:
  std::span<const Byte> rest_;
  bool whole_ = true;
};

}  // namespace

std::vector<std::byte> order_bytes(std::span<const std::span<const std::uint8_t>> pictures) {
  std::size_t size = 4 * pictures.size();
  for (const auto& picture : pictures) size += picture.size();
  files::ByteWriter out(size);
  for (const auto& picture : pictures) {
    out.u32(static_cast<std::uint32_t>(picture.size()));
    out.append(std::as_bytes(picture));
  }
  return out.take();
}

std::vector<std::span<const std::uint8_t>> pictures_of(std::span<const std::uint8_t> bytes) {
  Taken rest(bytes);
  std::vector<std::span<const std::uint8_t>> out;
  while (rest.whole() && !rest.over()) out.push_back(rest.run(rest.u32()));
  if (!rest.whole()) out.clear();
  return out;
}

std::vector<std::byte> answer_bytes(const std::vector<textures::Decoded>& decoded) {
  files::ByteWriter out;
  for (const textures::Decoded& one : decoded) {
    out.u32(one ? static_cast<std::uint32_t>(one->width) : 0);
    if (!one) {
      const std::string why = one.error().substr(0, kLongestWhy);
      out.u32(static_cast<std::uint32_t>(why.size()));
      out.text(why);
      continue;
    }
    out.u32(static_cast<std::uint32_t>(one->height));
    out.append(std::as_bytes(std::span(one->rgb)));
  }
  return out.take();
}

std::vector<textures::Decoded> answers_of(std::span<const std::byte> bytes, std::size_t count,
                                          unsigned most_side) {
  Taken rest(bytes);
  std::vector<textures::Decoded> out;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t width = rest.u32(), height = rest.u32();
    if (width == 0) {
      const auto why = rest.run(std::min<std::size_t>(height, kLongestWhy));
      out.push_back(
          tl::unexpected(std::string(reinterpret_cast<const char*>(why.data()), why.size())));
      continue;
    }
    if (!rest.whole() || width > most_side || height == 0 || height > most_side) return {};
    const auto rgb = rest.run(std::size_t{3} * width * height);
    textures::TexturePixels pixels;
    pixels.width = static_cast<int>(width);
    pixels.height = static_cast<int>(height);
    pixels.rgb.resize(rgb.size());
    if (!rgb.empty()) std::memcpy(pixels.rgb.data(), rgb.data(), rgb.size());
    out.push_back(std::move(pixels));
  }
  if (!rest.whole() || !rest.over()) return {};
  return out;
}

}  // namespace onggi::content
