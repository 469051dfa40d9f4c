#pragma once

#include <span>

#include "kiosk/collection/settings/setting.h"

namespace onggi::settings {

/// Every setting of exhibit.toml, in the order of the page, tables together. A new setting is its
/// member in Exhibit, with its default, and a row here; then `ONGGI_WRITE=1` for
/// exhibit_settings_test.cpp writes it into config/exhibit.toml and config/README.md. Not listed
/// are the tables whose keys are languages, vessels or days: [title], [vessel_scenes], [hours].
std::span<const Setting> exhibit_settings();

}  // namespace onggi::settings
