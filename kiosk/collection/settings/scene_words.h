#pragma once

#include <string>

namespace onggi::settings {

/// The sentences of a scene file's leading comment, except those that refer to other places ("What
/// each ...", "An effect is ...", or that name another page). One line.
std::string words_of_scene(const std::string& toml);

}  // namespace onggi::settings
