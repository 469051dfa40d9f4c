#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace onggi::encoding {

/// An endless animated GIF (GIF89a): `rgb` holds picture after picture, three bytes a pixel, of
/// `width` x `height` (1..65535 each); each is shown for `hundredths` of a second. All share one
/// palette of 255 colours and one dither pattern, so that still parts stay still; a pixel changes
/// only when its colour is more than three levels off. The same pictures give the same bytes.
/// Allocates about 40 MB of working memory; only in the helper.
std::vector<std::byte> write_gif(int width, int height, int hundredths,
                                 std::span<const std::uint8_t> rgb);

}  // namespace onggi::encoding
