#pragma once

#include <string_view>

namespace onggi::phone {

/// What a phone, tablet or computer asks a network that it has just joined, and the answer that
/// tells it that all is well. Without it, it would go back to another network, or open a page that
/// asks to log in: behind the kiosk's own access point there is nothing to log in to.
struct Probe {
  std::string_view path;  ///< "/generate_204"
  int status;             ///< 200, or 204 with an empty body
  std::string_view type;
  std::string_view body;  ///< To the byte.
};

/// The probe that asks for `target`, whatever stands behind a '?'; null where it is none.
const Probe* probe_of(std::string_view target);

}  // namespace onggi::phone
