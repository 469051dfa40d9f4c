#pragma once

#include <string>

#include "kiosk/collection/content/vessel.h"

namespace onggi::content {

/// A vessel.toml for `vessel`, filled in as far as its file allows, with comments for what the
/// curator must add.
std::string pack_toml(const Vessel& vessel);

}  // namespace onggi::content
