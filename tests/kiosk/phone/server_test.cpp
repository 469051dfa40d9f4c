#include "kiosk/phone/server.h"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <set>
#include <thread>
#include <vector>

#include "kiosk/phone/visitors_page.h"
#include "tests/kiosk/files/disk.h"

namespace onggi::phone {
namespace {

namespace fs = std::filesystem;
using files::test::ScratchFolder;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

constexpr std::int64_t kNow = 1'780'000'000, kHour = 3600;
constexpr const char* kVisit = "2026-05-04_141503_moon_jar";

/// A folder of keepsakes with two visits in it, and phones that ask over real sockets.
class PhoneTest : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const char* visit : {kVisit, "2026-05-04_150000_meiping"}) {
      fs::create_directories(keepsakes_ / visit);
      for (const char* file : {"postcard.png", "postcard.jpg", "pot.glb", "pot.stl", "visit.onggi"})
        std::ofstream(keepsakes_ / visit / file) << file << " of " << visit;
    }
    auto server = Server::listen("127.0.0.1", 0, answers_);
    ASSERT_TRUE(server) << to_text(server.error());
    server_ = std::move(*server);
    runs_ = std::thread([this] { server_->run([] {}); });
  }
  void TearDown() override {
    if (!server_) return;
    server_->stop();
    runs_.join();
  }
  std::string token(double hours = 24) {
    const auto pass = passes_.give(kVisit, now_, hours);
    EXPECT_TRUE(pass) << to_text(pass.error());
    return pass->token;
  }
  /// Says `words` to the server and hears it to the end.
  std::string hear(const std::string& words) const {
    const int phone = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(server_->port());
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    std::string heard;
    if (connect(phone, reinterpret_cast<sockaddr*>(&to), sizeof to) == 0 &&
        send(phone, words.data(), words.size(), MSG_NOSIGNAL) ==
            static_cast<ssize_t>(words.size())) {
      char some[4096];
      for (ssize_t n = 0; (n = recv(phone, some, sizeof some, 0)) > 0;)
        heard.append(some, static_cast<std::size_t>(n));
    }
    close(phone);
    return heard;
  }
  std::string get(const std::string& target, const std::string& method = "GET") const {
    return hear(method + " " + target + " HTTP/1.1\r\nHost: kiosk\r\n\r\n");
  }
  static std::string body(const std::string& answer) {
    const auto end = answer.find("\r\n\r\n");
    return end == std::string::npos ? "" : answer.substr(end + 4);
  }

  ScratchFolder folder_;
  fs::path keepsakes_ = folder_.path() / "kept";
  std::atomic<std::int64_t> now_{kNow};
  souvenir::Passes passes_{keepsakes_};
  Answers answers_{passes_, [this] { return now_.load(); }};
  std::unique_ptr<Server> server_;
  std::thread runs_;
};

TEST_F(PhoneTest, AVisitorFindsPostcardPotAndPrintOnThePageAndNoOtherVisitor) {
  const std::string at = "/k/" + token(), page = get(at);
  EXPECT_THAT(page, StartsWith("HTTP/1.1 200"));
  for (const char* file : {"/postcard.jpg", "/pot.glb", "/pot.stl", "/delete"})
    EXPECT_THAT(page, HasSubstr(at + file));
  for (const char* told :
       {"Cache-Control: no-store", "noindex", "default-src 'none'", "no-referrer"})
    EXPECT_THAT(page, HasSubstr(told));
  EXPECT_THAT(page, Not(HasSubstr("2026-05-04"))) << "nothing says when it was made";
  EXPECT_EQ(body(get(at + "/postcard.jpg")), std::string("postcard.jpg of ") + kVisit);
  EXPECT_EQ(body(get(at + "/pot.glb")), std::string("pot.glb of ") + kVisit);
  const std::string stl = get(at + "/pot.stl");
  EXPECT_EQ(body(stl), std::string("pot.stl of ") + kVisit);
  EXPECT_THAT(stl, HasSubstr("attachment; filename=\"pot.stl\""));
  EXPECT_EQ(body(get("/page.js")), k_page_js);
  EXPECT_EQ(body(get("/page.css")), k_page_css);
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
  EXPECT_THAT(body(nothing), HasSubstr("nothing here"));
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
  const std::string at = "/k/" + token(24);
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
  EXPECT_TRUE(fs::is_empty(keepsakes_ / "phone")) << "no pass, and nobody there";
  EXPECT_TRUE(fs::exists(keepsakes_ / kVisit / "pot.glb")) << "the museum's copy has its own days";
}

TEST_F(PhoneTest, APhoneThatSaysNothingOrNonsenseKeepsNobodyWaiting) {
  std::vector<int> silent;
  for (int n = 0; n < 20; ++n) {
    silent.push_back(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(server_->port());
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(connect(silent.back(), reinterpret_cast<sockaddr*>(&to), sizeof to), 0);
  }
  EXPECT_EQ(hear("\r\n\r\nNONSENSE\r\n\r\n"), "");
  EXPECT_EQ(hear("GET / HTTP/1.1\r\nX: " + std::string(20'000, 'x') + "\r\n\r\n"), "");
  EXPECT_EQ(hear("POST / HTTP/1.1\r\nContent-Length: 9999999\r\n\r\n"), "");
  EXPECT_THAT(get("/k/" + token()), StartsWith("HTTP/1.1 200"));
  for (const int phone : silent) close(phone);
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

TEST(Page, APhoneIsSpokenToInTheFirstOfItsLanguagesThatThereIs) {
  EXPECT_THAT(nothing_page("de-DE,ko;q=0.8,en;q=0.5"), HasSubstr("lang=\"ko\""));
  EXPECT_THAT(nothing_page("en-GB,ko"), HasSubstr("lang=\"en\""));
  EXPECT_THAT(nothing_page("fr"), HasSubstr("lang=\"en\""));
}

}  // namespace
}  // namespace onggi::phone
