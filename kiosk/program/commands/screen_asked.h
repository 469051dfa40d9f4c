#pragma once

#include <cstddef>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/picture/view/image.h"

namespace onggi::commands {

/// `onggi screen` for the staff's page (console::ScreenDrawer), which may run as another user: its
/// standard input and output are one socket. The page sends the words of the command, each with a
/// zero byte behind it, and an empty one at the end. The answer is a line of JSON, {done, pictures:
/// [{width, height, bytes}]} or {done: false, where, what, remedy}, then the pictures' bytes.

/// Becomes `onggi screen --page` with the words that standard input brings. Returns only where that
/// cannot be.
Result<int> become_asked();

/// From now on this process works only while nothing else wants the processor, and it ends as soon
/// as whoever asked has closed standard input. Call it before there are other threads, which are
/// then as patient. It starts one.
void be_idle_until_left();

/// The answer: `files`, of `pictures`, or why there is none.
Result<int> answer_page(Result<std::vector<std::vector<std::byte>>> files,
                        const std::vector<view::Image>& pictures);

}  // namespace onggi::commands
