#include "kiosk/app/version.h"

#ifndef ONGGI_VERSION
#error "The build gives ONGGI_VERSION."
#endif

namespace onggi::app {

std::string version() { return ONGGI_VERSION; }

}  // namespace onggi::app
