#pragma once

#include <optional>
#include <string>

namespace onggi::toml {

/// The values of a TOML text as JSON, for a browser: tables as objects, dates as texts. None where
/// `text` is no TOML. Allocates; any thread.
std::optional<std::string> json_of(const std::string& text);

}  // namespace onggi::toml
