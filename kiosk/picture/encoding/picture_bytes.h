#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "kiosk/picture/encoding/encode.h"

namespace onggi::encoding {

/// True for a complete PNG, JPEG or GIF: first bytes and end mark.
bool is_whole(std::span<const std::byte> bytes, Format format);

/// `png` with title, copyright, description and software as chunks after its header: tEXt for
/// ASCII, which every reader shows; iTXt for other text, because tEXt only knows Latin-1 and would
/// garble 달항아리. Empty texts are left out. `png` must be complete.
std::vector<std::byte> with_texts(std::span<const std::byte> png, const Caption& caption,
                                  const std::string& software);

/// `gif` with the same texts as comments at its end, UTF-8. Empty texts are left out. `gif` must be
/// complete.
std::vector<std::byte> with_comments(std::span<const std::byte> gif, const Caption& caption,
                                     const std::string& software);

}  // namespace onggi::encoding
