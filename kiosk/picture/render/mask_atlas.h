#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "kiosk/picture/render/gl.h"

namespace onggi::render {

/// Coverage masks side by side in a few large textures, so that masks in one texture need one draw
/// call. A row is as high as its first mask. A full page stays full until it is dropped.
class MaskAtlas {
 public:
  static constexpr int kPage = 2048;  ///< Texels a side.
  static constexpr std::size_t kMostBytes = 48u << 20;

  struct Place {
    std::uint32_t page = 0;  ///< Its number, which is never reused.
    int x = 0, y = 0;
  };
  /// Uploads width x height bytes, rows from the top. A mask larger than a page has its own page.
  Place add(int width, int height, const std::uint8_t* mask);
  /// The page's texture, which must exist; it is then in use until end_of_use().
  const Texture& use(std::uint32_t page);
  void end_of_use() { ++now_; }
  /// If there are too many pages, drops the one unused for longest and returns its number, else 0.
  /// Pages in use stay, however many there are.
  std::uint32_t drop_one();

 private:
  struct Page {
    std::uint32_t number = 0;
    Texture texture;
    int x = 0, y = 0, row = 0;  // place of the next mask, and its row's height
    std::uint64_t used = 0;
  };
  Page& room_for(int width, int height);

  std::vector<std::unique_ptr<Page>> pages_;
  std::size_t bytes_ = 0;
  std::uint32_t last_ = 0;
  std::uint64_t now_ = 1;
};

}  // namespace onggi::render
