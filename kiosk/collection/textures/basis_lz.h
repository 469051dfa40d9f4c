#pragma once

#include <cstdint>
#include <span>

#include "kiosk/collection/textures/texture_pixels.h"

namespace onggi::textures {

/// Decodes a level of a BasisLZ/ETC1S picture: KTX 2.0 specification, appendices "BasisLZ Global
/// Data" and "BasisLZ/ETC1S Bitstream". `global` is the supercompression global data of `images`
/// levels, `level` the bytes of the wanted one, number `image`, of width x height pixels.
/// Transparency is ignored. Every index is checked; invalid data is refused.
Decoded decode_basis_lz(std::span<const std::uint8_t> global, std::size_t images, std::size_t image,
                        std::span<const std::uint8_t> level, int width, int height);

}  // namespace onggi::textures
