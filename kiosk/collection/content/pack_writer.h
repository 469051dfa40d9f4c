#pragma once

#include <string>

#include "kiosk/collection/content/vessel.h"

namespace onggi::content {

/// A vessel.toml for `vessel`, filled in as far as its file tells, with what is left to the curator
/// in comments.
std::string pack_toml(const Vessel& vessel);

}  // namespace onggi::content
