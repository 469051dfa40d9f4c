#pragma once

#include <string>
#include <string_view>

namespace onggi::terminal {

/// `text` as a terminal and a log may show it, whoever wrote it: a '?' stands for each control
/// character (line breaks and the two-byte ones of U+0080..9F too), each sign that turns the
/// direction of writing, and each byte that is no UTF-8. So a name in a file can neither move the
/// cursor nor pretend to be a line of the program's. Allocates.
std::string plain(std::string_view text);

}  // namespace onggi::terminal
