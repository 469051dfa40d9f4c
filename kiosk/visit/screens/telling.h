#pragma once

#include "kiosk/visit/screens/show_me.h"

namespace onggi::screens {

/// Language key of the answer to "Done" before the clay was touched.
inline constexpr const char* kClayFirst = "throw.first";

/// The one sentence beside the pot, with a small drawing of the hands: `news`
/// (a language key, or "") first, then "Show me", the lesson's step, the hint. Space for the
/// longest sentence is reserved, so that no control moves under a finger. `by_keys`: the visitor
/// last used the keyboard, so the lesson names its keys.
void lay_out_telling(Column& column, const Desk& desk, const ShowMe& show, const Hint& hint,
                     bool by_keys, const std::string& news);

/// Height of the longest of those sentences, `width` pixels wide.
float longest_telling(const Page& page, const Desk& desk, float width);
/// Share of the words' width for the drawing: in portrait it is beside the sentence.
float telling_drawing(const Page& page);
/// In landscape, the least space under the sentence.
float telling_below(const Page& page);

}  // namespace onggi::screens
