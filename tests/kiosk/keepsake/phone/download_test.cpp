#include <gmock/gmock.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "engine/profile/mesh.h"
#include "kiosk/collection/content/glb.h"
#include "kiosk/ground/files/monotonic.h"
#include "kiosk/ground/web/server.h"
#include "kiosk/keepsake/souvenir/printed_pot.h"
#include "tests/engine/profile/shapes.h"
#include "tests/kiosk/keepsake/phone/phone_fixture.h"
#include "tests/kiosk/keepsake/phone/slow_way.h"
#include "tests/kiosk/keepsake/souvenir/relief_file_on_disk.h"

// Large files, slow phones, ways that break, and who is closed for whom. How long anything takes is
// tests/bench/phone_day.py.

namespace onggi::phone::download_test {
namespace {

using namespace std::chrono_literals;
using test::body_of;
using test::head_of;
using test::kVisit;
using test::PhoneConnection;
using test::request;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class Download : public test::PhoneTest {
 protected:
  /// A print of `size` bytes, and its address.
  std::string print_of(std::size_t size) {
    std::mt19937 random(7);
    print_.resize(size);
    for (char& byte : print_) byte = static_cast<char>(random());
    std::ofstream(keepsakes_ / kVisit / "pot.stl", std::ios::binary) << print_;
    return "/k/" + token() + "/pot.stl";
  }
  std::string ask(const std::string& target, const std::string& more, const char* how = "GET") {
    return hear(request(target, how, more));
  }
  static std::string tag_of(const std::string& answer) {
    const auto at = answer.find("ETag: ") + 6;
    return answer.substr(at, answer.find("\r\n", at) - at);
  }
  std::string print_;
};

// A kept pot has no STL: it is made of the model while it is sent.
TEST_F(Download, ThePrintIsMadeOfTheModelWholeOrASpanOfItAndIsTheDesksOwn) {
  const std::filesystem::path visit = keepsakes_ / kVisit;
  std::filesystem::remove(visit / "pot.stl");
  const std::string at = "/k/" + token();
  EXPECT_THAT(get(at + "/pot.stl"), StartsWith("HTTP/1.1 404")) << "its model is none";
  TriangleMesh pot = revolve(section_of(shapes::jar()), 96);
  const auto glb = content::write_glb(pot, "My pot", "", {{0, {}}, {500, {}}}, {}, 2);
  std::ofstream(visit / "pot.glb", std::ios::binary)
      .write(reinterpret_cast<const char*>(glb.data()), static_cast<std::streamsize>(glb.size()));
  const auto stl = souvenir::stl_of_visit(visit);
  ASSERT_TRUE(stl);
  const std::string desk(reinterpret_cast<const char*>(stl->bytes.data()), stl->bytes.size());
  ASSERT_EQ(desk.size(), 84 + 50 * pot.triangles.size());
  ASSERT_GT(desk.size(), 300'000u) << "many pieces";
  const std::string whole = get(at + "/pot.stl");
  EXPECT_THAT(whole, StartsWith("HTTP/1.1 200"));
  EXPECT_THAT(whole, HasSubstr("attachment; filename=\"pot.stl\""));
  EXPECT_TRUE(body_of(whole) == desk);
  const std::string tag = tag_of(whole);
  EXPECT_NE(tag, tag_of(get(at + "/pot.glb")));
  const std::string part = ask(at + "/pot.stl", "Range: bytes=70001-\r\nIf-Range: " + tag + "\r\n");
  EXPECT_THAT(part, StartsWith("HTTP/1.1 206"));
  EXPECT_TRUE(body_of(part) == desk.substr(70'001));
  EXPECT_EQ(body_of(ask(at + "/pot.stl", "", "HEAD")), "");
  std::filesystem::resize_file(visit / "pot.glb", glb.size() - 4096);
  EXPECT_THAT(get(at + "/pot.stl"), StartsWith("HTTP/1.1 404"));
}

TEST_F(Download, ADamagedReliefLeavesThePlainPotAndIsToldToTheStaffOnce) {
  const std::filesystem::path visit = keepsakes_ / kVisit;
  std::filesystem::remove(visit / "pot.stl");
  const TriangleMesh pot = revolve(section_of(shapes::jar()), 96);
  const auto glb = content::write_glb(pot, "My pot", "", {{0, {}}}, {}, 2);
  auto relief = souvenir::test::rough_relief(souvenir::mark_of_model(glb, glb.size()));
  const auto put = [&](const char* name, const std::vector<std::byte>& bytes) {
    std::ofstream(visit / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  };
  put("pot.glb", glb);
  put("relief.onggi", relief);
  const std::string at = "/k/" + token() + "/pot.stl", cut = body_of(get(at));
  EXPECT_NE(cut.size(), 84 + 50 * pot.triangles.size());
  EXPECT_TRUE(told_.empty());
  relief[relief.size() / 2] ^= std::byte{0x10};
  put("relief.onggi", relief);
  const std::string plain = body_of(get(at));
  EXPECT_EQ(plain.size(), 84 + 50 * pot.triangles.size());
  EXPECT_EQ(body_of(ask(at, "Range: bytes=40000-\r\n")), plain.substr(40'000));
  ASSERT_EQ(told_.size(), 1u);
  EXPECT_EQ(told_.front().where, (visit / "relief.onggi").string());
}

TEST_F(Download, OneSpanOfAFileIsGivenAndTheRestOfItFromWhereAPhoneStopped) {
  const std::string at = print_of(10'000), whole = get(at);
  EXPECT_THAT(whole, StartsWith("HTTP/1.1 200"));
  EXPECT_THAT(whole, HasSubstr("Accept-Ranges: bytes\r\n"));
  EXPECT_EQ(body_of(whole), print_);
  const std::string part = ask(at, "Range: bytes=2000-2999\r\n");
  EXPECT_THAT(part, StartsWith("HTTP/1.1 206"));
  EXPECT_THAT(part, HasSubstr("Content-Range: bytes 2000-2999/10000\r\n"));
  EXPECT_THAT(part, HasSubstr("Content-Length: 1000\r\n"));
  EXPECT_THAT(part, HasSubstr("attachment; filename=\"pot.stl\""));
  for (const char* told : {"no-store", "noindex", "nosniff", "no-referrer", "default-src 'none'"})
    EXPECT_THAT(part, HasSubstr(told));
  EXPECT_EQ(body_of(part), print_.substr(2000, 1000));
  EXPECT_EQ(body_of(ask(at, "Range: bytes=9999-\r\n")), print_.substr(9999));
  EXPECT_EQ(body_of(ask(at, "Range: bytes=-3\r\n")), print_.substr(9997));
  EXPECT_EQ(body_of(ask(at, "Range: bytes=0-1,5-6\r\n")), print_) << "several spans: all of it";
  const std::string beyond = ask(at, "Range: bytes=10000-\r\n");
  EXPECT_THAT(beyond, StartsWith("HTTP/1.1 416"));
  EXPECT_THAT(beyond, HasSubstr("Content-Range: bytes */10000\r\n"));
  EXPECT_EQ(body_of(beyond), "");
}

TEST_F(Download, APhoneGoesOnInTheSameFileAndInNoOther) {
  const std::string at = print_of(10'000), tag = tag_of(get(at));
  EXPECT_EQ(tag.size(), 18u);
  EXPECT_EQ(tag_of(get(at)), tag);
  const std::string on = "Range: bytes=5000-\r\nIf-Range: ";
  EXPECT_EQ(body_of(ask(at, on + tag + "\r\n")), print_.substr(5000));
  EXPECT_EQ(body_of(ask(at, on + "\"another\"\r\n")), print_);
  print_of(10'001);
  EXPECT_NE(tag_of(get(at)), tag);
  EXPECT_EQ(body_of(ask(at, on + tag + "\r\n")), print_) << "it is another file now";
}

TEST_F(Download, ASpanChangesNothingForWhoeverHasNoPassOrAsksForAPage) {
  const std::string nothing = get("/"), span = "Range: bytes=0-1\r\n";
  print_of(100);
  for (const std::string& target : {std::string("/k/") + std::string(26, 'a') + "/pot.stl",
                                    std::string("/pot.stl"), std::string("/")})
    EXPECT_EQ(ask(target, span), nothing) << target;
  const std::string at = "/k/" + token();
  EXPECT_EQ(ask(at, span), get(at));
  EXPECT_THAT(get(at), Not(HasSubstr("ETag")));
  EXPECT_EQ(ask("/page.js", span), get("/page.js"));
}

TEST_F(Download, AHeadIsThatOfTheWholeAnswerWithoutItsContentAndOpensNoPage) {
  const std::string file = print_of(10'000), page = "/k/" + token();
  const std::string wrong = "/k/" + std::string(26, 'a'), probe = "/generate_204";
  for (const std::string& target : {file, page, wrong, std::string("/page.js"), probe}) {
    const std::string head = ask(target, "", "HEAD");
    EXPECT_EQ(body_of(head), "") << target;
    if (target == page) {
      EXPECT_FALSE(std::filesystem::exists(passes_.fetched())) << "a look is no opening";
    }
    EXPECT_EQ(head_of(head), head_of(get(target))) << target;
  }
  EXPECT_THAT(ask(page + "/delete", "", "HEAD"), StartsWith("HTTP/1.1 404"));
}

TEST_F(Download, OverAWayThatBreaksAgainAndAgainAFileIsWholeToTheByte) {
  const std::string at = print_of(3'000'000), tag = tag_of(get(at));
  for (const unsigned seed : {1u, 2u, 3u}) {
    test::SlowWay way(server_->port(), {.breaks_after = 500'000}, seed);
    std::string has;
    int tries = 0;
    while (has.size() < print_.size() && tries < 1000) {
      ++tries;
      const std::string span = "Range: bytes=" + std::to_string(has.size()) + "-\r\n";
      const std::string heard =
          test::hear(way.port(), request(at, "GET", span + "If-Range: " + tag + "\r\n"));
      if (heard.find("\r\n\r\n") != std::string::npos) has += body_of(heard);
    }
    EXPECT_TRUE(has == print_) << has.size() << " bytes, seed " << seed;
    EXPECT_GT(tries, 3);
    EXPECT_LT(way.carried(), print_.size() + 1000u * static_cast<unsigned>(tries))
        << "nothing is sent twice";
  }
}

TEST_F(Download, ASlowPhoneThatTakesLongerThanThePatienceIsServedWhileItTakesAnything) {
  serve({.patience = {.asking = 5s, .progress = 1500ms}});
  const std::string at = print_of(4'000'000);
  PhoneConnection phone(server_->port(), "127.0.0.1", 4096);
  ASSERT_TRUE(phone.say(request(at)));
  std::string heard;
  // Above twice the patience in all, with a pause of a thirtieth of it at most.
  const auto begun = std::chrono::steady_clock::now();
  for (std::string more; !(more = phone.some(40'000)).empty(); heard += more)
    if (std::chrono::steady_clock::now() - begun < 3500ms) std::this_thread::sleep_for(50ms);
  EXPECT_TRUE(body_of(heard) == print_) << heard.size();
}

TEST_F(Download, APhoneThatTakesNothingMoreIsClosed) {
  serve({.patience = {.asking = 5s, .progress = 200ms}});
  const std::string at = print_of(4'000'000);
  PhoneConnection phone(server_->port(), "127.0.0.1", 4096);
  ASSERT_TRUE(phone.say(request(at)));
  while (get("/generate_204").empty()) {
  }
  std::this_thread::sleep_for(1s);
  EXPECT_LT(phone.to_the_end().size(), print_.size());
}

TEST_F(Download, ADownloadOfAKeepsakeThatIsDeletedMayEndAndNotGoOnForGood) {
  const std::string at = print_of(4'000'000), folder = at.substr(0, at.rfind('/'));
  PhoneConnection quick(server_->port(), "127.0.0.1", 4096);
  ASSERT_TRUE(quick.say(request(at)));
  std::string heard = quick.some(1000);
  EXPECT_THAT(get(folder + "/delete", "POST"), StartsWith("HTTP/1.1 200"));
  heard += quick.to_the_end();
  EXPECT_TRUE(body_of(heard) == print_) << "the same bytes, never a part of them";
  // One that takes a little again and again is closed all the same.
  serve({.patience = {.asking = 5s, .progress = 300ms}});
  std::filesystem::create_directories(keepsakes_ / kVisit);
  const std::string again = print_of(4'000'000);
  PhoneConnection slow(server_->port(), "127.0.0.1", 4096);
  ASSERT_TRUE(slow.say(request(again)));
  std::size_t got = slow.some(1000).size();
  EXPECT_THAT(get(again.substr(0, again.rfind('/')) + "/delete", "POST"),
              StartsWith("HTTP/1.1 200"));
  for (std::string more; !(more = slow.some(5'000)).empty(); got += more.size())
    std::this_thread::sleep_for(5ms);
  EXPECT_LT(got, print_.size());
}

TEST_F(Download, FiveHundredAtOnceHoldNoneOfTheFileInMemory) {
  const std::string at = print_of(1000);
  const std::size_t large = 14'000'000;
  std::filesystem::resize_file(keepsakes_ / kVisit / "pot.stl", large);
  const long before = files::resident_bytes();
  std::vector<PhoneConnection> phones;
  for (int n = 0; n < 500; ++n) {
    phones.emplace_back(server_->port(), "127.0.0.1", 4096);
    ASSERT_TRUE(phones.back().say(request(at)));
  }
  // Each has its answer begun.
  for (PhoneConnection& phone : phones) EXPECT_THAT(phone.some(12), StartsWith("HTTP/1.1 200"));
  EXPECT_LT(files::resident_bytes() - before, 64'000'000) << "7,000 MB of files are on their way";
}

TEST_F(Download, IdleConnectionsOfOneAddressShutOutNobodyAndTheOldestGoesFirst) {
  serve({.connections = 16});
  std::vector<PhoneConnection> idle;
  for (int n = 0; n < 8; ++n) idle.emplace_back(server_->port(), "127.0.0.2");
  // Who asks on the same thread knows that those before were taken in.
  EXPECT_THAT(get("/generate_204"), StartsWith("HTTP/1.1 204"));
  for (const PhoneConnection& one : idle) EXPECT_FALSE(one.closed(0));
  for (int more = 0; more < 4; ++more) {
    idle.emplace_back(server_->port(), "127.0.0.2");
    EXPECT_TRUE(idle[static_cast<std::size_t>(more)].closed(5000)) << "the oldest";
    EXPECT_FALSE(idle[static_cast<std::size_t>(more) + 1].closed(0)) << "and it alone";
    EXPECT_THAT(get("/k/" + token()), StartsWith("HTTP/1.1 200")) << "of another address";
  }
  // The idle ones' own address is served too.
  PhoneConnection same(server_->port(), "127.0.0.2");
  ASSERT_TRUE(same.say(request("/page.css")));
  EXPECT_THAT(same.to_the_end(), StartsWith("HTTP/1.1 200"));
}

TEST_F(Download, WhoeverSaysNothingForSecondsIsClosedAndWhoeverSaysALetterNowAndThenToo) {
  serve({.patience = {.asking = 300ms, .progress = 10s}});
  PhoneConnection silent(server_->port()), slow(server_->port());
  for (int n = 0; n < 200 && slow.say("G"); ++n) std::this_thread::sleep_for(10ms);
  EXPECT_TRUE(silent.closed(5000));
  EXPECT_TRUE(slow.closed(5000));
}

TEST_F(Download, AFolderThatIsALinkIsNotFollowedNorIsThatOfThePasses) {
  namespace fs = std::filesystem;
  const std::string at = print_of(100), page = at.substr(0, at.rfind('/'));
  fs::rename(keepsakes_ / kVisit, folder_.path() / "elsewhere");
  fs::create_directory_symlink(folder_.path() / "elsewhere", keepsakes_ / kVisit);
  const std::string nothing = get("/");
  EXPECT_EQ(get(page), nothing);
  EXPECT_EQ(get(at), nothing);
  EXPECT_EQ(get(page + "/delete", "POST"), nothing);
  EXPECT_TRUE(fs::exists(folder_.path() / "elsewhere/pot.stl"));
  fs::remove(keepsakes_ / kVisit);
  fs::rename(folder_.path() / "elsewhere", keepsakes_ / kVisit);
  EXPECT_EQ(body_of(get(at)), print_);
  fs::rename(keepsakes_ / "phone", folder_.path() / "passes");
  fs::create_directory_symlink(folder_.path() / "passes", keepsakes_ / "phone");
  EXPECT_EQ(get(at), nothing);
}

}  // namespace
}  // namespace onggi::phone::download_test
