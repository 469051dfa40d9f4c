#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "kiosk/collection/textures/texture_pixels.h"

namespace onggi::content {

/// What onggi-texture is given: a file's pictures, one after the other, each behind its length.
std::vector<std::byte> order_bytes(std::span<const std::span<const std::uint8_t>> pictures);
/// The pictures of an order; none where it is cut off. They lie in `bytes`.
std::vector<std::span<const std::uint8_t>> pictures_of(std::span<const std::uint8_t> bytes);

/// What it answers: of each picture its pixels, or why there are none.
std::vector<std::byte> answer_bytes(const std::vector<textures::Decoded>& decoded);
/// An answer of `count` pictures of at most `most_side` pixels a side; nothing of it is believed
/// that was not checked. Empty where it is no whole answer.
std::vector<textures::Decoded> answers_of(std::span<const std::byte> bytes, std::size_t count,
                                          unsigned most_side);

}  // namespace onggi::content
