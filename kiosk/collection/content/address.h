#pragma once

#include <cstddef>
#include <string>

namespace onggi::content {

/// Longest address, bytes: phones can still read the modules of its QR code.
inline constexpr std::size_t kLongestAddress = 200;

/// Why a phone cannot open `address` as a web page, as a sentence; "" if it can: https, a host with
/// a dot, no name or password before it, at most kLongestAddress ASCII letters without spaces,
/// quotes and control characters. Allocates.
std::string fault_of_address(const std::string& address);

/// A good address in the form that people read and type: without https://, www. and a last slash.
/// If it has more than 40 letters, only the host, which can be typed and leads at least to the
/// museum.
std::string short_address(const std::string& address);

}  // namespace onggi::content
