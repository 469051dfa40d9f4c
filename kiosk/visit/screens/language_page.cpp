#include "kiosk/visit/screens/language_page.h"

#include <utility>
#include <vector>

#include "kiosk/visit/screens/overlays.h"

namespace onggi::screens {

namespace {
constexpr float kTall = 4.0f / 3.0f;  // of the least touch target: 20 mm
}  // namespace

std::string language_control(const content::Language& language) {
  return "language." + language.code();
}

std::optional<std::size_t> language_of(const Desk& desk, const std::string& control) {
  const auto& all = *desk.world.languages;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (control == language_control(all[i])) return i;
  return std::nullopt;
}

void lay_out_languages(Page& page, const Desk& desk) {
  const TypeScale& t = page.type();
  Column column(page, page.where().page);
  // Back has the place that it has on every screen, and nothing stands where other screens have
  // their step onward: the touch after a choice is often meant for this page.
  std::vector<Button> row = reading_buttons(desk);
  row.insert(row.end() - 1, {"language.close", desk.say("all.back"), Look::quiet});
  column.foot_buttons(row);
  const Button onward{"", desk.say("all.back"), Look::outline};
  column.foot_space(t.gap + page.size(onward, page.where().page.w).height + t.gap * 2);
  std::vector<Button> cells;
  for (const content::Language& language : *desk.world.languages) {
    const bool on = &language == &desk.words();
    Button cell{language_control(language), language.name(), on ? Look::chosen : Look::outline};
    cell.language = language.code();
    cell.on = on;
    cells.push_back(std::move(cell));
  }
  // Never mirrored: a visitor who got a language by mistake finds their own where it was.
  column.foot_grid(cells, t.target * kTall, false);
  column.text(desk.say("all.language"), t.title, view::Face::serif);
}

}  // namespace onggi::screens
