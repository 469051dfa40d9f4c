#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "kiosk/ground/web/server.h"
#include "kiosk/keepsake/phone/answers.h"
#include "kiosk/keepsake/souvenir/pass.h"
#include "tests/kiosk/ground/files/disk.h"
#include "tests/kiosk/keepsake/phone/phone_client.h"

namespace onggi::phone::test {

constexpr std::int64_t kNow = 1'780'000'000, kHour = 3600;
constexpr const char* kVisit = "2026-05-04_141503_moon_jar";

/// A folder of keepsakes with two visits in it, and phones that ask over real sockets.
class PhoneTest : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const char* visit : {kVisit, "2026-05-04_150000_meiping"}) {
      std::filesystem::create_directories(keepsakes_ / visit);
      for (const char* file : {"postcard.png", "postcard.jpg", "pot.glb", "pot.stl", "visit.onggi"})
        std::ofstream(keepsakes_ / visit / file) << file << " of " << visit;
    }
    serve({});
  }
  void TearDown() override { stop(); }
  /// Serves, from now on, with these limits.
  void serve(const web::Server::Limits& limits) {
    stop();
    auto server = web::Server::listen("127.0.0.1", 0, answers_, limits);
    ASSERT_TRUE(server) << to_text(server.error());
    server_ = std::move(*server);
    runs_ = std::thread([this] { server_->run([] { return false; }); });
  }
  void stop() {
    if (!server_) return;
    server_->stop();
    runs_.join();
    server_.reset();
  }
  std::string token(double hours = 24, const std::string& language = {}) {
    const auto pass = passes_.give(kVisit, now_, hours, language);
    EXPECT_TRUE(pass) << to_text(pass.error());
    return pass->token;
  }
  std::string hear(const std::string& words) const { return test::hear(server_->port(), words); }
  std::string get(const std::string& target, const std::string& method = "GET",
                  const std::string& languages = {}) const {
    return hear(
        request(target, method, languages.empty() ? "" : "Accept-Language: " + languages + "\r\n"));
  }

  files::test::ScratchFolder folder_;
  std::filesystem::path keepsakes_ = folder_.path() / "kept";
  std::atomic<std::int64_t> now_{kNow};
  souvenir::Passes passes_{keepsakes_};
  std::vector<Problem> remarks_;
  std::vector<Problem> told_;  // to the staff; by the server's thread, before it answers
  Answers answers_{souvenir::OpenPasses(keepsakes_), [this] { return now_.load(); },
                   PhoneLanguages::read("content/languages", remarks_),
                   [this](const Problem& remark) { told_.push_back(remark); }};
  std::unique_ptr<web::Server> server_;
  std::thread runs_;
};

}  // namespace onggi::phone::test
