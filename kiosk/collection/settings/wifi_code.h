#pragma once

#include <string>

namespace onggi::settings {

/// What a phone's camera joins a network by, as words of a square code:
/// "WIFI:T:WPA;S:Onggi;P:...;;". Without a password it is an open one. "" for no network.
/// Allocates.
std::string wifi_code(const std::string& network, const std::string& password);

}  // namespace onggi::settings
