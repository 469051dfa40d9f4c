#include "kiosk/picture/encoding/gif.h"

#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <new>
#include <utility>

namespace onggi::encoding {
namespace {

using Rgb = std::array<std::uint8_t, 3>;

constexpr int kColors = 255;
constexpr std::uint8_t kUnchanged = 255;  // the palette's last entry: the previous pixel stays
constexpr int kBits = 6;                  // bits of a channel, for counting colours
constexpr int kAlike = 3;  // levels of a channel: less than the dither moves, so nobody sees it

/// Similar colours, counted together.
struct Cell {
  std::array<double, 3> sum{}, square{};
  double count = 0;
  double mean(std::size_t k) const { return sum[k] / count; }
  double error(std::size_t k) const { return square[k] - sum[k] * sum[k] / count; }
  void add(const Cell& other) {
    count += other.count;
    for (std::size_t k = 0; k < 3; ++k) sum[k] += other.sum[k], square[k] += other.square[k];
  }
};

std::vector<Cell> count_colors(std::span<const std::uint8_t> rgb) {
  std::vector<Cell> all(std::size_t{1} << 3 * kBits);
  for (std::size_t i = 0; i + 2 < rgb.size(); i += 3) {
    std::size_t place = 0;
    for (std::size_t k = 0; k < 3; ++k) place = place << kBits | rgb[i + k] >> (8 - kBits);
    Cell& cell = all[place];
    ++cell.count;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = static_cast<double>(rgb[i + k]);
      cell.sum[k] += v;
      cell.square[k] += v * v;
    }
  }
  std::erase_if(all, [](const Cell& cell) { return cell.count == 0; });
  return all;
}

/// A run of cells with one palette colour.
struct Shades {
  std::size_t from = 0, to = 0;
  Cell all;
  std::size_t axis = 0;  // channel with the largest spread
  double error = 0;      // on all three channels
};

Shades shades_of(const std::vector<Cell>& cells, std::size_t from, std::size_t to) {
  Shades some{from, to, {}, 0, 0};
  for (std::size_t i = from; i < to; ++i) some.all.add(cells[i]);
  for (std::size_t k = 0; k < 3; ++k) {
    some.error += some.all.error(k);
    if (some.all.error(k) > some.all.error(some.axis)) some.axis = k;
  }
  if (to - from < 2) some.error = 0;  // it cannot be divided
  return some;
}

/// Divides colours at the mean of the largest spread, until there are kColors.
std::vector<Rgb> palette_of(std::span<const std::uint8_t> rgb) {
  std::vector<Cell> cells = count_colors(rgb);
  std::vector<Shades> all{shades_of(cells, 0, cells.size())};
  while (all.size() < kColors) {
    const auto worst = std::max_element(
        all.begin(), all.end(), [](const Shades& a, const Shades& b) { return a.error < b.error; });
    if (worst->error <= 0) break;
    const Shades some = *worst;
    const double mean = some.all.mean(some.axis);
    const auto at = [&](std::size_t i) { return cells.begin() + static_cast<std::ptrdiff_t>(i); };
    const auto middle = std::stable_partition(
        at(some.from), at(some.to), [&](const Cell& cell) { return cell.mean(some.axis) < mean; });
    auto parted = static_cast<std::size_t>(middle - cells.begin());
    if (parted == some.from || parted == some.to)
      parted = (some.from + some.to) / 2;  // all the same
    *worst = shades_of(cells, some.from, parted);
    all.push_back(shades_of(cells, parted, some.to));
  }
  std::vector<Rgb> palette;
  for (const Shades& some : all) {
    Rgb color;
    for (std::size_t k = 0; k < 3; ++k)
      color[k] = static_cast<std::uint8_t>(some.all.mean(k) + 0.5);
    palette.push_back(color);
  }
  return palette;
}

/// Maps pixels to the palette. A fixed pattern (Bayer's, 8 x 8) shifts each pixel before the
/// nearest colour is taken.
class Nearest {
 public:
  explicit Nearest(const std::vector<Rgb>& palette)
      : palette_(palette), known_(std::size_t{1} << 24, kUnknown) {}

  std::uint8_t of(const std::uint8_t* rgb, int x, int y) {
    constexpr int kStrength = 5;  // levels between the least and the most
    const int move = bayer(x, y) * kStrength / 64 - kStrength / 2;
    std::array<int, 3> color;
    std::size_t place = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      color[k] = std::clamp(rgb[k] + move, 0, 255);
      place = place << 8 | static_cast<std::size_t>(color[k]);
    }
    if (known_[place] == kUnknown) known_[place] = look(color);
    return static_cast<std::uint8_t>(known_[place]);
  }

 private:
  static constexpr std::uint16_t kUnknown = 0xffff;

  static int bayer(int x, int y) {
    int value = 0;
    for (int bit = 0; bit < 3; ++bit) {
      const int a = x >> bit & 1, b = y >> bit & 1;
      value = value << 2 | (a ^ b) << 1 | b;
    }
    return value;  // 0..63
  }
  std::uint16_t look(const std::array<int, 3>& color) const {
    // Weighted like the eye: green most, blue least.
    constexpr std::array<int, 3> kWeight{3, 6, 2};
    int least = 1 << 30;
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < palette_.size(); ++i) {
      int apart = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const int d = color[k] - palette_[i][k];
        apart += kWeight[k] * d * d;
      }
      if (apart < least) least = apart, nearest = i;
    }
    return static_cast<std::uint16_t>(nearest);
  }

  const std::vector<Rgb>& palette_;
  std::vector<std::uint16_t> known_;
};

bool alike(const Rgb& shown, const std::uint8_t* rgb) {
  for (std::size_t k = 0; k < 3; ++k)
    if (std::abs(shown[k] - rgb[k]) > kAlike) return false;
  return true;
}

/// The smallest rectangle around everything that is not kUnchanged.
struct Part {
  int left = 0, top = 0, right = 1, bottom = 1;
};
Part part_of(const std::vector<std::uint8_t>& pixels, int width, int height) {
  Part part{width, height, 0, 0};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                             static_cast<std::size_t>(x);
      if (pixels[at] == kUnchanged) continue;
      part = {std::min(part.left, x), std::min(part.top, y), std::max(part.right, x + 1),
              std::max(part.bottom, y + 1)};
    }
  return part.right == 0 ? Part{} : part;  // nothing has changed: one pixel that shows nothing
}

int append(GifFileType* file, const GifByteType* bytes, int count) {
  auto& out = *static_cast<std::vector<std::byte>*>(file->UserData);
  const std::span all(reinterpret_cast<const std::byte*>(bytes), static_cast<std::size_t>(count));
  out.insert(out.end(), all.begin(), all.end());
  return count;
}

/// giflib fails at nothing but memory: append() takes all that it writes.
void must(int result) {
  if (result == GIF_ERROR) throw std::bad_alloc();
}

}  // namespace

std::vector<std::byte> write_gif(int width, int height, int hundredths,
                                 std::span<const std::uint8_t> rgb) {
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  const std::vector<Rgb> palette = palette_of(rgb);
  Nearest nearest(palette);

  // 1. Size, palette, and the endless loop.
  std::vector<std::byte> out;
  const auto close = [](GifFileType* gif) { EGifCloseFile(gif, nullptr); };
  std::unique_ptr<GifFileType, decltype(close)> gif(EGifOpen(&out, append, nullptr));
  const std::unique_ptr<ColorMapObject, decltype(&GifFreeMapObject)> colors(
      GifMakeMapObject(256, nullptr), GifFreeMapObject);
  if (!gif || !colors) throw std::bad_alloc();
  for (std::size_t i = 0; i < palette.size(); ++i)
    colors->Colors[i] = {palette[i][0], palette[i][1], palette[i][2]};
  EGifSetGifVersion(gif.get(), true);
  must(EGifPutScreenDesc(gif.get(), width, height, 8, 0, colors.get()));
  must(EGifPutExtensionLeader(gif.get(), APPLICATION_EXT_FUNC_CODE));
  must(EGifPutExtensionBlock(gif.get(), 11, "NETSCAPE2.0"));
  must(EGifPutExtensionBlock(gif.get(), 3, "\x01\0\0"));
  must(EGifPutExtensionTrailer(gif.get()));

  // 2. The part of each picture that differs from the one before.
  const GraphicsControlBlock control{DISPOSE_DO_NOT, false, hundredths, kUnchanged};
  std::array<GifByteType, 4> control_bytes;
  EGifGCBToExtension(&control, control_bytes.data());
  std::vector<std::uint8_t> before(pixels, kUnchanged), now(pixels), drawn(pixels);
  for (std::size_t from = 0; from + 3 * pixels <= rgb.size(); from += 3 * pixels) {
    for (std::size_t i = 0; i < pixels; ++i) {
      const auto x = static_cast<int>(i % static_cast<std::size_t>(width));
      const auto y = static_cast<int>(i / static_cast<std::size_t>(width));
      const std::uint8_t* const pixel = &rgb[from + 3 * i];
      // A pixel whose colour is still right stays: a shade that moves slowly would flicker between
      // two colours of the palette, and take a quarter more room.
      const bool stays = before[i] != kUnchanged && alike(palette[before[i]], pixel);
      now[i] = stays ? before[i] : nearest.of(pixel, x, y);
      drawn[i] = now[i] == before[i] ? kUnchanged : now[i];
    }
    const Part part = part_of(drawn, width, height);
    const int across = part.right - part.left;
    must(EGifPutExtension(gif.get(), GRAPHICS_EXT_FUNC_CODE, 4, control_bytes.data()));
    must(EGifPutImageDesc(gif.get(), part.left, part.top, across, part.bottom - part.top, false,
                          nullptr));
    for (int y = part.top; y < part.bottom; ++y)
      must(EGifPutLine(gif.get(),
                       &drawn[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                              static_cast<std::size_t>(part.left)],
                       across));
    std::swap(before, now);
  }
  must(EGifCloseFile(gif.release(), nullptr));
  return out;
}

}  // namespace onggi::encoding
