#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace onggi::content {

/// Whether `text`, as it stands between the quotes of a JSON string, is a data URI in base64
/// (RFC 2397): data:application/octet-stream;base64,AAAA
bool is_data_uri(std::span<const unsigned char> text);

/// No more bytes than this come out of it; by its length alone, nothing is decoded.
std::size_t most_bytes_in(std::span<const unsigned char> uri);

/// Decodes `uri`, up to `most` bytes, into its own place, since what is decoded is shorter: a scan
/// of half a gigabyte takes no memory beside itself. Gives the bytes, which begin where it began;
/// none where a character is not of base64. JSON's escapes of '/' and of \u0000..\u007F are
/// understood. Allocates nothing.
std::optional<std::span<unsigned char>> decode_data_uri(std::span<unsigned char> uri,
                                                        std::size_t most);

}  // namespace onggi::content
