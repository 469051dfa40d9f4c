#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "kiosk/program/console/staff_answers.h"
#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::console::test {

namespace fs = std::filesystem;

inline constexpr std::int64_t kNow = 1'780'000'000;
inline constexpr const char* kHost = "127.0.0.1:8090";
inline constexpr const char* kJar = "2026-05-28_141503_moon_jar";
inline constexpr const char* kOlla = "2026-05-27_101500_olla";

/// A site with two keepsakes, and a browser that has come in.
class StaffPage : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(site_ / "config");
    exhibit("");
    for (const char* visit : {kJar, kOlla}) {
      fs::create_directories(keepsakes_ / visit);
      for (const char* file : {"postcard.jpg", "pot.glb", "small.jpg", "visit.onggi"})
        std::ofstream(keepsakes_ / visit / file) << file << " of " << visit;
    }
    std::ofstream(keepsakes_ / kJar / "name.txt") << "quiet-blue-heron\n";
    serve("/bin/true");
  }
  /// Serves the page, with `onggi` as the kiosk's program, and comes in.
  void serve(const fs::path& onggi) {
    auto site = Site::open(site_.path());
    ASSERT_TRUE(site) << to_text(site.error());
    auto people = People::open(state_);
    ASSERT_TRUE(people) << to_text(people.error());
    staff_ = std::make_unique<StaffAnswers>(
        StaffAnswers::Parts{.site = std::move(*site),
                            .check = FileCheck("/bin/true", site_ / "config/exhibit.toml"),
                            .onggi = onggi,
                            .people = std::move(*people),
                            .changes = ChangeLog(state_),
                            .prices = state_ / "prices",
                            .scans = state_ / "scans",
                            .sheets = state_ / "sheets",
                            .trial = state_ / "trial",
                            .clock = [this] { return now_; }});
    auto door = Door::make("staff", state_, now_);
    ASSERT_TRUE(door);
    staff_->open(std::move(*door), {kHost, "localhost:8090"});
    EXPECT_EQ(enter_by_code().status, 303);
  }
  web::Answer enter_by_code() {
    const auto code = Door::give_code(state_, now_);
    EXPECT_TRUE(code);
    web::Answer in = staff_->to({.method = "GET", .target = "/?code=" + *code, .host = kHost});
    for (const auto& [name, value] : in.fields)
      if (name == "Set-Cookie") cookie_ = value.substr(0, value.find(';'));
    return in;
  }
  void exhibit(const std::string& more) const {
    std::ofstream(site_ / "config/exhibit.toml")
        << "credit = \"A <b>museum</b>\"\nlanguages = [\"en\"]\n"
        << more << "\n[title]\nen = \"Clay\"\n\n[keepsake]\nfolder = \"../keepsakes\"\n";
  }
  web::Ask asking(const std::string& target) const {
    return {.method = "GET", .target = target, .host = kHost, .cookie = cookie_};
  }
  web::Ask posting(const std::string& target) const {
    return {.method = "POST",
            .target = target,
            .host = kHost,
            .origin = std::string("http://") + kHost,
            .cookie = cookie_,
            .type = "application/json",
            .body = "{}"};
  }
  web::Answer get(const std::string& target) const { return staff_->to(asking(target)); }
  web::Answer post(const std::string& target, const std::string& body = "{}") const {
    web::Ask ask = posting(target);
    ask.body = body;
    return staff_->to(ask);
  }
  /// Comes in anew by name and passphrase, from `from`.
  web::Answer enter(const std::string& name, const std::string& passphrase,
                    const std::string& from = "127.0.0.1") {
    web::Ask ask = posting("/api/enter");
    ask.cookie = "";
    ask.from = from;
    ask.body = R"({"name": ")" + name + R"(", "passphrase": ")" + passphrase + "\"}";
    web::Answer answer = staff_->to(ask);
    for (const auto& [field, value] : answer.fields)
      if (field == "Set-Cookie") cookie_ = value.substr(0, value.find(';'));
    return answer;
  }
  web::Answer add(const std::string& name, const std::string& role) const {
    return post("/api/people", R"({"name": ")" + name + R"(", "role": ")" + role +
                                   R"(", "passphrase": "a passphrase of )" + name + "\"}");
  }

  std::int64_t now_ = kNow;
  files::test::ScratchFolder site_;
  fs::path keepsakes_ = site_ / "keepsakes", state_ = site_ / "state";
  std::unique_ptr<StaffAnswers> staff_;
  std::string cookie_;
};

}  // namespace onggi::console::test
