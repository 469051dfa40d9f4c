#include "kiosk/screens/comfort_page.h"

#include <algorithm>
#include <vector>

#include "kiosk/screens/overlays.h"

namespace onggi::screens {

using view::Face;
using view::Rect;

namespace {

constexpr float kTwoAbreast = 36.0f;  // em: from here on a page holds two columns of choices

std::string control_of(const Comfort::Choice& choice) {
  return std::string("comfort.") + choice.name;
}

std::vector<Comfort::Choice> offered(const Page& page, const Desk& desk) {
  std::vector<Comfort::Choice> all;
  for (const Comfort::Choice& choice : Comfort::kChoices) {
    if (choice.of == &settings::Exhibit::Screen::low_reach) {
      settings::Exhibit::Screen low = desk.screen();
      low.low_reach = true;
      const Rect whole{0, 0, static_cast<float>(page.width()), static_cast<float>(page.height())};
      if (in_reach(low, page.width(), page.height()) == whole) continue;
    }
    if (choice.of == &settings::Exhibit::Screen::silent && desk.world.exhibit->sound.volume == 0)
      continue;
    all.push_back(choice);
  }
  return all;
}

/// A choice: its name and what it does, and at the far end the switch. All of it can be touched.
class ChoiceRow {
 public:
  ChoiceRow(Page& page, const Desk& desk, const Comfort::Choice& choice, float width,
            bool explained)
      : page_(page),
        id_(control_of(choice)),
        name_(desk.say(id_)),
        does_(explained ? desk.say(id_ + "_is") : std::string()),
        name_style_(page.style(Face::sans, page.type().body)),
        does_style_(page.style(Face::sans, page.type().body * 0.9f)),
        right_to_left_(desk.words().right_to_left()) {
    switch_.words = desk.say("comfort.off");
    switch_.other = desk.say("comfort.on");
    switch_.other_on = desk.screen().*choice.of;
    switch_size_ = page.size(switch_, width);
    text_width_ = width - switch_size_.width - 2 * page.type().gap;
    const auto name = page.size(name_, name_style_, text_width_);
    const auto does = explained ? page.size(does_, does_style_, text_width_) : Size{};
    if (std::max(name.width, does.width) > text_width_ + 2) page.overflowed();
    name_height_ = name.height;
    does_height_ = does.height;
    height_ = std::max(name.height + does.height, switch_size_.height);
  }

  float height() const { return height_; }

  void draw(const Rect& at) const {
    page_.control(id_, at);
    const float gap = page_.type().gap;
    const float words_x = right_to_left_ ? at.x + switch_size_.width + 2 * gap : at.x;
    const float switch_x = right_to_left_ ? at.x : at.x + at.w - switch_size_.width;
    const float y = at.y + (at.h - name_height_ - does_height_) / 2;
    page_.words({words_x, y, text_width_, name_height_}, name_, name_style_, view::kCobalt);
    if (does_height_ > 0)
      page_.words({words_x, y + name_height_, text_width_, does_height_}, does_, does_style_,
                  view::kFaintInk);
    page_.button(switch_, {switch_x, at.y + (at.h - switch_size_.height) / 2, switch_size_.width,
                           switch_size_.height});
  }

 private:
  using Size = view::TextMeasure::Size;
  Page& page_;
  std::string id_, name_, does_;
  view::TextStyle name_style_, does_style_;
  bool right_to_left_;
  Button switch_;
  Size switch_size_;
  float text_width_ = 0, name_height_ = 0, does_height_ = 0, height_ = 0;
};

}  // namespace

void lay_out_comfort(Page& page, const Desk& desk) {
  const TypeScale& t = page.type();
  Column column(page, page.where().page);
  column.foot_buttons(language_buttons(desk));
  column.foot_space(t.gap);
  column.foot_buttons({{"comfort.close", desk.say("comfort.close"), Look::solid}});
  column.foot_space(t.gap * 2);
  column.text(desk.say("comfort.title"), t.title, Face::serif);
  column.text(desk.say("comfort.lead"), t.body, Face::sans, view::kFaintInk);
  column.space(t.gap * 1.5f);

  const Rect rest = column.rest();
  const float aside = t.body * 2.5f;
  const int abreast = rest.w > t.body * kTwoAbreast ? 2 : 1;
  const float width = abreast == 2 ? (rest.w - aside) / 2 : rest.w;
  const float between = t.gap * 1.6f;
  const std::vector<Comfort::Choice> choices = offered(page, desk);
  const auto lines =
      (choices.size() + static_cast<std::size_t>(abreast) - 1) / static_cast<std::size_t>(abreast);
  std::vector<ChoiceRow> rows;
  float height = 0;
  // Where names and what they do have no room, names say enough, and can be read.
  for (const bool explained : {true, false}) {
    rows.clear();
    height = t.target;
    for (const Comfort::Choice& choice : choices) {
      rows.emplace_back(page, desk, choice, width, explained);
      height = std::max(height, rows.back().height());
    }
    if (static_cast<float>(lines) * (height + between) - between <= rest.h) break;
    if (!explained) page.overflowed();
  }
  // From the foot up: whoever reaches no higher needs them most.
  const float top = rest.y + rest.h - static_cast<float>(lines) * (height + between) + between;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool second = i >= lines;
    const bool far = second != (abreast == 2 && desk.words().right_to_left());
    rows[i].draw({rest.x + (far ? width + aside : 0),
                  top + static_cast<float>(i % lines) * (height + between), width, height});
  }
}

std::string first_comfort() { return control_of(Comfort::kChoices.front()); }

}  // namespace onggi::screens
