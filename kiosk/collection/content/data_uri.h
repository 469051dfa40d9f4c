#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace onggi::content {

/// True if `text`, from between the quotes of a JSON string, is a base64 data URI (RFC 2397):
/// data:application/octet-stream;base64,AAAA
bool is_data_uri(std::span<const unsigned char> text);

/// Upper bound of its decoded bytes, from its length alone; nothing is decoded.
std::size_t most_bytes_in(std::span<const unsigned char> uri);

/// Decodes `uri`, up to `most` bytes, in place, because the result is shorter: a scan of half a
/// gigabyte needs no extra memory. Returns the bytes, which begin where `uri` began; none if a
/// character is not base64. Understands JSON's escapes of '/' and of \u0000..\u007F. Allocates
/// nothing.
std::optional<std::span<unsigned char>> decode_data_uri(std::span<unsigned char> uri,
                                                        std::size_t most);

}  // namespace onggi::content
