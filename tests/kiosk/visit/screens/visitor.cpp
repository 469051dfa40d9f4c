#include "tests/kiosk/visit/screens/visitor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/math/portable.h"
#include "kiosk/visit/screens/throwing_controls.h"

namespace onggi::screens {

using view::InputEvent;

view::TextMeasure::Size PlainMeasure::measure(const std::string& text, const view::TextStyle& style,
                                              float width) const {
  const auto advance = [&](std::size_t& i) {
    const auto c = static_cast<unsigned char>(text[i]);
    const std::size_t bytes = c < 0x80 ? 1 : c < 0xE0 ? 2 : c < 0xF0 ? 3 : 4;
    i += bytes;
    return style.px * (bytes >= 3 ? 0.95f : 0.52f);
  };
  float widest = 0, line = 0;
  int lines = 1;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == '\n') {
      ++lines, ++i, line = 0;
      continue;
    }
    // One word with the space after it.
    float word = 0;
    while (i < text.size() && text[i] != ' ' && text[i] != '\n') word += advance(i);
    if (width > 0 && line > 0 && line + word > width) ++lines, line = 0;
    line += word;
    widest = std::max(widest, line);
    if (i < text.size() && text[i] == ' ') line += advance(i);
  }
  return {widest, static_cast<float>(lines) * style.px * style.line_height};
}

namespace {
const ClayDef kLump = [] {
  ClayDef def;
  def.rows = 100;
  def.sectors = 16;
  return def;
}();

void put_tear(ClayView& clay, bool torn) {
  clay.place(50,
             {clay.row_height(50), clay.rim_height(), clay.floor_top(), clay.floor_rows(), torn});
}
}  // namespace

Profile jar(double belly, double mouth, double foot) {
  Profile p;
  for (int i = 0; i <= 40; ++i) {
    const double t = i / 40.0;
    const double outer =
        foot + (mouth - foot) * t + (belly - 0.5 * (foot + mouth)) * sin(3.14159 * t);
    p.points.push_back({0.2 * t, outer, t < 0.06 ? 0.0 : outer - 0.006});
  }
  return p;
}

Visitor::Visitor(int count, const view::TextMeasure* measure, bool kiln, bool keeps_clay) {
  for (const char* file : {"content/languages/en.toml", "content/languages/ko.toml"}) {
    auto language = content::Language::read(file);
    EXPECT_TRUE(language) << (language ? "" : to_text(language.error()));
    if (language) languages.push_back(*language);
  }
  vessels.resize(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    content::Vessel& v = vessels[static_cast<std::size_t>(i)];
    v.id = "vessel_" + std::to_string(i);
    v.true_height = 0.305;
    v.credit = "Shape drawn for Onggi from published dimensions";
    std::string label;
    for (int k = 0; k < 10; ++k) label += "The potter set two thrown bowls rim to rim today. ";
    v.labels["en"] = {i % 3 == 0 ? "Panathenaic amphora" : "Moon jar",
                      i % 2 == 0 ? "Korea, Joseon dynasty; used in Japan" : "Maya, Late Classic",
                      "about 3500–3200 BCE",
                      "Two bowls, thrown and joined.",
                      label,
                      ""};
    std::string korean;
    for (int k = 0; k < 8; ++k) korean += "도공은 사발 두 개를 빚어 위아래로 맞붙였다. ";
    v.labels["en"].what = "A prize, full of oil";
    v.labels["ko"] = {"파나테나이아 암포라",
                      "미국 뉴멕시코, 아코마 푸에블로",
                      "기원전 3500–3200년 무렵",
                      "물레로 빚은 사발 두 개를 맞붙였다.",
                      korean,
                      ""};
    v.labels["ko"].what = "기름을 채운 우승 상품";
  }
  if (kiln) {
    const auto read = content::read_glazes("content/glazes.toml", {"en", "ko"});
    EXPECT_TRUE(read.problems.empty());
    glazes = read.glazes;
    wheel.kiln = Kiln{0.9375, 0.875, 1.0, &glazes, {}};
    for (int n = 0; n < static_cast<int>(glazes.size()); ++n) wheel.kiln->order.push_back(n);
  }
  wheel.keeps_clay = keeps_clay;
  for (content::Vessel& v : vessels) shelf.push_back({&v, 7, jar(0.08), 0.65, wheel});
  clay.lay(kLump);
  VisitInputs world;
  world.exhibit = &exhibit;
  world.languages = &languages;
  world.shelf = &shelf;
  counting = std::make_unique<CountingMeasure>(measure ? *measure : plain);
  world.measure = counting.get();
  world.wheel = &view;
  world.lesson = &lesson;
  world.build_lesson = &build_lesson;
  world.wheel_commands = &wheel_commands;
  world.devices = &news;
  world.todays = &todays;
  world.missions = &missions;
  visit = std::make_unique<Visit>(world);
  show();
}

void Visitor::frames(double seconds) {
  const double until = now + seconds - 1e-9;
  int skipped = 0;
  do {
    now += 1.0 / 30;
    status.time += 1.0 / 30;
    visit->update(now);
    while (auto request = visit->take_request()) {
      if (const auto* start = std::get_if<StartPot>(&*request)) {
        ++status.scene_serial;
        status.scripted = start->scripted && !start->script.empty();
        status.script_done = false;
        clay.lay(kLump);
      }
      seen_.push_back(std::move(*request));
    }
    // Long waits are looked at twice a second only, to keep the test short.
    if (seconds >= 5 && ++skipped % 15 != 0 && now < until) continue;
    counting->asked = 0;
    frame = visit->frame(width, height);
    most_measured = std::max(most_measured, counting->asked);
  } while (now < until);
}

std::vector<Request> Visitor::requests() { return std::exchange(seen_, {}); }

void Visitor::down(float x, float y) {
  visit->input({InputEvent::Kind::pointer_down, x, y, 0, view::Key::none, false}, now);
}
void Visitor::move(float x, float y) {
  visit->input({InputEvent::Kind::pointer_move, x, y, 0, view::Key::none, false}, now);
}
void Visitor::up(float x, float y) {
  visit->input({InputEvent::Kind::pointer_up, x, y, 0, view::Key::none, false}, now);
}

void Visitor::reach(const std::string& control) {
  for (const std::string& through : {std::string("throw.less"), way_into_drawer(control)})
    if (!visit->control(control) && visit->control(through)) touch(through);
}

void Visitor::put_tools_to_hand() {
  const char* names[] = {"palm",       "fingertip",    "sponge", "flat_rib",
                         "curved_rib", "loop_trimmer", "needle", "wire"};
  wheel.tools.clear();
  for (std::uint8_t n = 0; n < 8; ++n) wheel.tools.push_back({n, names[n], 0.001, 0.01});
  for (ShelfCard& card : shelf) card.wheel.tools = wheel.tools;
}

void Visitor::keep_today(int pots) {
  todays.clear();
  for (int i = 0; i < pots; ++i)
    todays.push_back({static_cast<view::PictureId>(1000 + i),
                      vessels[static_cast<std::size_t>(i) % vessels.size()].id, i % 6});
}

settings::Mission Visitor::described(double litres) {
  settings::Mission mission;
  mission.id = "litre_jar";
  mission.kind = settings::Mission::Kind::describe;
  mission.title = {{"en", "A jar that holds a litre"}, {"ko", "1리터가 담기는 항아리"}};
  mission.about = {{"en", "No vessel to follow: any shape will do that holds a litre."},
                   {"ko", "따라 할 그릇은 없습니다."}};
  mission.wanted.volume = 1e-3 * litres;
  mission.wanted.height = settings::Mission::Described::Bounds{0.1, 0.15};
  mission.wanted.mouth = settings::Mission::Described::Bounds{0.06, 0.09};
  return mission;
}

void Visitor::put_on(const settings::Mission& mission, int card) {
  on.push_back(mission);
  MissionCard one{&on.back(), card, {}};
  if (mission.kind == settings::Mission::Kind::describe) {
    one.card = own_card(static_cast<int>(missions.size()));
    for (const auto& [code, title] : mission.title) jar_of_mission.labels[code].title = title;
    jar_of_mission.id = mission.id;
    one.own = {&jar_of_mission, 7, jar(0.06), 1.0, wheel};
  }
  missions.push_back(one);
  show();
}

void Visitor::touch_clay() {
  auto& contact = status.feedback.hand[0].contact;
  const bool was = std::exchange(contact, true);
  show();
  contact = was;
  show();
}

void Visitor::touch(const std::string& control) {
  if (control.starts_with("throw.")) reach(control);
  if (control == "throw.done") touch_clay();
  const auto rect = visit->control(control);
  ASSERT_TRUE(rect) << control << " is not on the screen";
  down(rect->x + rect->w / 2, rect->y + rect->h / 2);
  show();
  up(rect->x + rect->w / 2, rect->y + rect->h / 2);
  show();
  if (control.starts_with("language."))
    frames(1.6);
  else if (control.ends_with(".close") || control == "leaving.go")
    frames(0.5);
}

void Visitor::speak(const std::string& code) {
  touch("language");
  touch("language." + code);
}

void Visitor::key(view::Key key) {
  visit->input({InputEvent::Kind::key_down, 0, 0, 0, key, false}, now);
  visit->input({InputEvent::Kind::key_up, 0, 0, 0, key, false}, now);
  show();
}

bool Visitor::key_to(const std::string& control) {
  if (control == "throw.done") touch_clay();
  for (const std::string& through : {std::string("throw.less"), way_into_drawer(control)})
    if (control.starts_with("throw.") && !visit->control(control) && visit->control(through))
      key_to(through);
  const auto wanted = visit->control(control);
  if (!wanted) return false;
  using view::Key;
  for (int i = 0; i < 60; ++i) {
    if (visit->focus() == control) {
      key(Key::enter);
      return true;
    }
    const auto at = visit->control(visit->focus());
    if (!at) {
      key(Key::down);
      continue;
    }
    // Straight towards it as a person would; every so often the other way, past what is between.
    const float dx = wanted->x + wanted->w / 2 - at->x - at->w / 2;
    const float dy = wanted->y + wanted->h / 2 - at->y - at->h / 2;
    const bool upright = std::abs(dy) > 4 && (i % 3 != 2 || std::abs(dx) < 4);
    key(upright ? (dy > 0 ? Key::down : Key::up) : (dx > 0 ? Key::right : Key::left));
  }
  return false;
}

void Visitor::press_clay() {
  const auto at = *frame.pot->camera.project({0.05, 0.1, 0});
  down(at.first, at.second);
}

void Visitor::begin() {
  down(600, 300);
  up(600, 300);
  show();
  if (visit->screen() == ScreenId::clay) touch("clay.on");  // where strokes are made by buttons
}

void Visitor::throw_a_pot() {
  begin();
  touch("choose.card.0");
  touch("choose.throw");
  show();
}

void Visitor::make_result() {
  throw_a_pot();
  touch("throw.done");
}

void Visitor::tear(double limit) {
  for (ShelfCard& card : shelf) card.wheel.tear_thickness = limit;
  status.feedback.torn = true;
  put_tear(clay, true);
}

void Visitor::mend() {
  status.feedback.torn = false;
  put_tear(clay, false);
}

void Visitor::glaze_and_fire() {
  touch("result.keep");
  touch("kiln.glaze.1");
  frames(10);
}

void Visitor::offer(const std::string& way_id) {
  // A pot that was decorated keeps to its way.
  if (!way_id.empty()) {
    auto read = decoration::read_way("content/ways/" + way_id + ".toml", {"en", "ko"});
    EXPECT_TRUE(read.problems.empty()) << way_id;
    way = std::make_unique<decoration::Way>(std::move(read.way));
  }
  for (ShelfCard& card : shelf) card.wheel.way = way_id.empty() ? nullptr : way.get();
}

void walk_decorating(Visitor& v, const std::function<void(const std::string&)>& look,
                     std::size_t marks) {
  for (std::size_t n = 0; n < v.way->tools.size(); ++n) {
    const decorating::DecoratedPot* pot = v.visit->decorated_pot();
    if (pot != nullptr && v.way->tools[n].more != pot->held().more) v.touch("decorate.more");
    v.touch("decorate.tool." + std::to_string(n));
    look("decorate " + v.way->id + " " + v.way->tools[n].id);
    if (n < marks) v.touch("decorate.mark");
  }
}

void walk(Visitor& v, const std::function<void(const std::string&)>& look) {
  const auto settled = [&](const std::string& name) {
    v.frames(1.0);
    look(name);
  };
  const auto with_help = [&](const std::string& name) {
    settled(name);
    v.touch("help");
    settled(name + " help");
    v.touch("help.close");
  };
  const auto with_comfort = [&](const std::string& name) {
    v.touch("comfort");
    settled(name + " comfort");
    v.touch("comfort.close");
  };
  v.status.script_done = true;
  v.frames(2);
  with_help("attract");
  v.touch("language");
  settled("languages");
  v.touch("language.close");
  if (v.visit->control("attract.gallery")) {
    v.touch("attract.gallery");
    with_help("attract gallery");
    v.touch("back");
  }
  v.press_clay();
  v.up(0, 0);
  with_help("clay");
  v.touch("back");
  v.frames(1);
  v.begin();
  with_help("choose");
  with_comfort("choose");
  if (v.visit->control("choose.next")) {
    v.touch("choose.next");
    settled("choose second page");
    v.touch("choose.previous");
    v.frames(1.5);
  }
  v.touch("choose.card.0");
  settled("label");
  if (v.visit->control("choose.more")) {
    v.touch("choose.more");
    settled("label read on");
  }
  v.touch("choose.throw");
  v.frames(3);
  with_help("throw");
  v.touch("throw.tools");
  settled("throw tools");
  v.touch("throw.inside");
  v.frames(3);
  v.touch("throw.wheel");
  settled("throw wheel");
  v.touch("throw.renew");
  v.touch("throw.less");
  v.status.can_restore = true;
  settled("throw inside");
  v.status.feedback.fallen = true;
  settled("throw fallen");
  v.status.feedback.fallen = false;
  for (const double limit : {0.0, 0.1}) {
    v.tear(limit);
    settled(limit > 0 ? "throw torn thin" : "throw torn wide");
    v.mend();
    v.show();
  }
  v.touch("throw.done");
  with_help("result");
  v.touch("result.other");
  settled("leaving");
  v.touch("leaving.close");
  const bool kiln = !v.glazes.empty();
  if (kiln) {
    v.offer("celadon");
    v.frames(0.5);
    settled("result decorates");
    v.touch("result.keep");
    with_help("decorate");
    walk_decorating(v, settled, 0);
    v.touch("decorate.on");
    v.offer("");
  } else {
    v.touch("result.keep");
  }
  if (kiln) {
    with_help("kiln");
    v.touch("kiln.glaze.1");
    settled("kiln firing");
    for (std::size_t i = 0; i < v.glazes.size(); ++i) {
      v.touch("kiln.glaze." + std::to_string(i));
      v.frames(i == 0 ? 8 : 3);
      settled("kiln fired " + std::to_string(i));
    }
    v.touch("kiln.keep");
  }
  settled("keepsake waiting");
  v.visit->show_postcard(9);
  v.visit->keepsake_kept("2026-05-04_141503");
  with_help("keepsake");
  if (v.visit->control("keepsake.gallery")) {
    v.touch("keepsake.gallery");
    settled("keepsake gallery");
    v.touch("back");
  }
  v.touch("keepsake.done");
  settled("keepsake thanks");
  v.touch("back");
  v.frames(v.exhibit.idle.result_after + 1);
  settled("idle");
  v.move(3, 3);
  v.frames(0.5);
  v.touch("back");
  v.touch("back");
  if (kiln) v.touch("back");
  v.touch("throw.done");
  v.touch("result.keep");
  if (kiln) v.touch("kiln.glaze.0");
  if (kiln) v.touch("kiln.keep");
  v.visit->keepsake_failed({"disk", "full", "make room"});
  settled("keepsake failed");
  v.visit->fail({"a", "b", "c"});
  settled("fault");
}

std::string words_in(const view::Frame& frame) {
  std::string all;
  for (const view::Item& item : frame.items)
    if (const auto* text = std::get_if<view::Text>(&item)) all += text->text + "\n";
  return all;
}

}  // namespace onggi::screens
