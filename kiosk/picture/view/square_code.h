#pragma once

#include <string>
#include <vector>

#include "kiosk/picture/view/frame.h"

namespace onggi::view {

/// A QR code (ISO/IEC 18004) as plain values: its dark modules, and its drawing. Dark ink on the
/// existing plaster, with the standard's quiet zone of four modules around it.
class SquareCode {
 public:
  static constexpr int kQuiet = 4;  ///< Modules on every side.

  /// Empty; takes no space.
  SquareCode() = default;
  /// Encodes `words` byte by byte, with medium error correction (15 %) or more if that is free.
  /// Empty for no words, or for too many. Allocates.
  explicit SquareCode(const std::string& words);

  bool empty() const { return side_ == 0; }
  int side() const { return side_; }  ///< Modules, without the quiet zone.
  bool dark(int x, int y) const { return dark_[static_cast<std::size_t>(y * side_ + x)]; }

  /// Whole pixels of one module if code and quiet zone should be about `wanted` pixels wide: at
  /// least two, so that a camera can separate them.
  int module(float wanted) const;
  /// Pixels of code and quiet zone at that size.
  float width(float wanted) const;
  /// Draws it with its quiet zone's corner at (x, y), rounded to whole pixels: a box of ink for
  /// each run of dark modules in a row. Allocates.
  void draw(std::vector<Item>& items, float x, float y, float wanted) const;

 private:
  int side_ = 0;
  std::vector<bool> dark_;
};

}  // namespace onggi::view
