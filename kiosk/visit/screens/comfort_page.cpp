#include "kiosk/visit/screens/comfort_page.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "kiosk/visit/screens/overlays.h"

namespace onggi::screens {

using view::Face;
using view::Rect;

namespace {

constexpr float kExplaining = 1.25f;  // times a line
constexpr float kTwoAbreast = 36.0f;  // em: a wider page has two columns of choices

std::string control_of(const Comfort::Choice& choice) {
  return std::string("comfort.") + choice.name;
}

/// "1.5 s", a switch speed.
std::string pace(const Desk& desk, double seconds) {
  const long tenths = std::lround(10 * seconds);
  std::string number = std::to_string(tenths / 10);
  if (tenths % 10 != 0) number += "." + std::to_string(tenths % 10);
  return desk.say("comfort.pace", {{"seconds", number}});
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
    all.push_back(choice);
  }
  return all;
}

/// Volume: a cell for silence with its word, then rising bars, filled up to the chosen one. Each
/// cell can be touched.
class VolumeSteps {
 public:
  VolumeSteps(Page& page, const Desk& desk)
      : page_(page),
        level_(desk.comfort.volume(desk.world.exhibit->screen)),
        name_(desk.say("comfort.volume")),
        right_to_left_(desk.words().right_to_left()) {
    off_.id = Comfort::volume_control(0);
    off_.words = desk.say("comfort.off");
    off_.on = level_ == 0;
    off_.note = name_;
    off_.look = level_ == 0 ? Look::chosen : Look::outline;
    off_size_ = page.size(off_, -1);
    cell_ = std::max(page.type().target, off_size_.height);
    size_ = {off_size_.width + page.type().gap * 0.5f + Comfort::kLoudest * cell_,
             std::max(off_size_.height, cell_)};
  }
  view::TextMeasure::Size size() const { return size_; }

  void draw(float x, float y) const {
    const auto placed = [&](float at, float width) {
      return Rect{right_to_left_ ? x + size_.width - at - width : x + at, y, width, size_.height};
    };
    page_.button(off_, placed(0, off_size_.width));
    const float from = off_size_.width + page_.type().gap * 0.5f;
    for (int step = 1; step <= Comfort::kLoudest; ++step) {
      const Rect cell = placed(from + static_cast<float>(step - 1) * cell_, cell_);
      page_.control({Comfort::volume_control(step), cell,
                     name_ + " " + std::to_string(100 * step / Comfort::kLoudest) + " %",
                     step == level_});
      const float share = static_cast<float>(step) / Comfort::kLoudest;
      const float high = (0.3f + 0.55f * share) * cell.h, wide = 0.5f * cell.w;
      const Rect bar{cell.x + (cell.w - wide) / 2, cell.y + 0.92f * cell.h - high, wide, high};
      page_.draw(view::Box{bar, page_.type().body * 0.1f,
                           view::with_alpha(view::kCobalt, step <= level_ ? 1.0f : 0.0f),
                           page_.type().hairline * 1.5f, view::kCobalt});
    }
  }

 private:
  Page& page_;
  int level_;
  std::string name_;
  bool right_to_left_;
  Button off_;
  view::TextMeasure::Size off_size_, size_;
  float cell_ = 0;
};

/// A choice: its name and explanation, and at the far end the switch or the volume. The whole row
/// of a switch can be touched.
class ChoiceRow {
 public:
  ChoiceRow(Page& page, const Desk& desk, const std::string& id, std::optional<bool> on,
            float width, bool explained)
      : page_(page),
        id_(id),
        name_(desk.say(id_)),
        does_(desk.say(id_ + "_is")),
        name_style_(page.style(Face::sans, page.type().body)),
        does_style_(page.style(Face::sans, page.type().body)),
        right_to_left_(desk.words().right_to_left()) {
    does_style_.line_height = kExplaining;
    if (on) {
      switch_.words = desk.say("comfort.off");
      switch_.other = desk.say("comfort.on");
      switch_.other_on = *on;
      far_size_ = page.size(switch_, width);
    } else {
      volume_.emplace(page, desk);
      far_size_ = volume_->size();
    }
    text_width_ = width - far_size_.width - 2 * page.type().gap;
    const auto name = page.size(name_, name_style_, text_width_);
    const auto does = explained ? page.size(does_, does_style_, text_width_) : Size{};
    too_wide_ = std::max(name.width, does.width) > text_width_ + 1;
    name_height_ = name.height;
    does_height_ = does.height;
    height_ = std::max(name.height + does.height, far_size_.height);
  }

  float height() const { return height_; }
  /// True if one of its words is longer than its line.
  bool too_wide() const { return too_wide_; }

  void draw(const Rect& at) const {
    const float gap = page_.type().gap;
    const float words_x = right_to_left_ ? at.x + far_size_.width + 2 * gap : at.x;
    const float far_x = right_to_left_ ? at.x : at.x + at.w - far_size_.width;
    const float y = at.y + (at.h - name_height_ - does_height_) / 2;
    if (!volume_) page_.control({id_, at, name_, switch_.other_on, does_});
    page_.words({words_x, y, text_width_, name_height_}, name_, name_style_,
                volume_ ? view::kInk : view::kCobalt);
    if (does_height_ > 0)
      page_.words({words_x, y + name_height_, text_width_, does_height_}, does_, does_style_,
                  view::kFaintInk);
    const float far_y = at.y + (at.h - far_size_.height) / 2;
    if (volume_)
      volume_->draw(far_x, far_y);
    else
      page_.button(switch_, {far_x, far_y, far_size_.width, far_size_.height});
  }

 private:
  using Size = view::TextMeasure::Size;
  Page& page_;
  std::string id_, name_, does_;
  view::TextStyle name_style_, does_style_;
  bool right_to_left_, too_wide_ = false;
  Button switch_;
  std::optional<VolumeSteps> volume_;
  Size far_size_;
  float text_width_ = 0, name_height_ = 0, does_height_ = 0, height_ = 0;
};

/// The choices as they fit into a room.
struct ChoiceLines {
  std::vector<ChoiceRow> rows;
  std::vector<float> heights;  ///< Of the lines.
  float between = 0, all = 0, width = 0, aside = 0;
  int abreast = 1;
  bool explained = false, fits = false;
};

/// If names and explanations do not fit, only the names are shown: they are enough, and stay
/// legible.
ChoiceLines lines_in(Page& page, const Desk& desk, const Rect& room) {
  const TypeScale& t = page.type();
  ChoiceLines out;
  out.aside = t.body * 2.5f;
  out.abreast = room.w > t.body * kTwoAbreast ? 2 : 1;
  out.width = out.abreast == 2 ? (room.w - out.aside) / 2 : room.w;
  const std::vector<Comfort::Choice> choices = offered(page, desk);
  const bool sound = desk.world.exhibit->sound.volume > 0;
  const auto lines =
      (choices.size() + (sound ? 1 : 0) + static_cast<std::size_t>(out.abreast) - 1) /
      static_cast<std::size_t>(out.abreast);
  for (const auto& [explained, air] :
       {std::pair(true, 1.6f), {true, 0.6f}, {false, 1.6f}, {false, 0.5f}}) {
    out.explained = explained;
    out.between = air * t.gap;
    out.rows.clear();
    for (const Comfort::Choice& choice : choices)
      out.rows.emplace_back(page, desk, control_of(choice), desk.screen().*choice.of, out.width,
                            explained);
    if (sound)
      out.rows.emplace_back(page, desk, "comfort.volume", std::nullopt, out.width, explained);
    out.heights.assign(lines, t.target);
    bool narrow = false;
    for (std::size_t i = 0; i < out.rows.size(); ++i) {
      out.heights[i % lines] = std::max(out.heights[i % lines], out.rows[i].height());
      narrow = narrow || out.rows[i].too_wide();
    }
    out.all = std::accumulate(out.heights.begin(), out.heights.end(),
                              out.between * static_cast<float>(lines - 1));
    out.fits = !narrow && out.all <= room.h;
    if (out.fits) break;
  }
  return out;
}

}  // namespace

void lay_out_comfort(Page& page, const Desk& desk) {
  const TypeScale& t = page.type();
  Column column(page, page.where().page);
  column.foot_buttons(globe(desk));
  column.foot_space(t.gap);
  std::vector<Button> foot{{"comfort.close", desk.say("comfort.close"), Look::solid}};
  if (desk.screen().one_switch)
    foot.insert(foot.end(),
                {{Comfort::kFaster, desk.say("comfort.faster"), Look::outline},
                 {"", pace(desk, desk.screen().scan_seconds), Look::plain, pace(desk, 0.5)},
                 {Comfort::kSlower, desk.say("comfort.slower"), Look::outline}});
  column.foot_buttons(foot);
  column.foot_space(t.gap * 2);
  column.text(desk.say("comfort.title"), t.title, Face::serif);

  const float below = t.gap * 1.5f;
  const auto room_under = [&](const std::string& words) {
    Column under = column;
    under.space(column.height_of(words, t.body) + below);
    under.into_reach();
    return under.rest();
  };
  std::string lead = desk.say("comfort.lead");
  ChoiceLines lines = lines_in(page, desk, room_under(lead));
  // What each choice does is worth more than the lead.
  if (!lines.explained)
    if (ChoiceLines under = lines_in(page, desk, room_under("")); under.explained && under.fits)
      lead.clear(), lines = std::move(under);
  // Where no choice has room for its explanation, the one that was switched last is explained.
  if (!lines.explained && desk.comfort.last() != nullptr) {
    const std::string does = desk.say(std::string("comfort.") + desk.comfort.last() + "_is");
    ChoiceLines under = lines_in(page, desk, room_under(does));
    if (under.fits) lead = does, lines = std::move(under);
  }
  if (!lines.fits) page.overflowed();
  column.text(lead, t.body, Face::sans, view::kFaintInk);
  column.space(below);
  column.into_reach();
  const Rect rest = column.rest();
  // From the foot up: visitors with low reach need these choices most.
  float y = rest.y + rest.h - lines.all;
  const std::size_t count = lines.heights.size();
  for (std::size_t line = 0; line < count; ++line) {
    for (std::size_t i = line; i < lines.rows.size(); i += count) {
      const bool far = (i >= count) != (lines.abreast == 2 && desk.words().right_to_left());
      lines.rows[i].draw(
          {rest.x + (far ? lines.width + lines.aside : 0), y, lines.width, lines.heights[line]});
    }
    y += lines.heights[line] + lines.between;
  }
}

std::string first_comfort() { return control_of(Comfort::kChoices.front()); }

}  // namespace onggi::screens
