#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace onggi::toml {

/// A name that stands in a file twice, in a Problem's words.
struct WrittenTwice {
  std::string what, remedy;  ///< Whole sentences.
};

/// What toml++'s `description` of a fault at line `line` (from 1) of `text` means, where it means
/// that a name is written twice; else none. Tells the first of the two lines where one is found,
/// and asks for a forgotten [[list]] line where the file has such a list. Reads `text` once;
/// allocates.
std::optional<WrittenTwice> written_twice(std::string_view description, const std::string& text,
                                          std::size_t line);

}  // namespace onggi::toml
