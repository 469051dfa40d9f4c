#include "kiosk/picture/view/square_code.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <qrcodegen/qrcodegen.hpp>

#include "kiosk/picture/view/palette.h"

namespace onggi::view {

SquareCode::SquareCode(const std::string& words) {
  if (words.empty()) return;
  try {
    const auto code = qrcodegen::QrCode::encodeBinary(
        std::vector<std::uint8_t>(words.begin(), words.end()), qrcodegen::QrCode::Ecc::MEDIUM);
    side_ = code.getSize();
    for (int y = 0; y < side_; ++y)
      for (int x = 0; x < side_; ++x) dark_.push_back(code.getModule(x, y));
  } catch (const qrcodegen::data_too_long&) {
    side_ = 0;
  }
}

int SquareCode::module(float wanted) const {
  return std::max(2, static_cast<int>(wanted) / (side_ + 2 * kQuiet));
}

float SquareCode::width(float wanted) const {
  return empty() ? 0.0f : static_cast<float>(module(wanted) * (side_ + 2 * kQuiet));
}

void SquareCode::draw(std::vector<Item>& items, float x, float y, float wanted) const {
  const auto px = static_cast<float>(module(wanted));
  const float left = std::round(x) + px * kQuiet, top = std::round(y) + px * kQuiet;
  for (int row = 0; row < side_; ++row)
    for (int from = 0; from < side_; ++from) {
      if (!dark(from, row)) continue;
      int to = from;
      while (to < side_ && dark(to, row)) ++to;
      items.emplace_back(
          Box{{left + px * static_cast<float>(from), top + px * static_cast<float>(row),
               px * static_cast<float>(to - from), px},
              0,
              kInk,
              0,
              {}});
      from = to;
    }
}

}  // namespace onggi::view
