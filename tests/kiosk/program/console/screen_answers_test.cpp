#include "kiosk/program/console/screen_answers.h"

#include <gtest/gtest.h>
#include <sys/file.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "kiosk/ground/files/descriptor.h"
#include "kiosk/program/watch/state_board.h"
#include "tests/kiosk/program/console/staff_page.h"

namespace onggi::console::screen_answers_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// The staff's page with a program that "draws" its own words.
class Screens : public test::StaffPage {
 protected:
  void SetUp() override {
    StaffPage::SetUp();
    draws("sleep 0");
  }
  void draws(const std::string& first) {
    const fs::path program = site_ / "onggi";
    std::ofstream(program)
        << "#!/bin/sh\n"
        << first << "\nfor word in \"$@\"; do printf '%s\\n' \"$word\"; done > '"
        << words().string() << "'\nbytes=$(wc -c < '" << words().string()
        << "')\necho "
           "'{\"done\":true,\"pictures\":[{\"width\":4,\"height\":3,\"bytes\":'$bytes'}]}'\n"
        << "cat '" << words().string() << "'\n";
    fs::permissions(program, fs::perms(0755));
    serve(program);
  }
  fs::path words() const { return site_ / "words"; }
  json begun(const std::string& body) {
    const web::Answer answer = post("/api/screen", body);
    EXPECT_EQ(answer.status, 202) << answer.body;
    return json::parse(answer.body)["number"];
  }
  json end_of(const json& number) {
    for (int n = 0; n < 3000; ++n) {
      const json now = json::parse(get("/api/screen?number=" + number.dump()).body);
      if (!now.value("drawing", false)) return now;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    ADD_FAILURE() << "it does not end";
    return {};
  }
  void expect_refused(const std::string& body, int status, const std::string& words) {
    const web::Answer answer = post("/api/screen", body);
    EXPECT_EQ(answer.status, status) << body;
    EXPECT_NE(answer.body.find(words), std::string::npos) << answer.body;
  }
};

TEST_F(Screens, AreDrawnWithWhatIsTypedAndTheFileStays) {
  const std::string before = files::test::content(site_ / "config/exhibit.toml");
  const json number = begun(
      R"({"screen": "label", "vessel": "moon_jar", "language": "ko", "comfort": "larger_text",
          "file": "exhibit", "changes": [["credit", "-x --out /"], ["idle.warn_after", 90]]})");
  const json drawn = end_of(number);
  ASSERT_EQ(drawn["pictures"].size(), 1u) << drawn;
  EXPECT_EQ(drawn["pictures"][0]["at"], "/screen/" + number.dump() + "/0");
  const web::Answer picture = get(drawn["pictures"][0]["at"]);
  EXPECT_EQ(picture.type, "image/jpeg");
  const std::string file = (site_ / "config/exhibit.toml").string();
  EXPECT_EQ(picture.body, "screen\n--page\n--config\n" + file +
                              "\n--sizes\n1280x720,1080x1920\n--language\nko\n--vessel\nmoon_jar\n"
                              "--comfort\nlarger_text\n--of\n" +
                              file + "\nlabel\ncredit\n\"-x --out /\"\nidle.warn_after\n90\n");
  EXPECT_EQ(files::test::content(site_ / "config/exhibit.toml"), before);
  EXPECT_EQ(get("/screen/" + number.dump() + "/1").status, 404);
  EXPECT_EQ(get("/screen/99/0").status, 404);
  EXPECT_EQ(get("/screen/../0").status, 404);
  EXPECT_EQ(get("/api/screen?number=99").status, 404);
}

TEST_F(Screens, ThatCannotBeAreRefusedBeforeAnythingBegins) {
  expect_refused(R"({"screen": "--out"})", 409, "no choice");
  expect_refused(R"({"screen": "a b"})", 409, "no choice");
  expect_refused(R"({})", 409, "no choice");
  expect_refused("[]", 409, "no choice");
  expect_refused(R"({"screen": "label", "vessel": "-x"})", 409, "no choice");
  expect_refused(R"({"screen": "label", "language": "../ko"})", 409, "no choice");
  expect_refused(R"({"screen": "label", "file": "passwd", "changes": []})", 404, "no such file");
  expect_refused(R"({"screen": "label", "file": "exhibit"})", 409, "no change");
  expect_refused(R"({"screen": "label", "file": "exhibit", "changes": [["idle.warn_after", 5]]})",
                 409, "smallest allowed value");
  expect_refused(R"({"screen": "label", "file": "exhibit", "changes": [["shelf", "/"]]})", 409,
                 "faults");
  expect_refused(R"({"screen": "label", "vessel": "../jar"})", 409, "no choice");
  EXPECT_FALSE(fs::exists(words()));
  EXPECT_EQ(end_of(begun(R"({"screen": "label", "vessel": "달 항아리"})"))["pictures"].size(), 1u);
  EXPECT_EQ(end_of(begun(R"({"screen": "label"})"))["pictures"].size(), 1u) << "and this one can";
}

TEST_F(Screens, OneIsDrawnAtATimeAndItEndsWhenItIsNotWanted) {
  draws("sleep 600");
  const json number = begun(R"({"screen": "label"})");
  expect_refused(R"({"screen": "label"})", 503, "Another screen");
  EXPECT_EQ(post("/api/screen/stop").status, 200);
  const json ended = end_of(number);
  EXPECT_TRUE(ended["visitor"]) << "asked again, it would be drawn";
  EXPECT_TRUE(ended["pictures"].empty());
}

TEST_F(Screens, AVisitorComesFirst) {
  draws("sleep 600");
  const json number = begun(R"({"screen": "label"})");
  watch::StateBoard kiosk(keepsakes_);
  watch::KioskState state;
  state.said = now_;
  state.open = state.visitor = true;
  kiosk.show(state);
  EXPECT_TRUE(end_of(number)["visitor"]) << "it ended as soon as somebody played";
  expect_refused(R"({"screen": "label"})", 409, R"("visitor":true)");
}

TEST_F(Screens, TheDeskSeesNone) {
  ASSERT_EQ(add("maria", "desk").status, 200);
  const json number = begun(R"({"screen": "label"})");
  end_of(number);
  ASSERT_EQ(enter("maria", "a passphrase of maria").status, 200);
  EXPECT_EQ(post("/api/screen", R"({"screen": "label"})").status, 403);
  EXPECT_EQ(get("/api/screen?number=" + number.dump()).status, 403);
  EXPECT_EQ(get("/screen/" + number.dump() + "/0").status, 403);
}

}  // namespace
}  // namespace onggi::console::screen_answers_test
