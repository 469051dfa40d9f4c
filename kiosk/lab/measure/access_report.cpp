#include "kiosk/lab/measure/access_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "kiosk/lab/measure/drawn_figures.h"

namespace onggi::measure {

using screens::ScreenId;

namespace {

constexpr int kAccessTicks = 40;    // of 1 ms: a frame
constexpr double kCapital = 0.714;  // of a letter's body, in Noto
constexpr double kWatched = 2.0;    // s that a screen is watched for flashes
constexpr int kEvery = 2;           // of its frames is drawn
constexpr double kWhole = 0.99;     // of a text's colour: a fading text is not finished

/// Walks through the exhibit frame by frame.
class AccessWalk {
 public:
  explicit AccessWalk(exhibit::Kiosk& kiosk) : kiosk_(kiosk) {}

  void frames(double seconds, FlashCount* flashes = nullptr) {
    const double until = now_ + seconds;
    for (int n = 0; now_ < until - 1e-9; ++n) {
      kiosk_.advance(kAccessTicks);
      kiosk_.frame(now_ += kAccessTicks * 1e-3, false);
      if (flashes != nullptr && n % kEvery == 0) flashes->see(kiosk_.picture(), now_);
    }
  }
  Result<void> press(const std::string& control) {
    if (!control.empty() && !kiosk_.visit().control(control))
      return problem("screen " + std::string(name_of(kiosk_.visit().screen())),
                     "It has no control " + control + ".",
                     "This is a fault of the program: please report it.", 1);
    kiosk_.visit().activate(control, now_);
    frames(0.6);
    return {};
  }
  /// Where strokes are made by buttons: one stroke, so that there is a pot to call done.
  Result<void> make_a_pot() {
    if (auto good = press("throw.ask.2"); !good) return good;
    for (int n = 0; n < 50 && !kiosk_.wheel_host().status().feedback.hand[0].contact; ++n)
      frames(0.1);
    frames(0.1);
    return press("throw.done");
  }
  double now() const { return now_; }

 private:
  exhibit::Kiosk& kiosk_;
  double now_ = 0;
};

view::Frame without_words(view::Frame frame) {
  std::erase_if(frame.items,
                [](const view::Item& item) { return std::holds_alternative<view::Text>(item); });
  return frame;
}
view::Frame without_items(view::Frame frame) {
  frame.items.clear();
  return frame;
}

double px_per_mm(const AccessDisplay& display) {
  return std::hypot(display.width, display.height) / display.diagonal_mm;
}

/// `frame` is the last one that was laid out.
ScreenAccess look_at_screen(exhibit::Kiosk& kiosk, const std::string& name,
                            const AccessDisplay& display, view::Frame frame) {
  ScreenAccess out;
  out.name = name;
  frame.fade = 0;
  const view::Image whole = kiosk.renderer().draw_offscreen(frame);
  const view::Image wordless = kiosk.renderer().draw_offscreen(without_words(frame));
  const view::Image bare = kiosk.renderer().draw_offscreen(without_items(frame));
  double least_text = 1e9, least_control = 1e9, capital = 1e9, target = 1e9;
  for (const view::Item& item : frame.items) {
    const auto* text = std::get_if<view::Text>(&item);
    if (text == nullptr || text->color.a < kWhole || text->text.empty()) continue;
    const double is = drawn_contrast(whole, wordless, text->box);
    if (is == 0) continue;  // it is beyond the screen's edge
    ++out.texts;
    capital =
        std::min(capital, kCapital * static_cast<double>(text->style.px) / px_per_mm(display));
    if (is < least_text) {
      least_text = is;
      out.faintest = text->text;
    }
  }
  for (const screens::Control& control : kiosk.visit().reading().controls) {
    ++out.controls;
    const view::Rect& rect = control.rect;
    const double side = static_cast<double>(std::min(rect.w, rect.h)) / px_per_mm(display);
    if (side < target) {
      target = side;
      out.smallest = control.id;
    }
    // A control only for keys is the pot itself, and has a ring while it has the keyboard.
    if (!control.by_keys)
      least_control = std::min(least_control, drawn_contrast(whole, bare, rect));
  }
  out.least_text_contrast = out.texts > 0 ? least_text : 0;
  out.least_capital_mm = out.texts > 0 ? capital : 0;
  out.least_control_contrast = out.controls > 0 ? least_control : 0;
  out.least_target_mm = out.controls > 0 ? target : 0;
  return out;
}

AccessReport report_on(const settings::Exhibit& exhibit, const AccessDisplay& display) {
  AccessReport report;
  report.display = display;
  report.high_contrast = exhibit.screen.high_contrast;
  report.warn_after = exhibit.idle.warn_after;
  report.countdown = exhibit.idle.countdown;
  return report;
}

}  // namespace

const std::vector<AccessDisplay>& likely_displays() {
  static const std::vector<AccessDisplay> all{
      {1280, 800, 396, 400},    // 15.6 inches, at arm's length
      {1280, 720, 600, 600},    // 24 inches
      {1080, 1920, 600, 600},   // the same upright
      {1920, 1080, 813, 800},   // 32 inches
      {1080, 1920, 1092, 800},  // 43 inches, upright
      {3840, 2160, 1092, 1000},
  };
  return all;
}

double capital_asked(double distance_mm) {
  return distance_mm * std::tan(0.7 * 3.14159265358979 / 180);
}

Result<std::vector<AccessReport>> measure_access(exhibit::Kiosk& kiosk,
                                                 const std::vector<AccessDisplay>& also) {
  const auto& exhibit = kiosk.exhibit();
  const settings::Exhibit::Screen usual = exhibit.screen;
  const AccessDisplay own{kiosk.renderer().width(), kiosk.renderer().height(), usual.diagonal_mm,
                          usual.viewing_distance_mm};
  std::vector<AccessReport> reports{report_on(exhibit, own)};
  for (const AccessDisplay& display : also) reports.push_back(report_on(exhibit, display));
  // A quarter of 10 degrees of view.
  const double across = 2 * own.distance_mm * std::tan(5.0 * 3.14159265358979 / 180);
  const int cell = std::max(16, static_cast<int>(0.5 * across * px_per_mm(own)));

  AccessWalk walk(kiosk);
  walk.frames(1);
  const auto see = [&](const std::string& name) {
    FlashCount flashes(cell);
    walk.frames(kWatched, &flashes);
    reports.front().screens.push_back(look_at_screen(kiosk, name, own, kiosk.shown()));
    reports.front().screens.back().flashes = flashes.most_in_a_second();
    const std::string language = kiosk.visit().language();
    for (std::size_t n = 1; n < reports.size(); ++n) {
      const AccessDisplay& display = reports[n].display;
      settings::Exhibit::Screen screen = usual;
      screen.diagonal_mm = display.diagonal_mm;
      screen.viewing_distance_mm = display.distance_mm;
      kiosk.show_as(screen, language);
      reports[n].screens.push_back(
          look_at_screen(kiosk, name, display, kiosk.visit().frame(display.width, display.height)));
    }
    kiosk.show_as(usual, language);
    walk.frames(0.1);  // the last layout had another size
  };
  // A control to press, and the screen after it; empty: it is only passed.
  const std::vector<std::pair<std::string, std::string>> way{
      {"", "attract"},
      {"attract.begin", "choose"},
      {"help", "help"},
      {"help.close", ""},
      {"language", "languages"},
      {"language.close", ""},
      {"comfort", "comfort"},
      {"comfort.close", ""},
      {"choose.card.0", "label"},
      {"choose.throw", "throw"},
      {"throw.tools", "throw tools"},
      {"throw.less", ""},
      {"throw.wheel", "throw wheel"},
      {"throw.less", ""},
      {"comfort", ""},
      {"comfort.spoken", ""},
      {"comfort.close", "throw by buttons"},
  };
  for (const auto& [control, name] : way) {
    if (auto good = walk.press(control); !good) return tl::unexpected(good.error());
    if (!name.empty()) see(name);
  }
  if (auto good = walk.make_a_pot(); !good) return tl::unexpected(good.error());
  see("result");
  if (auto good = walk.press("result.keep"); !good) return tl::unexpected(good.error());
  if (kiosk.visit().screen() == ScreenId::kiln) {
    see("kiln");
    if (auto good = walk.press("kiln.glaze.0"); !good) return tl::unexpected(good.error());
    see("kiln, drying");
    see("kiln, firing");
    see("kiln, hot");
    walk.frames(6);
    see("kiln, fired");
    if (auto good = walk.press("kiln.keep"); !good) return tl::unexpected(good.error());
  }
  see("keepsake");
  walk.frames(exhibit.idle.result_after + 1);
  if (!kiosk.visit().idle_warning())
    return problem("the visit", "No warning came before its time was over.",
                   "This is a fault of the program: please report it.", 1);
  see("idle");
  return reports;
}

files::Json json_of(const AccessReport& report) {
  files::Json screens = files::Json::list();
  for (const ScreenAccess& s : report.screens) {
    files::Json one = files::Json::object({{"name", s.name},
                                           {"texts", s.texts},
                                           {"controls", s.controls},
                                           {"least_capital_mm", s.least_capital_mm},
                                           {"least_text_contrast", s.least_text_contrast},
                                           {"faintest", s.faintest},
                                           {"least_control_contrast", s.least_control_contrast},
                                           {"least_target_mm", s.least_target_mm},
                                           {"smallest", s.smallest}});
    if (s.flashes) one["flashes_in_a_second"] = *s.flashes;
    screens.push_back(std::move(one));
  }
  return files::Json::object({{"width", report.display.width},
                              {"height", report.display.height},
                              {"diagonal_mm", report.display.diagonal_mm},
                              {"viewing_distance_mm", report.display.distance_mm},
                              {"high_contrast", report.high_contrast},
                              {"warn_after_s", report.warn_after},
                              {"countdown_s", report.countdown},
                              {"screens", screens}});
}

std::string text_of(const AccessReport& report) {
  const AccessDisplay& display = report.display;
  char line[256];
  std::snprintf(line, sizeof line,
                "%dx%d, %.0f mm from corner to corner, seen from %.0f mm: capitals of 0.7 degrees "
                "are %.1f mm\n",
                display.width, display.height, display.diagonal_mm, display.distance_mm,
                capital_asked(display.distance_mm));
  std::string out = line;
  out += "screen             capitals mm  text n:1  control n:1  target mm  flashes/s\n";
  for (const ScreenAccess& s : report.screens) {
    std::snprintf(line, sizeof line, "%-18s %11.1f %9.1f %12.1f %10.1f %10s\n", s.name.c_str(),
                  s.least_capital_mm, s.least_text_contrast, s.least_control_contrast,
                  s.least_target_mm, s.flashes ? std::to_string(*s.flashes).c_str() : "-");
    out += line;
  }
  return out;
}

namespace {
/// Rounds to the written precision.
bool is_short(double is, double asked) { return std::round(10 * is) < std::round(10 * asked); }
}  // namespace

std::string table_of(const std::vector<AccessReport>& reports) {
  std::string out =
      "| display | diagonal, seen from | capitals: asked | least | words, least | controls, least "
      "| "
      "targets, least |\n|---|---|---|---|---|---|---|\n";
  const auto cell = [](double is, double asked, const char* format, const std::string& where) {
    char figure[32];
    std::snprintf(figure, sizeof figure, format, is);
    return " " + (is_short(is, asked) ? "**" + std::string(figure) + "**" : std::string(figure)) +
           (where.empty() ? "" : ", " + where) + " |";
  };
  for (const AccessReport& report : reports) {
    const AccessDisplay& display = report.display;
    const double asked = capital_asked(display.distance_mm);
    const auto least = [&](double ScreenAccess::*of) {
      const ScreenAccess* found = nullptr;
      for (const ScreenAccess& s : report.screens)
        if (s.*of > 0 && (found == nullptr || s.*of < found->*of)) found = &s;
      return found;
    };
    char line[96];
    std::snprintf(line, sizeof line, "| %dx%d | %.0f mm, %.0f mm | %.1f mm |", display.width,
                  display.height, display.diagonal_mm, display.distance_mm, asked);
    out += line;
    if (const auto* s = least(&ScreenAccess::least_capital_mm)) {
      const bool all_alike = !is_short(s->least_capital_mm, asked);
      out += cell(s->least_capital_mm, asked, "%.1f mm", all_alike ? "" : s->name);
    }
    if (const auto* s = least(&ScreenAccess::least_text_contrast))
      out += cell(s->least_text_contrast, 4.5, "%.1f:1", s->name);
    if (const auto* s = least(&ScreenAccess::least_control_contrast))
      out += cell(s->least_control_contrast, 3.0, "%.1f:1", s->name);
    if (const auto* s = least(&ScreenAccess::least_target_mm))
      out += cell(s->least_target_mm, 15.0, "%.1f mm", "");
    out += "\n";
  }
  return out;
}

}  // namespace onggi::measure
