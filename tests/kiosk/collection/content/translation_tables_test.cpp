#include "kiosk/collection/content/translation_tables.h"

#include "kiosk/collection/content/glaze.h"
#include "kiosk/collection/content/language.h"
#include "kiosk/collection/content/lesson.h"
#include "kiosk/collection/content/vessel.h"
#include "kiosk/collection/settings/mission_file.h"
#include "tests/kiosk/collection/content/temporary.h"

namespace onggi::content::translation_tables_test {
namespace {

class TranslationTables : public Temporary {
 protected:
  /// A language's file with `tables`.
  std::filesystem::path german(const std::string& tables) {
    return write("de.toml",
                 "code = \"de\"\nname = \"Deutsch\"\n[text]\nplain = \"Gefäß\"\n" + tables);
  }
  settings::Translations read(const std::string& tables) {
    return read_translations(german(tables).parent_path(), {"de"});
  }
  /// The advice on `tables`, each with its place.
  std::string advice(const std::string& tables, const KnownIds& known = {}) {
    const LanguageRead read = check_language(german(tables), known);
    EXPECT_TRUE(read.problems.empty()) << to_text(read.problems.front());
    std::string all;
    for (const Problem& p : read.advice)
      if (p.what.find(" is missing.") == std::string::npos) all += to_text(p) + "\n";
    return all;
  }
};

TEST_F(TranslationTables, speak_for_a_glaze_over_its_own_words) {
  const auto file = write("glazes.toml",
                          "[[glaze]]\nid = \"celadon\"\nbody = \"#AA7652\"\nglass = \"#9DB5A0\"\n"
                          "name = { en = \"Celadon\", de = \"Grün\" }\n");
  const auto said = read("[glaze.celadon]\nname = \"Seladon\"\nabout = \"Blassgrün.\"\n");
  const GlazesRead glazes = read_glazes(file, {"en", "de"}, said);
  ASSERT_EQ(glazes.problems.size(), 0u) << to_text(glazes.problems.front());
  EXPECT_EQ(glazes.glazes.at(0).name_in("de"), "Seladon");
  EXPECT_EQ(glazes.glazes.at(0).about_in("de"), "Blassgrün.");
  EXPECT_EQ(glazes.glazes.at(0).name_in("en"), "Celadon");
}

TEST_F(TranslationTables, speak_for_a_step_of_the_lesson_and_a_mission_that_lack_the_language) {
  const auto lesson = write("lesson.toml",
                            "[[step]]\nid = \"centre\"\nhands = \"around\"\nuntil = \"touched\"\n"
                            "words = { en = \"Touch it.\" }\n");
  const auto missions = write("missions.toml",
                              "[[mission]]\nid = \"today\"\nkind = \"today\"\n"
                              "title = { en = \"Today\" }\nabout = { en = \"This one.\" }\n");
  const auto said = read(
      "[lesson.centre]\nwords = \"Fass es an.\"\n"
      "[mission.today]\ntitle = \"Heute\"\nabout = \"Dieses.\"\n");
  const LessonRead steps = read_lesson(lesson, {"en", "de"}, said);
  EXPECT_TRUE(steps.problems.empty());
  EXPECT_EQ(steps.steps.at(0).words_in("de"), "Fass es an.");
  const auto read = settings::read_missions(missions, {"en", "de"}, {}, said);
  EXPECT_TRUE(read.problems.empty());
  EXPECT_EQ(read.missions.at(0).title_in("de"), "Heute");
  EXPECT_EQ(read.missions.at(0).about_in("de"), "Dieses.");
}

TEST_F(TranslationTables, speak_for_a_vessel_and_what_they_leave_out_is_said_in_english) {
  Vessel vessel;
  vessel.id = "moon_jar";
  vessel.labels["en"] = Label{"Moon jar", "Korea", "18th century", "Thrown.", "Porcelain.", ""};
  translate(vessel, read("[vessel.moon_jar]\ntitle = \"Mondkrug\"\ndate = \"18. Jh.\"\n"));
  EXPECT_EQ(vessel.label("de").title, "Mondkrug");
  EXPECT_EQ(vessel.label("de").date, "18. Jh.");
  EXPECT_EQ(vessel.label("de").culture, "Korea");
  EXPECT_EQ(vessel.label("en").title, "Moon jar");
  Vessel other;
  other.id = "tea_bowl";
  translate(other, read("[vessel.moon_jar]\ntitle = \"Mondkrug\"\n"));
  EXPECT_TRUE(other.labels.empty());
}

TEST_F(TranslationTables, of_things_that_the_exhibit_does_not_have_are_named_with_their_line) {
  const KnownIds known{{"vessel", {"moon_jar"}}, {"glaze", {"celadon"}}, {"lesson", {"centre"}}};
  const std::string all = advice(
      "[vessel.moon_jr]\ntitle = \"Mondkrug\"\n[glaze.celadon]\nnam = \"Seladon\"\n"
      "[lesson.zzz]\nwords = \"Fass es an.\"\n[mission.any]\ntitle = \"Heute\"\n",
      known);
  EXPECT_NE(all.find("de.toml:5"), std::string::npos) << all;
  EXPECT_NE(all.find("This exhibit has no vessel \"moon_jr\"."), std::string::npos) << all;
  EXPECT_NE(all.find("Did you mean [vessel.moon_jar]?"), std::string::npos) << all;
  EXPECT_NE(all.find("de.toml:8:1"), std::string::npos) << all;
  EXPECT_NE(all.find("Did you mean name?"), std::string::npos) << all;
  EXPECT_NE(all.find("This exhibit has no step of the lesson \"zzz\"."), std::string::npos) << all;
  EXPECT_EQ(all.find("mission"), std::string::npos) << "nobody knows which there are\n" << all;
}

TEST_F(TranslationTables, that_do_not_fit_or_are_empty_are_named_and_left_out) {
  const std::string tables = "[lesson.centre]\nwords = \"" + std::string(121, 'x') +
                             "\"\n[mission.today]\ntitle = \"" + std::string(41, 'x') +
                             "\"\n[glaze.celadon]\nname = \" \"\n[vessel.moon_jar]\n"
                             "address = \"www\"\n";
  const std::string all = advice(tables);
  for (const char* fault :
       {"words has 121 letters", "title has 41 letters", "name is empty.", "de.toml:12"})
    EXPECT_NE(all.find(fault), std::string::npos) << fault << "\n" << all;
  EXPECT_TRUE(read(tables).languages.empty());
}

}  // namespace
}  // namespace onggi::content::translation_tables_test
