#pragma once

#include <string>
#include <string_view>

namespace onggi::secrets {

/// SHA-256 of `secret` in 64 letters. For secrets of 128 random bits and more: nobody finds those
/// again, quick as it is. A passphrase needs another (console::People).
std::string digest_of(std::string_view secret);

/// True if both are the same; takes as long wherever they differ.
bool same_secret(std::string_view a, std::string_view b);

}  // namespace onggi::secrets
