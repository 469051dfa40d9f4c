#pragma once

#include <string>

namespace onggi::app {

/// "0.1.0", from the build.
std::string version();

}  // namespace onggi::app
