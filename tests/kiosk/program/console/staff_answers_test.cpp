#include "kiosk/program/console/staff_answers.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/file.h>

#include <memory>
#include <vector>

#include "kiosk/ground/files/paths.h"
#include "kiosk/ground/files/wall_clock.h"
#include "kiosk/ground/secrets/digest.h"
#include "kiosk/keepsake/souvenir/open_passes.h"
#include "kiosk/keepsake/souvenir/pass.h"
#include "kiosk/keepsake/souvenir/staff_notice.h"
#include "kiosk/keepsake/store/visit_store.h"
#include "kiosk/program/watch/kiosk_state.h"
#include "tests/kiosk/ground/files/disk.h"
#include "tests/kiosk/program/console/staff_page.h"

namespace onggi::console::staff_answers_test {
namespace {

using namespace test;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

const std::vector<std::string> kRead{"/",
                                     "/api/state",
                                     "/api/files",
                                     "/api/figures",
                                     "/figures.svg",
                                     "/api/keepsakes",
                                     std::string("/keepsake/") + kJar + "/postcard.jpg",
                                     std::string("/print/") + kJar};
const std::vector<std::string> kChange{std::string("/api/keepsakes/") + kJar + "/pass",
                                       std::string("/api/keepsakes/") + kJar + "/delete"};

TEST_F(StaffPage, WhoHasNotComeInSeesAndChangesNothing) {
  cookie_ = "staff=guessed";
  for (const std::string& target : kRead) {
    const web::Answer answer = get(target);
    EXPECT_EQ(answer.status, 401) << target;
    EXPECT_FALSE(answer.file) << target;
    EXPECT_THAT(answer.body, Not(HasSubstr("museum"))) << target;
  }
  for (const std::string& target : kChange) EXPECT_EQ(post(target).status, 401) << target;
  EXPECT_TRUE(fs::exists(keepsakes_ / kJar));
  EXPECT_THAT(get("/").body, HasSubstr("onggi setup --code"));
}

TEST_F(StaffPage, AfterHalfAnHourWithoutARequestItIsShut) {
  now_ += Door::kIdle;
  EXPECT_EQ(get("/api/state").status, 401);
}

TEST_F(StaffPage, WhatThePageAsksByItselfDoesNotKeepTheSessionOpen) {
  for (int n = 0; n < 3; ++n) {
    now_ += Door::kIdle / 2;
    EXPECT_EQ(get("/api/state").status, 200) << "somebody is here";
  }
  now_ += Door::kIdle / 2;
  EXPECT_EQ(get("/api/state?alone=1").status, 200);
  now_ += Door::kIdle / 2;
  EXPECT_EQ(get("/api/state?alone=1").status, 401);
}

TEST_F(StaffPage, WhoOpensAnAddressByHandGetsAPageAndNoJson) {
  for (const char* target : {"/print/2026-05-28_141503_none", "/nowhere", "/desk"}) {
    EXPECT_THAT(get(target).body, HasSubstr("<!doctype html>")) << target;
    web::Ask stranger = asking(target);
    stranger.cookie = "";
    EXPECT_THAT(staff_->to(stranger).body, HasSubstr("Sign in")) << target;
  }
}

TEST_F(StaffPage, IsServedUnderItsOwnNamesAlone) {
  for (const char* host : {"evil.example:8090", "127.0.0.1", "127.0.0.1:8091", ""})
    for (const std::string& target : kRead) {
      web::Ask ask = asking(target);
      ask.host = host;
      EXPECT_EQ(staff_->to(ask).status, 421) << host << target;
    }
  web::Ask ask = asking("/api/state");
  ask.host = "localhost:8090";
  EXPECT_EQ(staff_->to(ask).status, 200);
}

TEST_F(StaffPage, AnotherPagesFormChangesNothing) {
  for (const std::string& target : kChange) {
    web::Ask elsewhere = posting(target), none = posting(target), form = posting(target);
    elsewhere.origin = "http://evil.example";
    none.origin = "";
    form.type = "application/x-www-form-urlencoded";
    EXPECT_EQ(staff_->to(elsewhere).status, 403);
    EXPECT_EQ(staff_->to(none).status, 403);
    EXPECT_EQ(staff_->to(form).status, 415);
    EXPECT_EQ(get(target).status, 404) << "reading changes nothing";
  }
  EXPECT_TRUE(fs::exists(keepsakes_ / kJar));
}

TEST_F(StaffPage, TheStateIsInWordsAndSentAnewOnlyWhenItIsAnother) {
  const web::Answer state = get("/api/state");
  EXPECT_EQ(state.status, 200);
  EXPECT_THAT(state.body, AllOf(HasSubstr("\"title\":\"Clay\""), HasSubstr("does not run"),
                                HasSubstr("are free for keepsakes")));
  web::Ask again = asking("/api/state");
  for (const auto& [name, value] : state.fields)
    if (name == "ETag") again.if_none_match = value;
  EXPECT_EQ(staff_->to(again).status, 304);
  exhibit("scene = \"scenes/none.toml\"");
  std::ofstream(site_ / "config/exhibit.toml", std::ios::app) << "quota_mb = 50\n";
  EXPECT_EQ(get("/api/state").status, 200) << "a slip in the file does not shut the page";
}

TEST_F(StaffPage, KeepsakesAreFoundByDayAndByAWordOfTheirName) {
  const auto listed = [this](const std::string& query) {
    return get("/api/keepsakes" + query).body;
  };
  EXPECT_THAT(listed(""), AllOf(HasSubstr(kJar), HasSubstr(kOlla), HasSubstr("moon jar")));
  EXPECT_THAT(listed("?day=2026-05-28"), AllOf(HasSubstr(kJar), Not(HasSubstr(kOlla))));
  EXPECT_THAT(listed("?name=heron"), AllOf(HasSubstr(kJar), Not(HasSubstr(kOlla))));
  EXPECT_THAT(listed("?name=Quiet+blue%20HERON"), HasSubstr(kJar));
  EXPECT_THAT(listed("?name=2026-05-27+10%3A15"), AllOf(HasSubstr(kOlla), Not(HasSubstr(kJar))));
  EXPECT_EQ(listed("?name=walrus"), "[]");
  EXPECT_THAT(listed("?name=Moon+jar"), AllOf(HasSubstr(kJar), Not(HasSubstr(kOlla))));
  EXPECT_THAT(listed("?name=14%3A15&day=2026-05-28"), HasSubstr(kJar));
  EXPECT_EQ(listed("?name=14%3A15&day=2026-05-27"), "[]");
  EXPECT_EQ(get("/api/keepsakes?day=2026-13-01").status, 409);
  fs::remove_all(keepsakes_);
  EXPECT_EQ(listed(""), "[]") << "before the first there is no folder";
}

TEST_F(StaffPage, PicturesAreThoseOfKeepsakesAndNothingElseOnTheDisk) {
  const web::Answer card = get(std::string("/keepsake/") + kJar + "/postcard.jpg");
  EXPECT_EQ(card.status, 200);
  EXPECT_EQ(card.type, "image/jpeg");
  ASSERT_TRUE(card.file);
  EXPECT_EQ(card.span.length, std::string("postcard.jpg of ").size() + std::string(kJar).size());
  std::ofstream(site_ / "secret.jpg") << "secret";
  fs::create_directory_symlink(site_.path(), keepsakes_ / "2026-05-26_101500_link");
  fs::create_symlink(site_ / "secret.jpg", keepsakes_ / kJar / "sheet.jpg");
  for (const std::string& bad :
       {std::string(kJar) + "/visit.onggi", std::string(kJar) + "/name.txt",
        std::string(kJar) + "/../" + kOlla + "/postcard.jpg", std::string("../secret.jpg"),
        std::string("../config/exhibit.toml"), std::string("2026-05-26_101500_link/secret.jpg"),
        std::string("2026-05-26_101500_link/postcard.jpg"), std::string(kJar) + "/sheet.jpg",
        std::string("%2e%2e/secret.jpg"), std::string("2026-05-28_141503_../postcard.jpg"),
        std::string("/postcard.jpg"), std::string(kJar) + "/"}) {
    const web::Answer answer = get("/keepsake/" + bad);
    EXPECT_EQ(answer.status, 404) << bad;
    EXPECT_FALSE(answer.file) << bad;
  }
}

TEST_F(StaffPage, APostcardIsPrintedByTheBrowserTheOneWithTheCodeFirst) {
  EXPECT_THAT(get(std::string("/print/") + kJar).body, HasSubstr("/postcard.jpg\""));
  std::ofstream(keepsakes_ / kJar / "print.jpg") << "with its code";
  EXPECT_THAT(get(std::string("/print/") + kJar).body, HasSubstr("/print.jpg\""));
  EXPECT_EQ(get("/print/2026-05-28_141503_none").status, 404);
}

TEST_F(StaffPage, APhoneGetsAPassOnlyWherePhonesHavePages) {
  const std::string target = std::string("/api/keepsakes/") + kJar + "/pass";
  const web::Answer none = post(target);
  EXPECT_EQ(none.status, 409);
  EXPECT_THAT(none.body, HasSubstr("[phone]"));
  std::ofstream(site_ / "config/exhibit.toml", std::ios::app)
      << "\n[phone]\naddress = \"http://192.168.4.1:8080\"\nhours = 2\n";
  const web::Answer unserved = post(target);
  EXPECT_EQ(unserved.status, 409) << "the code would lead nowhere";
  EXPECT_THAT(unserved.body, HasSubstr("onggi-phone"));
  now_ = files::wall_now();
  souvenir::OpenPasses(keepsakes_).serve();
  EXPECT_EQ(enter_by_code().status, 303);
  const web::Answer pass = post(target);
  EXPECT_EQ(pass.status, 200) << pass.body;
  EXPECT_THAT(pass.body,
              AllOf(HasSubstr("http://192.168.4.1:8080/k/"), HasSubstr("\"code\":[\"1")));
  const auto tokens = souvenir::tokens_of(keepsakes_);
  ASSERT_EQ(tokens.size(), 1u);
  const auto given = souvenir::read_pass(keepsakes_, tokens.front());
  ASSERT_TRUE(given && *given);
  EXPECT_EQ((*given)->visit, kJar);
  EXPECT_EQ((*given)->until - (*given)->from, 7200);
}

TEST_F(StaffPage, DeletingTakesEveryCopyAndEveryPassOfThatKeepsakeAlone) {
  const souvenir::Passes passes(keepsakes_);
  ASSERT_TRUE(passes.give(kJar, kNow, 24) && passes.give(kJar, kNow, 24) &&
              passes.give(kOlla, kNow, 24));
  EXPECT_EQ(post(std::string("/api/keepsakes/") + kJar + "/delete").status, 200);
  EXPECT_FALSE(fs::exists(keepsakes_ / kJar));
  EXPECT_TRUE(fs::exists(keepsakes_ / kOlla / "postcard.jpg"));
  const auto left = souvenir::tokens_of(keepsakes_);
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ((*souvenir::read_pass(keepsakes_, left.front()))->visit, kOlla);
  EXPECT_EQ(post(std::string("/api/keepsakes/") + kJar + "/delete").status, 404) << "it is gone";
  for (const char* bad : {"..", "phone", "2026-05-28_141503_moon_jar.partial"})
    EXPECT_EQ(post(std::string("/api/keepsakes/") + bad + "/delete").status, 404) << bad;
}

TEST_F(StaffPage, AFolderOfTheMuseumsOwnIsNeitherListedNorDeletedWhateverItIsCalled) {
  const fs::path own = keepsakes_ / "2026-01-04_000000_museum";
  fs::create_directories(own / "sub");
  std::ofstream(own / "important.doc") << "x";
  fs::create_directories(keepsakes_ / "2026-01-04_000000_<b>");
  std::ofstream(keepsakes_ / "2026-01-04_000000_<b>" / "postcard.jpg") << "x";
  EXPECT_THAT(get("/api/keepsakes").body, AllOf(Not(HasSubstr("museum\"")), Not(HasSubstr("<b>"))));
  EXPECT_EQ(post("/api/keepsakes/2026-01-04_000000_museum/delete").status, 404);
  EXPECT_TRUE(fs::exists(own / "important.doc"));
}

TEST_F(StaffPage, AKeepsakeThatComesIsInTheNextListAndOneThatGoesIsNot) {
  fs::last_write_time(keepsakes_, fs::file_time_type::clock::now() - std::chrono::hours(1));
  EXPECT_THAT(get("/api/keepsakes").body, HasSubstr(kJar));
  fs::create_directory(keepsakes_ / "2026-05-28_150000_olla");
  std::ofstream(keepsakes_ / "2026-05-28_150000_olla" / "postcard.jpg") << "x";
  EXPECT_THAT(get("/api/keepsakes").body, HasSubstr("2026-05-28_150000_olla"));
  fs::remove_all(keepsakes_ / kJar);
  EXPECT_THAT(get("/api/keepsakes").body, Not(HasSubstr(kJar)));
}

TEST_F(StaffPage, FiguresAreThoseOfOnggiStatsWithSmallCellsLeftOut) {
  EXPECT_THAT(get("/api/figures").body, HasSubstr(R"("visits": 0)"));
  {
    std::vector<Problem> remarks;
    auto store = store::VisitStore::open(files::store_file(keepsakes_), "stamp", remarks);
    ASSERT_TRUE(store) << to_text(store.error());
    std::vector<store::VisitRecord> visits(9);
    for (std::size_t n = 0; n < visits.size(); ++n) {
      store::VisitRecord& v = visits[n];
      v.start = kNow;
      v.day = "2026-05-28";
      v.vessel = n < 7 ? "moon_jar" : "olla";
      v.scene = "first_touch";
      v.language = "en";
      v.way = "touch";
      v.reached = v.left = "throw";
      v.ended = "finished";
      v.active_s = 90;
    }
    ASSERT_TRUE(store->add(visits));
  }
  now_ += Figures::kEvery;
  const std::string told = get("/api/figures?from=2026-05-28&to=2026-05-28").body;
  EXPECT_THAT(told, AllOf(HasSubstr("\"visits\":9"), HasSubstr("moon_jar")));
  EXPECT_THAT(told, Not(HasSubstr("\"visits\":2"))) << "two ollas are too few to tell";
  EXPECT_THAT(get("/api/figures?from=2026-05-29&to=2026-05-29").body, HasSubstr("\"visits\":0"));
  EXPECT_EQ(get("/api/figures?from=x").status, 409);
  const web::Answer picture = get("/figures.svg?from=2026-05-28&to=2026-05-28");
  EXPECT_EQ(picture.status, 200);
  EXPECT_THAT(picture.body, HasSubstr("<svg"));
}

TEST_F(StaffPage, TheDeskDoesTheDesksWorkAndAnEditorDecidesWhoMay) {
  const web::Ask stranger{.method = "GET", .target = "/api/door", .host = kHost};
  EXPECT_THAT(staff_->to(stranger).body, HasSubstr("false"));
  ASSERT_EQ(add("maria", "desk").status, 200);
  EXPECT_THAT(staff_->to(stranger).body, AllOf(HasSubstr("true"), Not(HasSubstr("maria"))));
  ASSERT_EQ(add("joon", "editor").status, 200);
  EXPECT_THAT(get("/api/people").body,
              AllOf(HasSubstr("maria"), HasSubstr("joon"), Not(HasSubstr("argon"))));
  EXPECT_EQ(enter("maria", "a passphrase of maria").status, 200);
  EXPECT_THAT(get("/api/state").body,
              AllOf(HasSubstr("\"who\":\"maria\""), HasSubstr("\"role\":\"desk\"")));
  for (const std::string& target : kRead) EXPECT_NE(get(target).status, 403) << target;
  for (const char* target : {"/api/people", "/api/changes"})
    EXPECT_EQ(get(target).status, 403) << target;
  EXPECT_EQ(add("nobody", "editor").status, 403);
  EXPECT_EQ(post("/api/people/joon/remove").status, 403);
  EXPECT_EQ(post(std::string("/api/keepsakes/") + kJar + "/delete").status, 200);
  EXPECT_EQ(enter("joon", "a passphrase of joon").status, 200);
  EXPECT_EQ(add("somebody", "desk").status, 200);
  EXPECT_THAT(get("/api/changes").body,
              AllOf(HasSubstr("\"who\":\"maria\""), HasSubstr("deleted keepsake"), HasSubstr(kJar),
                    HasSubstr("somebody (desk)"), Not(HasSubstr("passphrase of"))));
}

TEST_F(StaffPage, WhoIsRemovedOrGetsAnotherRoleIsSignedOut) {
  ASSERT_EQ(add("maria", "desk").status, 200);
  const std::string editor = cookie_;
  for (const bool remove : {false, true}) {
    ASSERT_EQ(enter("maria", "a passphrase of maria").status, 200);
    const std::string maria = cookie_;
    cookie_ = editor;
    EXPECT_EQ((remove ? post("/api/people/maria/remove")
                      : post("/api/people", R"({"name": "maria", "role": "editor"})"))
                  .status,
              200);
    EXPECT_EQ(get("/api/state").status, 200);
    cookie_ = maria;
    EXPECT_EQ(get("/api/state").status, 401) << remove;
  }
  EXPECT_EQ(enter("maria", "a passphrase of maria").status, 401);
  // By another program, or a hand with an editor.
  cookie_ = editor;
  ASSERT_EQ(add("joon", "editor").status, 200);
  ASSERT_EQ(enter("joon", "a passphrase of joon").status, 200);
  EXPECT_EQ(get("/api/state").status, 200);
  std::ofstream(state_ / "people") << "\n";
  EXPECT_EQ(get("/api/state").status, 401);
}

TEST_F(StaffPage, ANameThatIsTakenIsNotGivenAgainByMistake) {
  ASSERT_EQ(add("maria", "desk").status, 200);
  EXPECT_EQ(
      post("/api/people",
           R"({"name": "maria", "role": "editor", "passphrase": "123456789012", "add": "yes"})")
          .status,
      409);
  EXPECT_EQ(enter("maria", "a passphrase of maria").status, 200);
}

TEST_F(StaffPage, AWrongPassphraseSlowsTheNextDownAndLocksNobodyOut) {
  ASSERT_EQ(add("maria", "desk").status, 200);
  EXPECT_EQ(enter("maria", "a passphrase of marta").status, 401);
  EXPECT_EQ(enter("nobody", "a passphrase of maria").status, 401);
  const web::Answer later = enter("maria", "a passphrase of maria");
  EXPECT_EQ(later.status, 429);
  EXPECT_THAT(later.body, HasSubstr("Wait a moment"));
  EXPECT_EQ(enter("maria", "a passphrase of maria", "192.168.4.9").status, 200)
      << "from another address she waits for nothing";
  now_ += 1;
  EXPECT_EQ(enter("maria", "a passphrase of maria").status, 200);
}

TEST_F(StaffPage, OnesOwnPassphraseIsChangedByTheOldOneAndEndsOnesOtherSessions) {
  ASSERT_EQ(add("maria", "desk").status, 200);
  ASSERT_EQ(enter("maria", "a passphrase of maria").status, 200);
  const std::string elsewhere = cookie_;
  ASSERT_EQ(enter("maria", "a passphrase of maria").status, 200);
  EXPECT_EQ(post("/api/passphrase", R"({"old": "wrong", "new": "another passphrase"})").status,
            409);
  now_ += 2;
  EXPECT_EQ(post("/api/passphrase", R"({"old": "a passphrase of maria", "new": "short"})").status,
            409);
  EXPECT_EQ(
      post("/api/passphrase", R"({"old": "a passphrase of maria", "new": "another passphrase"})")
          .status,
      200);
  cookie_ = elsewhere;
  EXPECT_EQ(get("/api/state").status, 401);
  EXPECT_EQ(enter("maria", "another passphrase").status, 200);
}

TEST_F(StaffPage, BodiesThatAreNotWhatThePageSendsChangeNothing) {
  for (const char* body : {"", "[]", "null", "{", "{\"name\": 5}", "{\"name\": {}}", "\xff\xfe",
                           R"({"name": "x y", "role": "desk", "passphrase": "123456789012"})",
                           R"({"name": "maria", "role": "king", "passphrase": "123456789012"})",
                           R"({"name": "maria", "role": "desk", "passphrase": "short"})",
                           R"({"name": "maria", "role": "desk"})"})
    EXPECT_EQ(post("/api/people", body).status, 409) << body;
  EXPECT_EQ(get("/api/people").body, "[]");
}

TEST_F(StaffPage, AFolderWithoutAnExhibitIsRefused) {
  const files::test::ScratchFolder empty;
  const auto none = Site::open(empty.path());
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().exit_code, 2);
  EXPECT_THAT(none.error().what, HasSubstr("config/exhibit.toml"));
  EXPECT_TRUE(Site::open(site_ / "config"));
  EXPECT_TRUE(Site::open(site_ / "config/exhibit.toml"));
}

// A kiosk that runs showed a code on its screen.
TEST_F(StaffPage, TheScreensCodeOpensItOnceAndOnlyUntilSomebodyHasAName) {
  EXPECT_EQ(souvenir::address_for_staff(keepsakes_), std::string("http://") + kHost);
  const auto shown = [&](const std::string& code, std::int64_t until) {
    watch::KioskState state;
    state.way_in = secrets::digest_of(code);
    state.way_in_until = until;
    std::ofstream(keepsakes_ / watch::kStateFile) << watch::text_of(state);
  };
  const auto opens = [&](const std::string& code) {
    return staff_->to({.method = "GET", .target = "/?code=" + code, .host = kHost}).status == 303;
  };
  shown("first", kNow + 3600);
  EXPECT_FALSE(opens("first")) << "that kiosk does not run";
  const files::Descriptor running(::open((keepsakes_ / watch::kStateFile).c_str(), O_RDWR));
  ASSERT_EQ(::flock(running.get(), LOCK_EX), 0);
  EXPECT_FALSE(opens("other"));
  EXPECT_FALSE(opens(""));
  EXPECT_TRUE(opens("first"));
  EXPECT_FALSE(opens("first"));
  shown("late", kNow);
  EXPECT_FALSE(opens("late"));
  shown("for ever", kNow + 1'000'000);
  EXPECT_FALSE(opens("for ever"));
  shown("second", kNow + 3600);
  ASSERT_EQ(post("/api/people",
                 R"({"name": "joon", "role": "editor", "passphrase": "three wet sponges"})")
                .status,
            200);
  EXPECT_EQ(souvenir::address_for_staff(keepsakes_), "") << "the kiosk shows none any more";
  EXPECT_FALSE(opens("second"));
}

}  // namespace
}  // namespace onggi::console::staff_answers_test
