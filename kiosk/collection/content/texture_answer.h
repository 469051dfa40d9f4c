#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "kiosk/collection/textures/texture_pixels.h"

namespace onggi::content {

/// The input of onggi-texture: a file's pictures, each after its length.
std::vector<std::byte> order_bytes(std::span<const std::span<const std::uint8_t>> pictures);
/// The pictures of an order, as spans into `bytes`; none if it is cut off.
std::vector<std::span<const std::uint8_t>> pictures_of(std::span<const std::uint8_t> bytes);

/// Its answer: for each picture its pixels, or the reason why there are none.
std::vector<std::byte> answer_bytes(const std::vector<textures::Decoded>& decoded);
/// Reads an answer of `count` pictures of at most `most_side` pixels a side, and checks every
/// number. Empty if it is incomplete.
std::vector<textures::Decoded> answers_of(std::span<const std::byte> bytes, std::size_t count,
                                          unsigned most_side);

}  // namespace onggi::content
