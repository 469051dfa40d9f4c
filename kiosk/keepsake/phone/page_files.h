#pragma once

namespace onggi::phone {

/// From kiosk/keepsake/phone/page/, and the English words, in the program so that it needs no file
/// beside it.
extern const char* const k_page_js;
extern const char* const k_page_css;
extern const char* const k_page_svg;
extern const char* const k_en_toml;

}  // namespace onggi::phone
