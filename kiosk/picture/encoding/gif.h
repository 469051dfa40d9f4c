#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace onggi::encoding {

/// An animated GIF without end (GIF89a): `rgb` has picture after picture, three bytes a pixel, of
/// `width` x `height` (1..65535 each); each stands for `hundredths` of a second. All have one
/// palette of 255 colours and one pattern of dither, so that what stands still in them stands still
/// in it. The same pictures give the same bytes. Allocates some 40 MB beside; in the helper alone.
std::vector<std::byte> write_gif(int width, int height, int hundredths,
                                 std::span<const std::uint8_t> rgb);

}  // namespace onggi::encoding
