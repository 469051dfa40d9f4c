#pragma once

#include <string>

namespace onggi::settings {

/// The text of a QR code with which a phone's camera joins a network: "WIFI:T:WPA;S:Onggi;P:...;;".
/// Without a password the network is open. "" for no network. Allocates.
std::string wifi_code(const std::string& network, const std::string& password);

}  // namespace onggi::settings
