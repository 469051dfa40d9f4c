#pragma once

#include <cstdint>
#include <span>

#include "kiosk/collection/textures/texture_pixels.h"

namespace onggi::textures {

/// A level of a BasisLZ/ETC1S picture: KTX 2.0 specification, appendices "BasisLZ Global Data" and
/// "BasisLZ/ETC1S Bitstream". `global` is the supercompression global data of `images` levels,
/// `level` the bytes of the one that is wanted, number `image`, of width x height pixels. Its
/// transparency is left out. Every index is checked; what is not sound is refused.
Decoded decode_basis_lz(std::span<const std::uint8_t> global, std::size_t images, std::size_t image,
                        std::span<const std::uint8_t> level, int width, int height);

}  // namespace onggi::textures
