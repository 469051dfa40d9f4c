#include <gtest/gtest.h>

#include <filesystem>

#include "kiosk/collection/settings/mission_file.h"
#include "kiosk/picture/render/text.h"
#include "kiosk/visit/screens/comfort.h"
#include "tests/kiosk/visit/screens/layout_check.h"
#include "tests/kiosk/visit/screens/trial_language.h"

// The missions that come with the exhibit, all of them on: every screen that only they have.

namespace onggi::screens::mission_layout_test {
namespace {

using Kind = settings::Mission::Kind;
using Comforts = std::vector<bool settings::Exhibit::Screen::*>;

const render::Typesetter& fonts() {
  static const render::Typesetter kFonts;
  return kFonts;
}

std::vector<content::Language> all_languages() {
  std::vector<content::Language> all;
  for (const auto& file : std::filesystem::directory_iterator("content/languages"))
    all.push_back(*content::Language::read(file.path()));
  all.push_back(long_words());
  all.push_back(from_the_right());
  return all;
}

/// With words in the trial languages too.
std::vector<settings::Mission> all_missions() {
  auto read = settings::read_missions("content/missions.toml");
  EXPECT_TRUE(read.problems.empty());
  EXPECT_EQ(read.missions.size(), 4u);
  for (settings::Mission& mission : read.missions)
    for (auto* words : {&mission.title, &mission.about}) {
      const std::string english = words->at("en");
      (*words)["xl"] = in_long_words(english);
      (*words)["xr"] = in_letters_from_the_right(english);
    }
  return read.missions;
}

const char* name_of(Kind kind) {
  switch (kind) {
    case Kind::today:
      return "today";
    case Kind::describe:
      return "described";
    case Kind::eyes_closed:
      return "eyes closed";
    case Kind::two_hands:
      return "two hands";
  }
  return "";
}

/// Through all of them, from the shelf to the result; of a description on to what is kept.
void walk_missions(Visitor& v, const std::function<void(const std::string&)>& look) {
  const auto settled = [&](const std::string& name) {
    v.frames(0.5);
    look(name);
  };
  const auto over = [&](const std::string& control, const std::string& name) {
    v.touch(control);
    settled(name + " " + control);
    v.touch(control + ".close");
  };
  v.begin();
  settled("missions");
  for (std::size_t n = 0; n < v.missions.size(); ++n) {
    const Kind kind = v.missions[n].mission->kind;
    const std::string name = name_of(kind), card = "choose.mission." + std::to_string(n);
    while (!v.visit->control(card) && v.visit->control("choose.next")) {
      v.touch("choose.next");
      v.frames(1.5);
    }
    v.touch(card);
    settled(name + " label");
    if (v.visit->control("choose.more")) {
      v.touch("choose.more");
      settled(name + " label read on");
    }
    v.touch("choose.throw");
    settled(name);
    over("help", name);
    if (kind == Kind::eyes_closed) over("comfort", name);
    for (const char* drawer : {"throw.tools", "throw.wheel"}) {
      v.touch(drawer);
      settled(name + " " + drawer);
      v.touch("throw.less");
    }
    v.touch("throw.done");
    settled(name + " result");
    if (kind != Kind::describe) {
      v.touch("result.other");
      v.touch("leaving.go");
      continue;
    }
    v.touch("result.keep");
    settled(name + " kiln");
    v.touch("kiln.glaze.0");
    v.touch("kiln.keep");
    v.visit->show_postcard(9);
    v.visit->keepsake_kept("2026-05-04_141503");
    settled(name + " keepsake");
    v.touch("keepsake.gallery");
    settled(name + " gallery");
    v.touch("back");
    v.touch("keepsake.again");
  }
}

void check_missions(std::pair<int, int> size, const content::Language& language,
                    const Comforts& comforts) {
  static const std::vector<settings::Mission> missions = all_missions();
  Visitor v(9, &fonts(), true);
  std::tie(v.width, v.height) = size;
  v.languages = {language, v.languages.front()};
  for (const auto comfort : comforts) v.exhibit.screen.*comfort = true;
  v.put_tools_to_hand();
  for (const settings::Mission& mission : missions) v.put_on(mission, 0);
  v.keep_today(6);
  v.todays.front().vessel = "litre_jar";
  v.show();
  walk_missions(v, [&](const std::string& name) { check_layout(v, fonts(), name); });
}

TEST(MissionLayout, NothingIsCutAndNothingOverlapsAtAnySizeInAnyLanguage) {
  for (const auto& size : {std::pair(1280, 720), {1920, 1080}, {1080, 1920}, {1024, 600}})
    for (const content::Language& language : all_languages()) check_missions(size, language, {});
}

TEST(MissionLayout, NorWithWhatAVisitorMayChoose) {
  using Screen = settings::Exhibit::Screen;
  const Comforts each[] = {
      {&Screen::larger_text},
      {&Screen::left_handed, &Screen::high_contrast},
      {&Screen::one_switch},
      {&Screen::larger_text, &Screen::left_handed, &Screen::low_reach, &Screen::high_contrast,
       &Screen::reduced_motion, &Screen::spoken, &Screen::one_switch}};
  for (const auto& size : {std::pair(1280, 720), {1080, 1920}})
    for (const content::Language& language : all_languages()) {
      if (language.code() != "en" && language.code() != "ar" && language.code() != "xl") continue;
      for (const Comforts& comforts : each) check_missions(size, language, comforts);
    }
}

}  // namespace
}  // namespace onggi::screens::mission_layout_test
