#include <gtest/gtest.h>

#include <filesystem>

#include "kiosk/collection/settings/visitor_text.h"
#include "kiosk/picture/render/text.h"
#include "tests/kiosk/visit/screens/layout_check.h"
#include "tests/support/open_shelf.h"

namespace onggi::screens::fonts_test {
namespace {

/// All languages that come with the exhibit, whether it offers them or not.
std::vector<content::Language> all_languages() {
  std::vector<content::Language> all;
  for (const auto& file : std::filesystem::directory_iterator("content/languages")) {
    auto read = content::Language::read(file.path());
    EXPECT_TRUE(read) << (read ? "" : to_text(read.error()));
    if (read) all.push_back(*read);
  }
  EXPECT_GE(all.size(), 5u);
  return all;
}

/// The exhibit's own shelf and the fonts it is shown in, in every language that comes.
void check_all(int width, int height, bool larger = false) {
  const render::Typesetter fonts;
  const content::OpenedShelf shelf = content::open_shelf("content/vessels");
  ASSERT_GE(shelf.vessels.size(), 8u);
  for (const content::Language& language : all_languages()) {
    Visitor v(0, &fonts, true);
    v.languages = {language, v.languages.front()};
    v.put_tools_to_hand();
    v.vessels = shelf.vessels;
    for (content::Vessel& vessel : v.vessels) {
      const double scale = 0.2 / vessel.extracted.profile.height();
      v.shelf.push_back({&vessel, 7, scaled(vessel.extracted.profile, scale), scale, v.wheel});
    }
    v.width = width;
    v.height = height;
    v.exhibit.screen.larger_text = larger;
    v.keep_today(20);
    v.show();
    walk(v, [&](const std::string& name) { check_layout(v, fonts, language.code() + " " + name); });
    EXPECT_LE(v.most_measured, Measuring::kMostBytes / 4 * 3) << "no page of these is ever guessed";
  }
}

TEST(Fonts, NothingIsCutOrOverlapsAt1280x720) { check_all(1280, 720); }
TEST(Fonts, NothingIsCutOrOverlapsAt1920x1080) { check_all(1920, 1080); }
TEST(Fonts, NothingIsCutOrOverlapsAt1080x1920) { check_all(1080, 1920); }
TEST(Fonts, NothingIsCutOrOverlapsAt1024x600) { check_all(1024, 600); }

TEST(Fonts, NorWithLargerTextUpright) { check_all(1080, 1920, true); }
TEST(Fonts, NorWithLargerTextAcross) { check_all(1280, 720, true); }

TEST(Fonts, EveryVesselsLabelIsReadToItsEndInEveryLanguage) {
  const render::Typesetter fonts;
  const content::OpenedShelf shelf = content::open_shelf("content/vessels");
  for (const content::Language& language : all_languages()) {
    Visitor v(0, &fonts);
    v.languages = {language, v.languages.front()};
    v.vessels = shelf.vessels;
    for (content::Vessel& vessel : v.vessels)
      v.shelf.push_back({&vessel, 7, jar(0.08), 0.65, v.wheel});
    v.width = 1024;
    v.height = 600;
    v.show();
    v.down(500, 5), v.up(500, 5);
    v.show();
    for (std::size_t i = 0; i < v.shelf.size(); ++i) {
      const std::string card = "choose.card." + std::to_string(i);
      while (!v.visit->control(card) && v.visit->control("choose.next")) {
        v.touch("choose.next");
        v.frames(1.5);
      }
      v.touch(card);
      std::string read;
      for (int part = 0; part < 6; ++part) {
        read += words_in(v.frame);
        check_layout(v, fonts, v.vessels[i].id);
        if (!v.visit->control("choose.more")) break;
        v.touch("choose.more");
      }
      // The label's last words are there, wherever it was broken.
      const std::string text = v.vessels[i].label(v.visit->language()).text;
      EXPECT_NE(read.find(text.substr(text.size() - 12)), std::string::npos) << v.vessels[i].id;
      v.touch("back");
    }
  }
}

/// As many letters as `bound` has, of words of a label in that writing.
std::string as_long_as(settings::TextBound bound, const std::string& words) {
  std::string all;
  while (settings::letters(all) < bound.letters) all += words;
  return settings::fitted(all, bound);
}

TEST(Fonts, ALabelAsLongAsCheckAllowsIsReadToItsEndOnEveryScreen) {
  namespace bounds = settings::bounds;
  const render::Typesetter fonts;
  const std::pair<const char*, const char*> writings[] = {
      {"en", "A jar that potters threw of dark clay. "},
      {"de", "Vorratsgefäße der Töpferwerkstatt. "},
      {"ko", "물레로 빚은 큰 항아리입니다. "},
      {"ja", "大きな壺をろくろで挽いています。"},
      {"ar", "شُكّل الوعاء الكبير على العجلة. "}};
  for (const auto& [width, height] :
       {std::pair(1280, 720), {1920, 1080}, {1080, 1920}, {1024, 600}})
    for (const auto& [code, words] : writings) {
      auto language = content::Language::read(std::string("content/languages/") + code + ".toml");
      ASSERT_TRUE(language);
      Visitor v(2, &fonts);
      v.languages = {*language};
      v.width = width;
      v.height = height;
      for (content::Vessel& vessel : v.vessels)
        vessel.labels[code] = {
            as_long_as(bounds::kTitle, words),          as_long_as(bounds::kCulture, words),
            as_long_as(bounds::kDate, words),           as_long_as(bounds::kMade, words),
            as_long_as(bounds::kText, words) + " Ende", as_long_as(bounds::kLabelCredit, words)};
      v.show();
      v.touch("attract.begin");
      v.frames(1);
      check_layout(v, fonts, std::string("shelf ") + code);
      v.touch("choose.card.0");
      v.frames(1);
      std::string read;
      for (int part = 0; part < 80; ++part) {
        read += words_in(v.frame);
        check_layout(v, fonts, std::string("label ") + code);
        if (!v.visit->control("choose.more")) break;
        if (read.find("Ende") != std::string::npos) break;
        v.touch("choose.more");
      }
      EXPECT_NE(read.find("Ende"), std::string::npos) << code << " " << width;
    }
}

}  // namespace
}  // namespace onggi::screens::fonts_test
