#include "kiosk/measure/access_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "kiosk/measure/drawn_figures.h"

namespace onggi::measure {

using screens::ScreenId;

namespace {

constexpr int kAccessTicks = 40;    // of 1 ms: a frame
constexpr double kCapital = 0.714;  // of a letter's body, in Noto
constexpr double kWatched = 2.0;    // s that a screen is looked at for flashes
constexpr int kEvery = 2;           // of its frames, drawn
constexpr double kWhole = 0.99;     // of a text's colour: what fades is not finished

/// The exhibit, walked through frame by frame.
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

ScreenAccess look_at_screen(exhibit::Kiosk& kiosk, const std::string& name, double px_per_mm,
                            int flashes) {
  ScreenAccess out;
  out.name = name;
  out.flashes = flashes;
  view::Frame frame = kiosk.shown();
  frame.fade = 0;
  const view::Image whole = kiosk.renderer().draw_offscreen(frame);
  const view::Image wordless = kiosk.renderer().draw_offscreen(without_words(frame));
  const view::Image bare = kiosk.renderer().draw_offscreen(without_items(frame));
  double least_text = 1e9, least_control = 1e9, capital = 1e9, target = 1e9;
  for (const view::Item& item : frame.items) {
    const auto* text = std::get_if<view::Text>(&item);
    if (text == nullptr || text->color.a < kWhole || text->text.empty()) continue;
    const double is = drawn_contrast(whole, wordless, text->box);
    if (is == 0) continue;  // It lies beyond the screen's edge.
    ++out.texts;
    capital = std::min(capital, kCapital * static_cast<double>(text->style.px) / px_per_mm);
    if (is < least_text) {
      least_text = is;
      out.faintest = text->text;
    }
  }
  for (const screens::Control& control : kiosk.visit().reading().controls) {
    ++out.controls;
    const view::Rect& rect = control.rect;
    const double side = static_cast<double>(std::min(rect.w, rect.h)) / px_per_mm;
    if (side < target) {
      target = side;
      out.smallest = control.id;
    }
    // What is for keys alone is the pot itself, and has a ring while they are on it.
    if (!control.by_keys)
      least_control = std::min(least_control, drawn_contrast(whole, bare, rect));
  }
  out.least_text_contrast = out.texts > 0 ? least_text : 0;
  out.least_capital_mm = out.texts > 0 ? capital : 0;
  out.least_control_contrast = out.controls > 0 ? least_control : 0;
  out.least_target_mm = out.controls > 0 ? target : 0;
  return out;
}

}  // namespace

Result<AccessReport> measure_access(exhibit::Kiosk& kiosk) {
  const auto& exhibit = kiosk.exhibit();
  AccessReport report;
  report.width = kiosk.renderer().width();
  report.height = kiosk.renderer().height();
  report.diagonal_mm = exhibit.screen.diagonal_mm;
  report.distance_mm = exhibit.screen.viewing_distance_mm;
  report.high_contrast = exhibit.screen.high_contrast;
  report.warn_after = exhibit.idle.warn_after;
  report.countdown = exhibit.idle.countdown;
  const double px_per_mm = std::hypot(report.width, report.height) / report.diagonal_mm;
  // 10 degrees of view, a quarter of it.
  const double across = 2 * report.distance_mm * std::tan(5.0 * 3.14159265358979 / 180);
  const int cell = std::max(16, static_cast<int>(0.5 * across * px_per_mm));

  AccessWalk walk(kiosk);
  walk.frames(1);
  const auto see = [&](const std::string& name) {
    FlashCount flashes(cell);
    walk.frames(kWatched, &flashes);
    report.screens.push_back(look_at_screen(kiosk, name, px_per_mm, flashes.most_in_a_second()));
  };
  // A control to press, and what is seen then; empty: it is only passed.
  const std::vector<std::pair<std::string, std::string>> way{
      {"", "attract"},
      {"attract.begin", "choose"},
      {"help", "help"},
      {"help.close", ""},
      {"comfort", "comfort"},
      {"comfort.close", ""},
      {"choose.card.0", "label"},
      {"choose.throw", "throw"},
      {"throw.more", "throw drawer"},
      {"throw.less", ""},
      {"comfort", ""},
      {"comfort.spoken", ""},
      {"comfort.close", "throw by buttons"},
      {"throw.done", "result"},
  };
  for (const auto& [control, name] : way) {
    if (auto good = walk.press(control); !good) return tl::unexpected(good.error());
    if (!name.empty()) see(name);
  }
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
  return report;
}

files::Json json_of(const AccessReport& report) {
  files::Json screens = files::Json::list();
  for (const ScreenAccess& s : report.screens)
    screens.push_back(files::Json::object({{"name", s.name},
                                           {"texts", s.texts},
                                           {"controls", s.controls},
                                           {"least_capital_mm", s.least_capital_mm},
                                           {"least_text_contrast", s.least_text_contrast},
                                           {"faintest", s.faintest},
                                           {"least_control_contrast", s.least_control_contrast},
                                           {"least_target_mm", s.least_target_mm},
                                           {"smallest", s.smallest},
                                           {"flashes_in_a_second", s.flashes}}));
  return files::Json::object({{"width", report.width},
                              {"height", report.height},
                              {"diagonal_mm", report.diagonal_mm},
                              {"viewing_distance_mm", report.distance_mm},
                              {"high_contrast", report.high_contrast},
                              {"warn_after_s", report.warn_after},
                              {"countdown_s", report.countdown},
                              {"screens", screens}});
}

std::string text_of(const AccessReport& report) {
  char line[256];
  std::snprintf(line, sizeof line,
                "%dx%d, %.0f mm from corner to corner, seen from %.0f mm: capitals of 0.7 degrees "
                "are %.1f mm\n",
                report.width, report.height, report.diagonal_mm, report.distance_mm,
                2 * report.distance_mm * std::tan(0.35 * 3.14159265358979 / 180));
  std::string out = line;
  out += "screen             capitals mm  text n:1  control n:1  target mm  flashes/s\n";
  for (const ScreenAccess& s : report.screens) {
    std::snprintf(line, sizeof line, "%-18s %11.1f %9.1f %12.1f %10.1f %10d\n", s.name.c_str(),
                  s.least_capital_mm, s.least_text_contrast, s.least_control_contrast,
                  s.least_target_mm, s.flashes);
    out += line;
  }
  return out;
}

}  // namespace onggi::measure
