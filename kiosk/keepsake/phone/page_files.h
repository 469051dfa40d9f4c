#pragma once

namespace onggi::phone {

/// Files of kiosk/keepsake/phone/page/ and the English words, compiled in so that the program needs
/// no file.
extern const char* const k_page_js;
extern const char* const k_page_css;
extern const char* const k_page_svg;
extern const char* const k_en_toml;

}  // namespace onggi::phone
