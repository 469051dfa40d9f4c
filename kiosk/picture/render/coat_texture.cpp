#include "kiosk/picture/render/coat_texture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "engine/surface/outline_rows.h"

namespace onggi::render {
namespace {

using decoration::CoatPicture;
using Texel = CoatPicture::Texel;

constexpr float kBeadMetres = 1e-6f * CoatPicture::kBeadUnit;  // of a unit

/// Texels of a strip of tiles, row by row.
struct Strip {
  int width = 0, height = 0;
  std::vector<Texel> texels;
  Strip(int w, int h)
      : width(w), height(h), texels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
  Texel& at(int x, int y) {
    return texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
  const Texel& at(int x, int y) const { return const_cast<Strip*>(this)->at(x, y); }
};

std::uint8_t times(int color, int cover) {
  return static_cast<std::uint8_t>((color * cover + 127) / 255);
}

/// Each channel by itself.
Texel mean_of(const std::array<Texel, 4>& of) {
  Texel out{};
  for (std::size_t k = 0; k < 4; ++k)
    out[k] = static_cast<std::uint8_t>((of[0][k] + of[1][k] + of[2][k] + of[3][k] + 2) / 4);
  return out;
}

/// Light is averaged by its cover, not its square root, which a texel holds times the cover.
Texel mean_of_paint(const std::array<Texel, 4>& of) {
  Texel out = mean_of(of);
  const bool even =
      std::all_of(of.begin() + 1, of.end(), [&](const Texel& t) { return t == of[0]; });
  const int cover = of[0][3] + of[1][3] + of[2][3] + of[3][3];
  if (even || cover == 0) return out;
  for (std::size_t k = 0; k < 3; ++k) {
    float light = 0;
    for (const Texel& t : of)
      if (t[3] > 0) light += static_cast<float>(t[k] * t[k]) / static_cast<float>(t[3]);
    const float root = std::sqrt(light / static_cast<float>(cover));  // 0..1
    out[k] = static_cast<std::uint8_t>(
        std::min(root * 0.25f * static_cast<float>(cover) + 0.5f, 255.0f));
  }
  return out;
}

/// The mean of neighbours by 1, 2, 1, of `count` texels `step` apart.
void smooth(Texel* texels, int count, std::ptrdiff_t step) {
  Texel before = *texels;
  for (int n = 0; n < count; ++n, texels += step) {
    const Texel now = *texels, &next = n + 1 < count ? texels[step] : now;
    for (std::size_t k = 0; k < 4; ++k)
      (*texels)[k] = static_cast<std::uint8_t>((before[k] + 2 * now[k] + next[k] + 2) / 4);
    before = now;
  }
}

/// Smooths the stairs of cells at slanting edges. Each tile by itself: so a tile is the same
/// whatever is uploaded with it, and at its border a stair more or less is not seen.
void smooth_tiles(Strip& strip) {
  for (int left = 0; left < strip.width; left += CoatPicture::kTileColumns) {
    const int right = left + CoatPicture::kTileColumns;
    bool even = true;
    for (int y = 0; y < strip.height && even; ++y)
      even = std::all_of(&strip.at(left, y), &strip.at(left, y) + CoatPicture::kTileColumns,
                         [&](const Texel& t) { return t == strip.at(left, 0); });
    if (even) continue;
    for (int x = left; x < right; ++x) smooth(&strip.at(x, 0), strip.height, strip.width);
    for (int y = 0; y < strip.height; ++y) smooth(&strip.at(left, y), right - left, 1);
  }
}

template <class Mean>
Strip reduced(const Strip& fine, Mean mean) {
  Strip out(fine.width / 2, fine.height / 2);
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x)
      out.at(x, y) = mean({fine.at(2 * x, 2 * y), fine.at(2 * x + 1, 2 * y),
                           fine.at(2 * x, 2 * y + 1), fine.at(2 * x + 1, 2 * y + 1)});
  return out;
}

/// Texels [first, last) of the rows of one tile, with the last row of the picture above it.
Strip strip_of(const std::vector<Texel>& picture, int width, int height, int row, int first,
               int last) {
  Strip out(last - first, CoatPicture::kTileRows);
  for (int y = 0; y < out.height; ++y) {
    const auto from = static_cast<std::ptrdiff_t>(std::min(row + y, height - 1)) * width;
    std::copy(picture.begin() + from + first, picture.begin() + from + last, &out.at(0, y));
  }
  return out;
}

template <class Mean>
void upload(const Texture& texture, Strip strip, int x, int y, Mean mean) {
  calls::bind_texture(texture.name.get());
  for (int level = 0; level < CoatTexture::kLevels; ++level, x /= 2, y /= 2) {
    if (level > 0) strip = reduced(strip, mean);
    calls::texture_part(x, y, strip.width, strip.height, GL_RGBA, GL_UNSIGNED_BYTE,
                        strip.texels.data(), 0, level);
  }
}

Texture room_for(int width, int height) {
  Texture out = Texture::create(GL_RGBA8, width, height, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  for (int level = 1; level < CoatTexture::kLevels; ++level)
    calls::texture_image(level, GL_RGBA8, width >> level, height >> level, GL_RGBA,
                         GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, CoatTexture::kLevels - 1);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  // Goes round the pot; foot and floor are ends.
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
  return out;
}

}  // namespace

void CoatTexture::make_room(const CoatPicture& coat) {
  width_ = coat.width();
  height_ = coat.height();
  const int rows = coat.tiles_down() * CoatPicture::kTileRows;
  paint_ = room_for(width_, rows);
  form_ = room_for(width_, rows);
  changes_.assign(static_cast<std::size_t>(coat.tiles_down() * coat.tiles_across()), 0);
  by_height_.clear();
  beads_.clear();
}

void CoatTexture::send(const CoatPicture& coat, int down, int from, int to) {
  const int x = from * CoatPicture::kTileColumns, y = down * CoatPicture::kTileRows;
  const int last = to * CoatPicture::kTileColumns;
  Strip paint = strip_of(coat.paint(), width_, height_, y, x, last);
  for (Texel& t : paint.texels)
    for (std::size_t k = 0; k < 3; ++k) t[k] = times(t[k], t[3]);
  smooth_tiles(paint);
  upload(paint_, std::move(paint), x, y, mean_of_paint);
  Strip form = strip_of(coat.form(), width_, height_, y, x, last);
  // Glaze runs; cuts stay sharp.
  if (glazed_) smooth_tiles(form);
  upload(form_, std::move(form), x, y, mean_of);
}

void CoatTexture::show(const CoatPicture* coat) {
  shown_ = coat != nullptr && coat->height() > 0;
  if (!shown_) return;
  if (coat->width() != width_ || coat->height() != height_) make_room(*coat);
  glazed_ = coat->glazed();
  melted_ = coat->melted();
  const float used = static_cast<float>(height_) / static_cast<float>(paint_.height);
  floor_from_ = used * coat->floor_from();
  floor_to_ = used;
  if (by_height_ != coat->rows_by_height()) {
    by_height_ = coat->rows_by_height();
    std::vector<std::array<float, 2>> rows = by_height_;
    for (auto& both : rows)
      for (float& row : both) row *= used;
    rows_ =
        Texture::create(GL_RG32F, static_cast<int>(rows.size()), 1, GL_RG, GL_FLOAT, rows.data());
  }
  if (coat->change() == change_) return;
  // Neighbouring tiles that have changed go together.
  const int across = coat->tiles_across();
  for (int down = 0; down < coat->tiles_down(); ++down)
    for (int from = 0, to = 0; from < across; from = to + 1) {
      const auto fresh = [&](int column) {
        return coat->change(down, column) !=
               changes_[static_cast<std::size_t>(down * across + column)];
      };
      to = from;
      while (to < across && fresh(to)) {
        changes_[static_cast<std::size_t>(down * across + to)] = coat->change(down, to);
        ++to;
      }
      if (to > from) send(*coat, down, from, to);
    }
  change_ = coat->change();
  show_beads(*coat);
}

void CoatTexture::show_beads(const CoatPicture& coat) {
  if (beads_ == coat.beads()) return;
  beads_ = coat.beads();
  has_beads_ =
      std::any_of(beads_.begin(), beads_.end(), [](std::uint8_t high) { return high > 0; });
  const int across = has_beads_ ? width_ / CoatPicture::kBeadColumns : 1,
            rows = has_beads_ ? static_cast<int>(beads_.size()) / across : 1;
  bead_texture_ = Texture::create(GL_R8, across, rows, GL_RED, GL_UNSIGNED_BYTE, beads_.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
}

float CoatTexture::bead_at(float round, float up) const {
  if (!has_beads()) return 0.0f;
  // As the shader reads both tables, between their texels.
  const auto last = static_cast<float>(by_height_.size() - 1);
  const float at = std::clamp(up, 0.0f, 1.0f) * last, low = std::floor(at);
  const auto n = static_cast<std::size_t>(low);
  const float share =
      std::lerp(by_height_[n][0], by_height_[std::min(n + 1, by_height_.size() - 1)][0], at - low);
  const int across = width_ / CoatPicture::kBeadColumns,
            rows = static_cast<int>(beads_.size()) / across;
  const float x = (round - std::floor(round)) * static_cast<float>(across) - 0.5f,
              y = std::clamp(share * static_cast<float>(height_) / CoatPicture::kBeadRows - 0.5f,
                             0.0f, static_cast<float>(rows - 1));
  const float left = std::floor(x), down = std::floor(y);
  const auto texel = [&](int column, int row) {
    const std::size_t at_column = static_cast<std::size_t>((column + across) % across),
                      at_row = static_cast<std::size_t>(std::min(row, rows - 1));
    return static_cast<float>(beads_[at_row * static_cast<std::size_t>(across) + at_column]);
  };
  const auto i = static_cast<int>(left), j = static_cast<int>(down);
  const float lower = std::lerp(texel(i, j), texel(i + 1, j), x - left),
              upper = std::lerp(texel(i, j + 1), texel(i + 1, j + 1), x - left);
  return kBeadMetres * std::lerp(lower, upper, y - down);
}

void CoatTexture::set(const Program& program, float pixel, int unit) const {
  paint_.bind(unit);
  program.set("paint", unit);
  form_.bind(unit + 1);
  program.set("form", unit + 1);
  rows_.bind(unit + 2);
  program.set("coat_rows", unit + 2);
  bead_texture_.bind(unit + 3);
  program.set("beads", unit + 3);
  program.set("most_bead", 255.0f * kBeadMetres);
  program.set("floor_rows", glm::vec2(floor_from_, floor_to_));
  program.set("floor_ends", static_cast<float>(surface::kLeastRadius));
  program.set("own_glaze", glazed_ ? 1.0f : 0.0f);
  program.set("molten", melted_ ? 1.0f : 0.0f);
  program.set("coat_places", fine_ ? 4.0f : 1.0f);
  const float cell = 1e-6f * surface::kRowHeight;
  program.set("coat_level", std::clamp(std::round(std::log2(pixel / cell)), 0.0f,
                                       static_cast<float>(kLevels - 1)));
}

}  // namespace onggi::render
