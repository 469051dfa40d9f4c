#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "kiosk/picture/encoding/encode.h"

namespace onggi::encoding {

/// Is this the whole of a PNG, JPEG or GIF: its first bytes and its closing mark?
bool is_whole(std::span<const std::byte> bytes, Format format);

/// `png` with title, copyright, description and software as chunks behind its header: tEXt for
/// ASCII, which every reader shows; iTXt for all else, as tEXt knows Latin-1 only and would garble
/// 달항아리. Empty texts are left out. `png` must be whole.
std::vector<std::byte> with_texts(std::span<const std::byte> png, const Caption& caption,
                                  const std::string& software);

/// `gif` with the same as comments at its end, UTF-8. Empty texts are left out. `gif` must be
/// whole.
std::vector<std::byte> with_comments(std::span<const std::byte> gif, const Caption& caption,
                                     const std::string& software);

}  // namespace onggi::encoding
