#pragma once

#include <cstddef>
#include <string>

namespace onggi::content {

/// Bytes of the longest address: a square code of it still has modules that a phone tells apart.
inline constexpr std::size_t kLongestAddress = 200;

/// What keeps a phone from opening `address` as a page on the web, as a sentence; "" where nothing
/// does: https, a host with a dot, no name or password before it, at most kLongestAddress letters
/// of ASCII without spaces, quotes and control characters. Allocates.
std::string fault_of_address(const std::string& address);

/// A good address as a person reads and types it: without https://, www. and a last slash. One of
/// more than 40 letters is its host alone, which can be typed and leads to the museum at least.
std::string short_address(const std::string& address);

}  // namespace onggi::content
