#pragma once

#include "kiosk/collection/textures/srgb.h"
#include "kiosk/picture/view/frame.h"

namespace onggi::view {

/// A colour as hex: 0xEDE8E1.
constexpr Color rgb(unsigned hex, float alpha = 1.0f) {
  return {static_cast<float>((hex >> 16) & 255u) / 255.0f,
          static_cast<float>((hex >> 8) & 255u) / 255.0f, static_cast<float>(hex & 255u) / 255.0f,
          alpha};
}

/// True if they are equal except for opacity.
constexpr bool same_hue(Color a, Color b) { return a.r == b.r && a.g == b.g && a.b == b.b; }

constexpr Color with_alpha(Color c, float alpha) { return {c.r, c.g, c.b, alpha}; }

/// The exhibit's colours. Text on plaster: at least 4.5:1; meaningful lines: 3:1
/// (tests/kiosk/picture/view/palette_test.cpp).
inline constexpr Color kPlaster = rgb(0xEDE8E1);   ///< The studio's wall, and paper.
inline constexpr Color kInk = rgb(0x23201D);       ///< Words.
inline constexpr Color kFaintInk = rgb(0x5F5850);  ///< Words of second rank.
inline constexpr Color kDryClay = rgb(0xB08968);
inline constexpr Color kCeladon = rgb(0x9DB5A0);
inline constexpr Color kDeepCeladon = rgb(0x2E6B57);  ///< Celadon dark enough for a line.
inline constexpr Color kIron = rgb(0x8A3B22);
inline constexpr Color kCobalt = rgb(0x2F4B7C);      ///< The one accent: touch targets.
inline constexpr Color kHeldCobalt = rgb(0x1F3560);  ///< A target under a finger.

/// Relative luminance (WCAG 2.2) of an opaque colour, 0..1.
inline double luminance(Color c) {
  const auto linear = [](float v) { return textures::light_of_srgb(static_cast<double>(v)); };
  return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
}

/// Contrast ratio of two opaque colours, 1..21.
inline double contrast(Color a, Color b) {
  const double la = luminance(a), lb = luminance(b);
  return la > lb ? (la + 0.05) / (lb + 0.05) : (lb + 0.05) / (la + 0.05);
}

}  // namespace onggi::view
