#pragma once

namespace onggi::console {

/// The page's own files (page/), compiled in.
extern const char* const k_staff_html;
extern const char* const k_door_html;
extern const char* const k_print_html;
extern const char* const k_base_js;
extern const char* const k_edit_js;
extern const char* const k_settings_js;
extern const char* const k_shelf_js;
extern const char* const k_lists_js;
extern const char* const k_scan_js;
extern const char* const k_scenes_js;
extern const char* const k_words_js;
extern const char* const k_look_js;
extern const char* const k_staff_js;
extern const char* const k_print_js;
extern const char* const k_door_js;
extern const char* const k_staff_css;
extern const char* const k_staff_svg;

}  // namespace onggi::console
