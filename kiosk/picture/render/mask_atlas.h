#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "kiosk/picture/render/gl.h"

namespace onggi::render {

/// Coverage masks side by side in a few large textures, so that what lies in one of them is drawn
/// in one call. Masks stand in rows as high as their first; a page that is full stays so until it
/// goes as a whole.
class MaskAtlas {
 public:
  static constexpr int kPage = 2048;  ///< Texels a side.
  static constexpr std::size_t kMostBytes = 48u << 20;

  struct Place {
    std::uint32_t page = 0;  ///< Its number, never used twice.
    int x = 0, y = 0;
  };
  /// Uploads width x height bytes, rows from the top. A mask larger than a page has one of its own.
  Place add(int width, int height, const std::uint8_t* mask);
  /// The page is there, and is in use from now on until end_of_use().
  const Texture& use(std::uint32_t page);
  void end_of_use() { ++now_; }
  /// The page that has been out of use longest has gone, because there was too much: its number, or
  /// 0. What is in use stays, however much it is.
  std::uint32_t drop_one();

 private:
  struct Page {
    std::uint32_t number = 0;
    Texture texture;
    int x = 0, y = 0, row = 0;  // where the next mask goes, and how high its row is
    std::uint64_t used = 0;
  };
  Page& room_for(int width, int height);

  std::vector<std::unique_ptr<Page>> pages_;
  std::size_t bytes_ = 0;
  std::uint32_t last_ = 0;
  std::uint64_t now_ = 1;
};

}  // namespace onggi::render
