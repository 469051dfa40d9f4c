#include "kiosk/picture/render/mask_atlas.h"

#include <algorithm>

namespace onggi::render {
namespace {

std::size_t bytes_of(const Texture& texture) {
  return static_cast<std::size_t>(texture.width) * static_cast<std::size_t>(texture.height);
}

}  // namespace

MaskAtlas::Page& MaskAtlas::room_for(int width, int height) {
  if (!pages_.empty()) {
    Page& page = *pages_.back();
    if (page.x + width > page.texture.width) {
      page.y += page.row;
      page.x = page.row = 0;
    }
    if (width <= page.texture.width && page.y + height <= page.texture.height) return page;
  }
  auto page = std::make_unique<Page>();
  page->number = ++last_;
  page->texture = Texture::create(GL_R8, std::max(width, kPage), std::max(height, kPage), GL_RED,
                                  GL_UNSIGNED_BYTE, nullptr);
  // Pixel for pixel: filtering could only blur it.
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  bytes_ += bytes_of(page->texture);
  pages_.push_back(std::move(page));
  return *pages_.back();
}

MaskAtlas::Place MaskAtlas::add(int width, int height, const std::uint8_t* mask) {
  Page& page = room_for(width, height);
  const Place place{page.number, page.x, page.y};
  page.used = now_;
  calls::bind_texture(page.texture.name.get());
  calls::texture_part(page.x, page.y, width, height, GL_RED, GL_UNSIGNED_BYTE, mask);
  page.x += width;
  page.row = std::max(page.row, height);
  return place;
}

const Texture& MaskAtlas::use(std::uint32_t page) {
  const auto found = std::find_if(pages_.begin(), pages_.end(),
                                  [page](const auto& one) { return one->number == page; });
  (*found)->used = now_;
  return (*found)->texture;
}

std::uint32_t MaskAtlas::drop_one() {
  if (bytes_ <= kMostBytes) return 0;
  const auto oldest = std::min_element(
      pages_.begin(), pages_.end(), [](const auto& a, const auto& b) { return a->used < b->used; });
  if ((*oldest)->used == now_) return 0;
  const std::uint32_t number = (*oldest)->number;
  bytes_ -= bytes_of((*oldest)->texture);
  pages_.erase(oldest);
  return number;
}

}  // namespace onggi::render
