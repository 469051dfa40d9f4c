#pragma once

#include <string_view>

namespace onggi::phone {

/// A device's check of a network that it has just joined, and the answer that makes it accept the
/// network. Without the answer it would go back to another network, or show a login page, which the
/// kiosk's access point does not have.
struct Probe {
  std::string_view path;  ///< "/generate_204"
  int status;             ///< 200, or 204 with an empty body
  std::string_view type;
  std::string_view body;  ///< Exact bytes.
};

/// The probe for `target`, ignoring text after a '?'; null if it is not a probe.
const Probe* probe_of(std::string_view target);

}  // namespace onggi::phone
