#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace onggi::terminal {

/// `text` as a terminal and a log may show it, whoever wrote it: a '?' stands for each control
/// character (line breaks and the two-byte ones of U+0080..9F too), each sign that turns the
/// direction of writing, and each byte that is no UTF-8. So a name in a file can neither move the
/// cursor nor pretend to be a line of the program's. Allocates.
std::string plain(std::string_view text);

/// plain(text) in exactly `width` columns of a terminal, for tables: filled with blanks, or cut
/// between two characters. A Chinese, Japanese or Korean character and a picture take two columns,
/// a mark on the character before it none (the wide blocks of Unicode's East Asian Width).
/// Allocates.
std::string column(std::string_view text, std::size_t width);

}  // namespace onggi::terminal
