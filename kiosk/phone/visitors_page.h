#pragma once

#include <string>

namespace onggi::phone {

/// The pages, whole. `languages` is a phone's Accept-Language: the first of English and Korean that
/// it names, else English.
std::string visitors_page(const std::string& token, const std::string& languages);
std::string nothing_page(const std::string& languages);
std::string deleted_page(const std::string& languages);
std::string not_deleted_page(const std::string& languages);

/// From kiosk/phone/page/, in the program so that it needs no file beside it.
extern const char* const k_page_js;
extern const char* const k_page_css;

}  // namespace onggi::phone
