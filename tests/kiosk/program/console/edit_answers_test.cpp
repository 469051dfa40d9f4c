#include "kiosk/program/console/edit_answers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/kiosk/exhibit/editing/small_site.h"

namespace onggi::console::edit_answers_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const char* const kUndo = R"({"id": "00000007"})";

/// A browser's request.
web::Ask asking(const std::string& from = "", const std::string& body = "") {
  web::Ask ask{"GET", "/"};
  ask.from = from;
  ask.body = body;
  return ask;
}

/// A site, and in the place of the program one that writes its words down, a line each, and says
/// that it is done.
class EditPage : public ::testing::Test {
 protected:
  EditPage() {
    program("printf '%s\\n' \"$@\" > " + words_file().string() +
            "; echo '{\"done\": true, \"changes\": []}'");
  }
  fs::path words_file() const { return folder_ / "words"; }
  void program(const std::string& script) const {
    std::ofstream(folder_ / "onggi") << "#!/bin/sh\n" << script << '\n';
    fs::permissions(folder_ / "onggi", fs::perms(0755));
  }
  json get(const std::string& name) { return json::parse(edit_.file(asking(), name).body); }
  web::Answer save(const std::string& changes, const std::string& tag,
                   const std::string& name = "exhibit") {
    const std::string body = R"({"tag": ")" + tag + R"(", "changes": )" + changes + "}";
    return edit_.save(asking("10.0.0.7", body), name, "maria", 1000);
  }
  static web::Ask asking_for(const std::string& number) {
    web::Ask ask = asking();
    ask.target = "/api/saved?number=" + number;
    return ask;
  }
  json saved(const std::string& number) {
    return json::parse(edit_.saved(asking_for(number)).body);
  }
  std::optional<ChangeLog::Change> wait() {
    for (int n = 0; n < 3000; ++n) {
      if (const auto change = edit_.ended(1000)) return change;
      if (!edit_.under_way()) return edit_.ended(1000);
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return std::nullopt;
  }
  std::vector<std::string> words() const {
    std::ifstream in(words_file());
    std::vector<std::string> out;
    for (std::string line; std::getline(in, line);) out.push_back(line);
    return out;
  }

  editing::test::SmallSite folder_;
  Site site_ = *Site::open(folder_.path());
  EditAnswers edit_{site_, folder_ / "onggi", folder_ / "state/sheets", folder_ / "trial"};
};

TEST_F(EditPage, AFileIsGivenWithItsValuesItsTagAndTheKeysThatMayBeChangedHere) {
  const json file = get("exhibit");
  EXPECT_EQ(file["values"]["idle"]["warn_after"], 60);
  EXPECT_EQ(file["values"]["title"]["ko"], "도자기 빚기");
  EXPECT_EQ(file["tag"], changes::tag_of(editing::test::content(folder_.exhibit())));
  EXPECT_EQ(file["languages"].size(), 8u);
  std::vector<std::string> keys;
  for (const json& field : file["fields"]["fields"]) keys.push_back(field["key"]);
  EXPECT_THAT(keys, ::testing::Contains("warn_after"));
  EXPECT_THAT(keys, ::testing::Not(::testing::Contains("shelf")));
  EXPECT_THAT(keys, ::testing::Not(::testing::Contains("folder")));
  folder_.write("config/exhibit.toml", "credit = \n");
  EXPECT_EQ(edit_.file(asking(), "exhibit").status, 409);
  EXPECT_EQ(edit_.file(asking(), "vessel/none").status, 404);
}

TEST_F(EditPage, AChangeIsHandedOnInTheFilesOwnWordsAndNotedWithWhoMadeIt) {
  const std::string tag = get("exhibit")["tag"];
  ASSERT_EQ(
      save(R"([["credit", "Museum \"of\" Clay"], ["idle.warn_after", 90], ["store.months", null]])",
           tag)
          .status,
      202);
  const auto change = wait();
  ASSERT_TRUE(change);
  EXPECT_THAT(words(), ElementsAre("set", "--json", "-", "--if", tag, "--without", "store.months",
                                   folder_.exhibit().string(), "credit",
                                   "\"Museum \\\"of\\\" Clay\"", "idle.warn_after", "90"));
  EXPECT_EQ(change->who, "maria");
  EXPECT_EQ(change->from, "10.0.0.7");
  EXPECT_THAT(change->what, HasSubstr("exhibit.toml: credit is \"Museum"));
  EXPECT_FALSE(edit_.ended(1000));
  EXPECT_EQ(saved("1")["said"]["done"], true);
  EXPECT_EQ(edit_.saved(asking_for("2")).status, 404);
  // Another one after it takes nothing of the first from who asks late.
  ASSERT_EQ(save(R"([["credit", "B"]])", tag).status, 202);
  EXPECT_EQ(saved("1")["said"]["done"], true);
  EXPECT_TRUE(wait());
}

TEST_F(EditPage, AFileThatSomebodyElseChangedIsNotWritten) {
  const std::string tag = get("exhibit")["tag"];
  folder_.by_hand("config/exhibit.toml", "warn_after = 60 ", "warn_after = 70 ");
  EXPECT_EQ(save(R"([["credit", "Clay"]])", tag).status, 412);
  EXPECT_EQ(save(R"([["credit", "Clay"]])", "").status, 409);
  EXPECT_FALSE(fs::exists(words_file()));
  EXPECT_EQ(save(R"([["credit", "Clay"]])", get("exhibit")["tag"]).status, 202);
  EXPECT_TRUE(wait());
}

TEST_F(EditPage, AFaultIsSaidAtOnceAndNothingBegins) {
  const web::Answer answer = save(R"([["idle.warn_after", 5]])", get("exhibit")["tag"]);
  EXPECT_EQ(answer.status, 409);
  EXPECT_EQ(json::parse(answer.body)["faults"][0]["key"], "idle.warn_after");
  EXPECT_EQ(save("[]", get("exhibit")["tag"]).status, 409);
  EXPECT_THAT(save(R"([["idle.warn_after", 60]])", get("exhibit")["tag"]).body,
              HasSubstr("It is so already."));
  EXPECT_FALSE(fs::exists(words_file()));
}

TEST_F(EditPage, TwoAtOnceMakeNoMixture) {
  program("while [ ! -e " + (folder_ / "go").string() +
          " ]; do sleep 0.02; done; echo '{\"done\": false}'");
  const std::string tag = get("exhibit")["tag"];
  ASSERT_EQ(save(R"([["credit", "A"]])", tag).status, 202);
  const web::Answer second = save(R"([["credit", "B"]])", tag);
  EXPECT_EQ(second.status, 503);
  EXPECT_THAT(second.body, HasSubstr("Another change is being made"));
  EXPECT_EQ(edit_.undo(asking("", kUndo), "joon", 1).status, 503);
  folder_.write("go", "");
  EXPECT_FALSE(wait());  // refused by the program: nothing to note
}

TEST_F(EditPage, TakingBackIsAskedOfTheProgramAndNoted) {
  program("printf '%s\\n' \"$@\" > " + words_file().string() +
          "; echo '{\"done\": true, \"words\": [\"credit is A again.\"]}'");
  EXPECT_EQ(edit_.undo(asking("10.0.0.8", "{}"), "joon", 1000).status, 409);
  ASSERT_EQ(edit_.undo(asking("10.0.0.8", kUndo), "joon", 1000).status, 202);
  const auto change = wait();
  ASSERT_TRUE(change);
  EXPECT_THAT(words(), ElementsAre("undo", "--json", "-", "--if", "00000007", "--config",
                                   folder_.exhibit().string()));
  EXPECT_EQ(change->did, "took back");
  EXPECT_THAT(change->what, HasSubstr("credit is A again."));
  ASSERT_EQ(edit_.undo(asking("", R"({"id": "00000007", "forget": true})"), "joon", 1).status, 202);
  EXPECT_EQ(wait()->did, "forgot");
  EXPECT_EQ(words().back(), "--forget");
}

TEST_F(EditPage, TheShelfIsInTheOrderOfVisitorsWithWhatTheyDoNotSee) {
  for (const char* id : {"olla", "albarello", "tea_bowl"})
    fs::copy(fs::path("content/vessels") / id, folder_ / "content/vessels" / id);
  folder_.by_hand("config/exhibit.toml", "order = [\"moon_jar\"]",
                  "order = [\"tea_bowl\", \"olla\"]");
  folder_.by_hand("config/exhibit.toml", "hidden = []", "hidden = [\"olla\"]");
  const json shelf = json::parse(edit_.shelf(asking()).body);
  std::vector<std::string> ids;
  for (const json& one : shelf) ids.push_back(one["id"]);
  EXPECT_THAT(ids, ElementsAre("tea_bowl", "olla", "albarello", "moon_jar"));
  EXPECT_EQ(shelf[1]["hidden"], true);
  EXPECT_EQ(shelf[3]["titles"]["ko"], "달항아리");
  EXPECT_EQ(edit_.outline(asking(), "tea_bowl").type, "image/svg+xml");
  EXPECT_EQ(edit_.outline(asking(), "../tea_bowl").status, 404);
}

/// What is tried, as a page is told of it.
class TriedOnThePage : public EditPage {
 protected:
  TriedOnThePage() {
    program("printf '%s\\n' \"$@\" > " + words_file().string() +
            "; echo '{\"done\": true, \"changes\": [], \"revision\": \"00000005\", \"words\": "
            "[\"It is 60 again.\"]}'");
  }
  void begin() {
    const std::string tag = get("exhibit")["tag"];
    const std::string body =
        R"({"try": true, "tag": ")" + tag + R"(", "changes": [["idle.warn_after", 90]]})";
    ASSERT_EQ(edit_.save(asking("", body), "exhibit", "maria", 1000).status, 202);
    ASSERT_TRUE(wait());
  }
  json trial(std::int64_t now = 1000) { return json::parse(edit_.trial(now).text(-1)); }
  /// Waits for what is begun at `now` by itself.
  std::optional<ChangeLog::Change> by_itself(std::int64_t now) {
    EXPECT_FALSE(edit_.ended(now));
    for (int n = 0; n < 3000 && edit_.under_way(); ++n)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return edit_.ended(now);
  }
};

TEST_F(TriedOnThePage, AChangeIsTakenBackByItselfAfterFiveMinutes) {
  begin();
  EXPECT_EQ(trial(1060)["left"], 240);
  EXPECT_THAT(trial()["what"].get<std::string>(), HasSubstr("idle.warn_after is 90 now"));
  EXPECT_FALSE(by_itself(1000 + ChangeOnTrial::kLasts - 1));
  EXPECT_EQ(words().front(), "set");
  const auto back = by_itself(1000 + ChangeOnTrial::kLasts);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->did, "put back");
  EXPECT_THAT(words(), ElementsAre("undo", "--json", "-", "--if", "00000005", "--config",
                                   folder_.exhibit().string()));
  EXPECT_TRUE(trial().value("put_back", false));
  EXPECT_FALSE(by_itself(9000));
}

TEST_F(TriedOnThePage, ItIsTakenBackThoughTheProgramWasKilled) {
  begin();
  EditAnswers again(site_, folder_ / "onggi", folder_ / "state/sheets", folder_ / "trial");
  EXPECT_EQ(json::parse(again.trial(1100).text(-1))["left"], 200);
  EXPECT_FALSE(again.ended(2000));
  for (int n = 0; n < 3000 && again.under_way(); ++n)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_TRUE(again.ended(2000));
  EXPECT_EQ(words().front(), "undo");
  EXPECT_FALSE(fs::exists(folder_ / "trial"));
}

TEST_F(TriedOnThePage, WhatIsKeptStaysAndNothingElseIsChangedUntilThen) {
  begin();
  const std::string tag = get("exhibit")["tag"];
  EXPECT_EQ(save(R"([["credit", "Clay"]])", tag).status, 409);
  EXPECT_EQ(edit_.undo(asking("", kUndo), "maria", 1000).status, 409);
  EXPECT_EQ(edit_.end_trial(asking(), "else", "maria", 1000).status, 404);
  EXPECT_EQ(edit_.end_trial(asking(), "keep", "maria", 1000).status, 200);
  EXPECT_TRUE(trial().is_null());
  EXPECT_FALSE(by_itself(9000));
  EXPECT_EQ(words().front(), "set");
  EXPECT_EQ(save(R"([["credit", "Clay"]])", tag).status, 202);
  wait();
}

TEST_F(TriedOnThePage, ItIsTakenBackAtOnceWhereSomebodyWantsThat) {
  begin();
  EXPECT_EQ(edit_.end_trial(asking(), "back", "maria", 1010).status, 202);
  ASSERT_TRUE(wait());
  EXPECT_EQ(words().front(), "undo");
  EXPECT_TRUE(trial().value("put_back", false));
}

TEST_F(TriedOnThePage, WhatCannotBeTakenBackIsToldAndNotTriedForEver) {
  begin();
  program(R"(echo '{"done": false, "what": "Changed by hand.", "remedy": "Look."}'; exit 2)");
  EXPECT_FALSE(by_itself(2000));
  EXPECT_EQ(trial()["trouble"], "Changed by hand. Look.");
  EXPECT_FALSE(by_itself(3000));
  EXPECT_EQ(edit_.end_trial(asking(), "keep", "maria", 1000).status, 200);
  EXPECT_TRUE(trial().is_null());
}

TEST_F(TriedOnThePage, ARefusedChangeIsNotTried) {
  program(R"(echo '{"done": false, "what": "No."}'; exit 2)");
  const std::string tag = get("exhibit")["tag"];
  const std::string body =
      R"({"try": true, "tag": ")" + tag + R"(", "changes": [["idle.warn_after", 90]]})";
  ASSERT_EQ(edit_.save(asking("", body), "exhibit", "maria", 1000).status, 202);
  EXPECT_FALSE(wait());
  EXPECT_TRUE(trial().is_null());
  EXPECT_FALSE(fs::exists(folder_ / "trial"));
}

}  // namespace
}  // namespace onggi::console::edit_answers_test
