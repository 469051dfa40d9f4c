#pragma once

#include <string>
#include <vector>

#include "kiosk/picture/view/frame.h"

namespace onggi::view {

/// A QR code (ISO/IEC 18004) as plain values: which modules are dark, and how it is drawn. Dark ink
/// on the plaster that is there, with the standard's quiet zone of four modules round it.
class SquareCode {
 public:
  static constexpr int kQuiet = 4;  ///< Modules on every side.

  /// None: empty, takes no room.
  SquareCode() = default;
  /// Of `words`, bytes as they are, with medium error correction (15 %) or more where that is free.
  /// Empty for no words and for more than fit a code. Allocates.
  explicit SquareCode(const std::string& words);

  bool empty() const { return side_ == 0; }
  int side() const { return side_; }  ///< Modules, without the quiet zone.
  bool dark(int x, int y) const { return dark_[static_cast<std::size_t>(y * side_ + x)]; }

  /// Whole pixels of one module where code and quiet zone are to be about `wanted` pixels wide: at
  /// least two, so that a camera tells them apart.
  int module(float wanted) const;
  /// Pixels of code and quiet zone then.
  float width(float wanted) const;
  /// Draws it with its quiet zone's corner at (x, y), moved to whole pixels: boxes of ink, a row's
  /// run of dark modules each. Allocates.
  void draw(std::vector<Item>& items, float x, float y, float wanted) const;

 private:
  int side_ = 0;
  std::vector<bool> dark_;
};

}  // namespace onggi::view
