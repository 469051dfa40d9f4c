#pragma once

#include <cstddef>

namespace onggi::web {

/// Files and connections that this process may have open at once; first raised to `wanted` as far
/// as the system lets it.
std::size_t descriptor_limit(std::size_t wanted);

}  // namespace onggi::web
