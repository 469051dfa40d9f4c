#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

#include "kiosk/collection/content/drawing.h"
#include "kiosk/collection/content/glaze.h"
#include "kiosk/collection/content/lesson.h"
#include "kiosk/collection/content/pack.h"
#include "kiosk/collection/content/vessel.h"
#include "kiosk/ground/toml/toml_reader.h"

// What the packs of content/vessels say, read without the catalogue.

namespace onggi::content::shelf_packs_test {
namespace {

namespace fs = std::filesystem;

struct Pack {
  std::string source, credit, licence;
  double height = 0.0, diameter = 0.0;  // Millimetres.
  std::map<std::string, Label> labels;
};

const std::map<std::string, Pack>& packs() {
  static const std::map<std::string, Pack> all = [] {
    std::map<std::string, Pack> out;
    for (const auto& folder : fs::directory_iterator("content/vessels")) {
      if (!folder.is_directory()) continue;
      toml::TomlReader reader(folder.path() / "vessel.toml");
      auto root = reader.root();
      Pack& pack = out[folder.path().filename().string()];
      root.text("source", pack.source);
      root.text("credit", pack.credit);
      root.text("licence", pack.licence);
      root.number("true_height_mm", pack.height, 1.0, 2000.0);
      root.number("true_diameter_mm", pack.diameter, 1.0, 2000.0);
      const PackRead read = read_pack(folder.path() / "vessel.toml");
      for (const auto& [language, known] : read.pack.labels) {
        auto table = root.child("label").child(language);
        Label& label = pack.labels[language];
        table.text("title", label.title);
        table.text("what", label.what);
        table.text("culture", label.culture);
        table.text("date", label.date);
        table.text("made", label.made);
        table.text("text", label.text);
        table.text("credit", label.credit);
      }
    }
    return out;
  }();
  return all;
}

std::size_t words(const std::string& text) {
  std::istringstream in(text);
  return static_cast<std::size_t>(
      std::distance(std::istream_iterator<std::string>(in), std::istream_iterator<std::string>()));
}

/// Split after a full stop, question mark or exclamation mark that a space follows.
std::vector<std::string> sentences(const std::string& text) {
  std::vector<std::string> out(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    out.back() += text[i];
    if ((text[i] == '.' || text[i] == '?' || text[i] == '!') && i + 1 < text.size() &&
        text[i + 1] == ' ')
      out.emplace_back();
  }
  return out;
}

bool has_hangul(const std::string& text) {
  // U+AC00..U+D7A3 begin with the bytes EA B0 .. ED 9E in UTF-8.
  for (const char c : text)
    if (static_cast<unsigned char>(c) >= 0xEA && static_cast<unsigned char>(c) <= 0xED) return true;
  return false;
}

TEST(ShelfPacks, eight_vessels_or_more_come_from_five_cultures_or_more) {
  EXPECT_GE(packs().size(), 8u);
  // "Korea, Joseon dynasty" and "Korea" are of one culture.
  std::set<std::string> cultures;
  for (const auto& [id, pack] : packs()) {
    const std::string& culture = pack.labels.at("en").culture;
    cultures.insert(culture.substr(0, culture.find(',')));
  }
  EXPECT_GE(cultures.size(), 5u);
}

TEST(ShelfPacks, every_vessel_says_who_measured_it_and_who_may_use_it) {
  for (const auto& [id, pack] : packs()) {
    EXPECT_FALSE(pack.source.empty()) << id;
    EXPECT_FALSE(pack.credit.empty()) << id;
    EXPECT_EQ(pack.licence, "CC0-1.0") << id;
  }
}

/// The languages that `words` are in.
template <class Words>
std::set<std::string> languages_of(const std::map<std::string, Words>& words) {
  std::set<std::string> codes;
  for (const auto& [code, text] : words) codes.insert(code);
  return codes;
}

TEST(ShelfPacks, a_language_that_one_label_has_all_labels_glazes_steps_and_screens_have) {
  std::set<std::string> all;
  for (const auto& [id, pack] : packs()) all.merge(languages_of(pack.labels));
  for (const char* code : {"en", "ko", "es", "fr", "de", "ja", "zh", "ar"})
    EXPECT_TRUE(all.contains(code)) << code;
  for (const std::string& code : all)
    EXPECT_TRUE(fs::exists("content/languages/" + code + ".toml")) << code;
  for (const auto& [id, pack] : packs()) EXPECT_EQ(languages_of(pack.labels), all) << id;
  for (const Glaze& glaze : read_glazes("content/glazes.toml").glazes) {
    EXPECT_EQ(languages_of(glaze.name), all) << glaze.id;
    EXPECT_EQ(languages_of(glaze.about), all) << glaze.id;
  }
  for (const char* lesson : {"first_minute", "building"})
    for (const LessonStep& step :
         read_lesson("content/lessons/" + std::string(lesson) + ".toml").steps)
      EXPECT_EQ(languages_of(step.words), all) << step.id;
}

TEST(ShelfPacks, every_label_is_whole_in_each_of_its_languages) {
  for (const auto& [id, pack] : packs())
    for (const auto& [language, label] : pack.labels) {
      SCOPED_TRACE(id + " " + language);
      for (const std::string* text :
           {&label.title, &label.what, &label.culture, &label.date, &label.made, &label.text})
        EXPECT_FALSE(text->empty());
      for (const std::string* text :
           {&label.title, &label.what, &label.culture, &label.made, &label.text})
        EXPECT_EQ(has_hangul(*text), language == "ko") << *text;
      // English has it in the pack itself.
      EXPECT_EQ(has_hangul(label.credit), language == "ko") << label.credit;
    }
}

TEST(ShelfPacks, no_label_is_longer_than_a_visitor_reads) {
  for (const auto& [id, pack] : packs())
    for (const auto& [language, label] : pack.labels) {
      EXPECT_LE(words(label.text), 100u) << id << " " << language;
      for (const std::string& text : {label.text, label.made})
        for (const std::string& sentence : sentences(text))
          EXPECT_LE(words(sentence), 25u) << id << " " << language << ": " << sentence;
    }
}

TEST(ShelfPacks, a_vessel_that_no_wheel_made_says_that_only_its_shape_is_tried_here) {
  const std::pair<const char*, const char*> calls[] = {
      {"en", "you try only its shape"},     {"ko", "여기서는 형태만"},
      {"es", "Aquí pruebas solo su forma"}, {"fr", "vous n’essayez que sa forme"},
      {"de", "probieren Sie nur die Form"}, {"ja", "ここでは形だけ"},
      {"zh", "这里只做它的器形"},           {"ar", "تجرّب شكلها فقط"}};
  for (const char* id : {"black_topped_jar", "cylinder_vase", "olla"})
    for (const auto& [code, words] : calls)
      EXPECT_NE(packs().at(id).labels.at(code).made.find(words), std::string::npos) << id << code;
}

TEST(ShelfPacks, every_drawing_has_the_height_and_diameter_that_its_label_claims) {
  for (const auto& [id, pack] : packs()) {
    const auto drawing = read_drawing(fs::path("content/vessels") / id / "profile.toml");
    ASSERT_TRUE(drawing) << to_text(drawing.error());
    double height = 0.0, radius = 0.0;
    for (const Vec2& p : drawing->section.outline) {
      height = std::max(height, p.y);
      radius = std::max(radius, p.x);
    }
    EXPECT_NEAR(1000.0 * height, pack.height, 0.002 * pack.height) << id;
    EXPECT_NEAR(2000.0 * radius, pack.diameter, 0.002 * pack.diameter) << id;
  }
}

// A line in vessel.toml switches a decoration on. The olla's waits: nobody has asked the Pueblo.
TEST(ShelfPacks, ADecorationIsShownWhereVesselTomlNamesIt) {
  int shown = 0, waiting = 0;
  for (const auto& folder : fs::directory_iterator("content/vessels")) {
    if (!fs::exists(folder.path() / "decoration.toml")) continue;
    const bool named = !read_pack(folder.path() / "vessel.toml").pack.decoration.empty();
    const auto vessel = load_vessel(folder.path());
    ASSERT_TRUE(vessel) << to_text(vessel.error());
    EXPECT_EQ(vessel->coloring.pictures.size(), named ? 1u : 0u) << folder.path();
    ++(named ? shown : waiting);
  }
  EXPECT_EQ(shown, 9);
  EXPECT_EQ(waiting, 1);
}

}  // namespace
}  // namespace onggi::content::shelf_packs_test
