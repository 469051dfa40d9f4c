#include "kiosk/keepsake/phone/answers.h"

#include <gmock/gmock.h>

#include <set>
#include <vector>

#include "kiosk/ground/files/local_time.h"
#include "kiosk/keepsake/phone/page_files.h"
#include "kiosk/keepsake/souvenir/fetch_note.h"
#include "tests/kiosk/keepsake/phone/phone_fixture.h"

namespace onggi::phone::answers_test {
namespace {

namespace fs = std::filesystem;
using test::kHour;
using test::kNow;
using test::kVisit;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class PhoneTest : public test::PhoneTest {};

TEST_F(PhoneTest, AVisitorFindsPostcardPotAndPrintOnThePageAndNoOtherVisitor) {
  const std::string at = "/k/" + token(), page = get(at);
  EXPECT_THAT(page, StartsWith("HTTP/1.1 200"));
  for (const char* file : {"/postcard.jpg", "/pot.glb", "/pot.stl", "/delete"})
    EXPECT_THAT(page, HasSubstr(at + file));
  for (const char* told :
       {"Cache-Control: no-store", "noindex", "default-src 'none'", "no-referrer"})
    EXPECT_THAT(page, HasSubstr(told));
  EXPECT_THAT(page, Not(HasSubstr("2026-05-04"))) << "nothing says when it was made";
  EXPECT_EQ(test::body_of(get(at + "/postcard.jpg")), std::string("postcard.jpg of ") + kVisit);
  EXPECT_EQ(test::body_of(get(at + "/pot.glb")), std::string("pot.glb of ") + kVisit);
  const std::string stl = get(at + "/pot.stl");
  EXPECT_EQ(test::body_of(stl), std::string("pot.stl of ") + kVisit);
  EXPECT_THAT(stl, HasSubstr("attachment; filename=\"pot.stl\""));
  EXPECT_EQ(test::body_of(get("/page.js")), k_page_js);
  EXPECT_EQ(test::body_of(get("/page.css")), k_page_css);
  EXPECT_EQ(test::body_of(get("/page.svg")), k_page_svg);
}

TEST_F(PhoneTest, ThePictureThatTurnsIsOfferedFromWhenItIsThere) {
  const std::string at = "/k/" + token();
  EXPECT_THAT(get(at), Not(HasSubstr("turning.gif")));
  EXPECT_THAT(get(at + "/turning.gif"), StartsWith("HTTP/1.1 404"));
  std::ofstream(keepsakes_ / kVisit / "turning.gif") << "it turns";
  EXPECT_THAT(get(at), HasSubstr("download href=\"" + at + "/turning.gif\""));
  const std::string gif = get(at + "/turning.gif");
  EXPECT_THAT(gif, HasSubstr("Content-Type: image/gif"));
  EXPECT_EQ(test::body_of(gif), "it turns");
  EXPECT_THAT(get(at + "/delete", "POST"), StartsWith("HTTP/1.1 200"));
  EXPECT_FALSE(fs::exists(keepsakes_ / kVisit));
}

TEST_F(PhoneTest, TheRolloutIsOfferedWhereThereIsOne) {
  const std::string at = "/k/" + token();
  EXPECT_THAT(get(at), Not(HasSubstr("rollout.jpg")));
  EXPECT_THAT(get(at + "/rollout.jpg"), StartsWith("HTTP/1.1 404"));
  std::ofstream(keepsakes_ / kVisit / "rollout.jpg") << "unrolled";
  EXPECT_THAT(get(at), HasSubstr("download href=\"" + at + "/rollout.jpg\""));
  EXPECT_THAT(get(at), Not(HasSubstr("turning.gif")));
  const std::string picture = get(at + "/rollout.jpg");
  EXPECT_THAT(picture, HasSubstr("Content-Type: image/jpeg"));
  EXPECT_EQ(test::body_of(picture), "unrolled");
  EXPECT_THAT(get(at + "/delete", "POST"), StartsWith("HTTP/1.1 200"));
  EXPECT_FALSE(fs::exists(keepsakes_ / kVisit));
}

TEST_F(PhoneTest, TheDrawingIsOfferedWhereThereIsOne) {
  const std::string at = "/k/" + token();
  EXPECT_THAT(get(at), Not(HasSubstr("sheet.jpg")));
  EXPECT_THAT(get(at + "/sheet.jpg"), StartsWith("HTTP/1.1 404"));
  std::ofstream(keepsakes_ / kVisit / "sheet.jpg") << "drawn";
  EXPECT_THAT(get(at), HasSubstr("download href=\"" + at + "/sheet.jpg\""));
  const std::string picture = get(at + "/sheet.jpg");
  EXPECT_THAT(picture, HasSubstr("Content-Type: image/jpeg"));
  EXPECT_EQ(test::body_of(picture), "drawn");
  // What the STL is made of is nobody's.
  std::ofstream(keepsakes_ / kVisit / "relief.onggi") << "fine";
  EXPECT_THAT(get(at + "/relief.onggi"), StartsWith("HTTP/1.1 404"));
  EXPECT_THAT(get(at + "/delete", "POST"), StartsWith("HTTP/1.1 200"));
  EXPECT_FALSE(fs::exists(keepsakes_ / kVisit));
}

TEST_F(PhoneTest, WhoeverHasNoPassIsToldTheSameWhateverIsAsked) {
  const std::string good = token(), expired = token(1), deleted = token();
  now_ = kNow + 2 * kHour;
  const auto other = passes_.give("2026-05-04_150000_meiping", now_, 24);
  ASSERT_TRUE(other);
  EXPECT_THAT(get("/k/" + other->token + "/delete", "POST"), StartsWith("HTTP/1.1 200"));
  std::string near = good;
  near.back() = near.back() == 'a' ? 'b' : 'a';
  const std::string nothing = get("/");
  EXPECT_THAT(nothing, StartsWith("HTTP/1.1 404"));
  EXPECT_THAT(test::body_of(nothing), HasSubstr("nothing here"));
  for (const std::string& target :
       {"/k/" + near, "/k/" + expired, "/k/" + expired + "/pot.glb", "/k/" + other->token,
        std::string("/k/"), std::string("/k"), "/k/" + good.substr(1), "/k/" + good + "x",
        "/k/" + good + "/", "/k/" + good + "/visit.onggi", "/k/" + good + "/postcard.png",
        "/k/" + good + "/../2026-05-04_150000_meiping/pot.glb", "/k/" + good + "/%2e%2e/x",
        std::string("/k/../") + kVisit + "/pot.glb", std::string("/phone/") + good,
        std::string("/favicon.ico"), "/k/" + std::string(5000, 'a')})
    EXPECT_EQ(get(target), nothing) << target;
  EXPECT_EQ(get("/k/" + near + "/delete", "POST"), nothing);
  EXPECT_EQ(get("/k/" + good + "/delete", "GET"), nothing)
      << "a link that is looked at deletes nothing";
  EXPECT_EQ(get("/k/" + good, "PUT"), nothing);
  EXPECT_THAT(get("/k/" + good), StartsWith("HTTP/1.1 200"));
}

TEST_F(PhoneTest, DeletingRemovesEveryCopyAndEveryWayToIt) {
  const std::string one = token(), two = token();
  EXPECT_THAT(get("/k/" + one + "/delete", "POST"), StartsWith("HTTP/1.1 200"));
  std::string all;
  for (const auto& entry : fs::recursive_directory_iterator(folder_.path()))
    all += entry.path().string() + '\n';
  EXPECT_THAT(all, Not(HasSubstr("moon_jar")));
  EXPECT_THAT(all, Not(HasSubstr(one)));
  EXPECT_THAT(all, Not(HasSubstr(two)));
  EXPECT_THAT(all, HasSubstr("2026-05-04_150000_meiping/pot.glb")) << "and of nobody else";
  EXPECT_THAT(get("/k/" + two), StartsWith("HTTP/1.1 404"));
}

TEST_F(PhoneTest, APageIsThereForItsHoursAndAClockThatJumpsMakesItNoOlder) {
  const std::string first = token(24), at = "/k/" + first;
  ASSERT_TRUE(passes_.give(kVisit, kNow + 12 * kHour, 24));
  answers_.look_after();
  answers_.end();
  now_ = kNow + 24 * kHour - 1;
  EXPECT_THAT(get(at), StartsWith("HTTP/1.1 200"));
  now_ = kNow - 23 * kHour;
  EXPECT_THAT(get(at), StartsWith("HTTP/1.1 200")) << "summer time, or a clock that was set";
  now_ = kNow - 25 * kHour;
  EXPECT_THAT(get(at), StartsWith("HTTP/1.1 404")) << "years back it would be good for years";
  now_ = kNow + 24 * kHour;
  EXPECT_THAT(get(at), StartsWith("HTTP/1.1 404"));
  EXPECT_FALSE(passes_.served(std::time(nullptr)));
  answers_.look_after();
  EXPECT_TRUE(passes_.served(std::time(nullptr)));
  EXPECT_FALSE(passes_.served(std::time(nullptr) + souvenir::Passes::kSilent));
  answers_.end();
  EXPECT_FALSE(passes_.served(std::time(nullptr)));
  EXPECT_FALSE(fs::exists(keepsakes_ / "phone" / first));
  EXPECT_TRUE(fs::exists(keepsakes_ / kVisit / "pot.glb")) << "the museum's copy has its own days";
}

TEST_F(PhoneTest, APhoneThatSaysNothingOrNonsenseKeepsNobodyWaiting) {
  std::vector<test::PhoneConnection> silent;
  for (int n = 0; n < 20; ++n) silent.emplace_back(server_->port());
  EXPECT_EQ(hear("\r\n\r\nNONSENSE\r\n\r\n"), "");
  EXPECT_THAT(hear("POST / HTTP/1.1\r\nContent-Length: 9999999\r\n\r\n"),
              AllOf(StartsWith("HTTP/1.1 413"), HasSubstr("longer than 1024 bytes")));
  EXPECT_THAT(get("/k/" + token()), StartsWith("HTTP/1.1 200"));
}

TEST_F(PhoneTest, AHeadThatIsTooLongIsToldSoInALine) {
  for (const std::string& head : {"GET / HTTP/1.1\r\nX: " + std::string(9'000, 'x') + "\r\n\r\n",
                                  "GET / HTTP/1.1\r\nX: " + std::string(20'000, 'x') + "\r\n\r\n",
                                  "GET /" + std::string(20'000, 'x') + " HTTP/1.1\r\n\r\n"}) {
    const std::string heard = hear(head);
    EXPECT_THAT(heard, StartsWith("HTTP/1.1 431 Request Header Fields Too Large\r\n"));
    EXPECT_THAT(heard, HasSubstr("longer than 8192 bytes"));
    EXPECT_THAT(heard, HasSubstr("Cache-Control: no-store")) << "as every answer";
  }
}

// The server has one thread: what it hears out, all others wait for.
TEST_F(PhoneTest, APhoneThatGoesOnTalkingAfterItsAnswerIsNotHeardOut) {
  const std::string words = test::request("/page.css") + std::string(64'000'000, 'x');
  std::atomic<int> heard_out = 0;
  std::vector<std::thread> phones;
  for (int n = 0; n < 8; ++n)
    phones.emplace_back([&] {
      test::PhoneConnection phone(server_->port());
      heard_out += phone.say(words) ? 1 : 0;
    });
  for (std::thread& phone : phones) phone.join();
  EXPECT_EQ(heard_out, 0);
  EXPECT_THAT(get("/k/" + token()), StartsWith("HTTP/1.1 200"));
}

TEST(Listening, AnAddressHasItsPortBehindItAndOneOfTheSixthKindMayStandInBrackets) {
  const std::pair<const char*, const char*> wanted[] = {
      {"127.0.0.1:8080", "127.0.0.1"},         {"[::1]:8080", "::1"}, {"::1:8080", "::1"},
      {"[fe80::1%eth0]:8080", "fe80::1%eth0"}, {":8080", ""},         {"[::]:8080", "::"}};
  for (const auto& [text, address] : wanted) {
    const auto found = web::listening(text);
    ASSERT_TRUE(found) << text;
    EXPECT_EQ(found->address, address);
    EXPECT_EQ(found->port, 8080);
  }
  for (const char* text : {"", "8080", "127.0.0.1", "127.0.0.1:", "127.0.0.1:80a", "[::1]",
                           "127.0.0.1:65536", "127.0.0.1:-1", "127.0.0.1: 80"})
    EXPECT_FALSE(web::listening(text)) << text;
}

TEST_F(PhoneTest, AHundredPassesAreAllDifferentAndUseEveryLetterAlike) {
  std::set<std::string> tokens;
  std::array<int, 128> letters{};
  for (int n = 0; n < 100; ++n) {
    const auto pass = souvenir::Passes(folder_.path() / "many").give(kVisit, kNow, 24);
    ASSERT_TRUE(pass);
    EXPECT_EQ(pass->token.size(), souvenir::Passes::kTokenLetters);
    tokens.insert(pass->token);
    for (const char c : pass->token.substr(0, 25)) ++letters[static_cast<std::size_t>(c)];
  }
  EXPECT_EQ(tokens.size(), 100u);
  int used = 0;
  for (const int count : letters) {
    if (count == 0) continue;
    ++used;
    EXPECT_NEAR(count, 2500 / 32, 53) << "six deviations of 8.7";
  }
  EXPECT_EQ(used, 32);
  EXPECT_FALSE(passes_.give("../../etc", kNow, 24));
  EXPECT_FALSE(passes_.give("2026-05-04_141503_x/..", kNow, 24));
}

TEST_F(PhoneTest, ThePageSpeaksAsTheVisitDidAndThePhonesOwnLanguageStandsOnTop) {
  EXPECT_TRUE(remarks_.empty()) << to_text(remarks_.front());
  const std::string at = "/k/" + token(24, "ar");
  const std::string page = test::body_of(get(at, "GET", "de-DE,de;q=0.9"));
  EXPECT_THAT(page, HasSubstr("<html lang=\"ar\" dir=\"rtl\">"));
  EXPECT_THAT(page, HasSubstr("<p class=\"own\"><a lang=\"de\""));
  EXPECT_THAT(test::body_of(get(at, "GET", "ar")), Not(HasSubstr("class=\"own\"")));
  for (const auto& file : fs::directory_iterator("content/languages")) {
    const std::string code = file.path().stem(), chosen = at + "?lang=" + code;
    EXPECT_EQ(page.find("href=\"" + chosen + "\"") != std::string::npos, code != "ar") << code;
    EXPECT_THAT(get(chosen, "GET", "ko"), HasSubstr("<html lang=\"" + code + "\""));
  }
  EXPECT_THAT(get(at + "?lang=nn", "GET", "ko"), HasSubstr("<html lang=\"ar\""));
  EXPECT_THAT(get(at + "?a=b&lang=fr"), HasSubstr("<html lang=\"fr\""));
  EXPECT_THAT(get("/k/" + token(24, ""), "GET", "ko"), HasSubstr("<html lang=\"ar\""))
      << "another pass to the same keepsake speaks as the first";
  EXPECT_THAT(get(at + "/delete?lang=fr", "POST", "ko"), HasSubstr("<html lang=\"fr\""));
  EXPECT_THAT(get(at, "GET", "ko"), HasSubstr("<html lang=\"ko\"")) << "nothing is known now";
}

TEST_F(PhoneTest, AKeepsakeIsCountedAsFetchedOnceWhoeverOpensItHoweverOften) {
  const std::string one = token(), two = token();
  EXPECT_TRUE(souvenir::fetch_notes(passes_.fetched(), 9).empty());
  get("/k/" + one + "/pot.glb");
  get("/k/" + one.substr(1));
  EXPECT_TRUE(souvenir::fetch_notes(passes_.fetched(), 9).empty()) << "the page was not opened";
  for (const std::string& each : {one, two, one}) get("/k/" + each);
  const auto notes = souvenir::fetch_notes(passes_.fetched(), 9);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0].day, files::local_time(kNow, files::kDay));
  EXPECT_NE(notes[0].id, one) << "it leads nowhere";
  EXPECT_NE(notes[0].id, two);
  get("/k/" + one + "/delete", "POST");
  EXPECT_EQ(souvenir::fetch_notes(passes_.fetched(), 9), notes) << "it was fetched all the same";
}

TEST_F(PhoneTest, AKeepsakeThatCannotBeDeletedIsNotCalledDeletedAndCanBeAskedForAgain) {
  const std::string at = "/k/" + token();
  const fs::path in_the_way = keepsakes_ / (std::string(kVisit) + ".partial");
  std::ofstream(in_the_way) << "no folder";
  EXPECT_THAT(get(at + "/delete", "POST"), StartsWith("HTTP/1.1 500"));
  EXPECT_THAT(get(at), StartsWith("HTTP/1.1 200"));
  fs::remove(in_the_way);
  // A power cut came between, or the disk refused in the middle: some of it is still there.
  fs::rename(keepsakes_ / kVisit, in_the_way);
  EXPECT_THAT(get(at), StartsWith("HTTP/1.1 404"));
  EXPECT_THAT(get(at + "/pot.glb"), StartsWith("HTTP/1.1 404"));
  EXPECT_THAT(get(at + "/delete", "POST"), StartsWith("HTTP/1.1 200"));
  EXPECT_FALSE(fs::exists(in_the_way));
  EXPECT_THAT(get(at + "/delete", "POST"), StartsWith("HTTP/1.1 404"));
}

TEST_F(PhoneTest, APhoneThatAsksWhetherItsNetworkIsGoodIsToldSoToTheByte) {
  const std::string success =
      "<HTML><HEAD><TITLE>Success</TITLE></HEAD><BODY>Success</BODY></HTML>";
  const std::vector<std::pair<std::string, std::string>> wanted = {
      {"/hotspot-detect.html", success},
      {"/library/test/success.html", success},
      {"/connecttest.txt", "Microsoft Connect Test"},
      {"/ncsi.txt", "Microsoft NCSI"},
      {"/success.txt", "success\n"},
      {"/success.txt?ipv4", "success\n"},
      {"/nm", "NetworkManager is online\n"},
      {"/check_network_status.txt", "NetworkManager is online\n"},
      {"/canonical.html",
       "<meta http-equiv=\"refresh\" "
       "content=\"0;url=https://support.mozilla.org/kb/captive-portal\"/>"}};
  for (const auto& [target, bytes] : wanted) {
    const std::string answer = get(target);
    EXPECT_THAT(answer, StartsWith("HTTP/1.1 200")) << target;
    EXPECT_EQ(test::body_of(answer), bytes) << target;
    EXPECT_THAT(answer, HasSubstr("Content-Length: " + std::to_string(bytes.size()) + "\r\n"));
  }
  for (const char* target : {"/generate_204", "/gen_204"}) {
    const std::string answer = get(target);
    EXPECT_THAT(answer, StartsWith("HTTP/1.1 204")) << target;
    EXPECT_EQ(test::body_of(answer), "") << target;
    EXPECT_THAT(answer, Not(HasSubstr("Content-Length"))) << "RFC 9110, 8.6";
  }
  EXPECT_EQ(get("/generate_204", "POST"), get("/"));
}

}  // namespace
}  // namespace onggi::phone::answers_test
