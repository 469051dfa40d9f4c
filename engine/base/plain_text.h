#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace onggi::terminal {

/// `text` made safe for a terminal and a log: a '?' replaces each control character (also line
/// breaks, and the two-byte ones of U+0080..9F), each character that changes the writing direction,
/// and each byte that is not UTF-8. A name in a file can then neither move the cursor nor look like
/// one of the program's lines. Allocates.
std::string plain(std::string_view text);

/// plain(text) in exactly `width` terminal columns, for tables: padded with blanks, or cut between
/// two characters. A Chinese, Japanese or Korean character and a picture take two columns, and a
/// combining mark none (the wide blocks of Unicode's East Asian Width). Allocates.
std::string column(std::string_view text, std::size_t width);

/// Columns that `text`, which is UTF-8, takes in such a table.
std::size_t columns(std::string_view text);

}  // namespace onggi::terminal
