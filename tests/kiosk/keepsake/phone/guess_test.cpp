#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "kiosk/ground/web/server.h"
#include "kiosk/keepsake/phone/answers.h"
#include "kiosk/keepsake/souvenir/open_passes.h"
#include "kiosk/keepsake/souvenir/pass.h"
#include "tests/kiosk/ground/files/disk.h"
#include "tests/kiosk/keepsake/phone/phone_client.h"

// Whoever guesses at tokens. In each run of the tests 20,000 times; ten million by
//   ONGGI_GUESSES=10000000 build/release/bin/onggi_test_kiosk_keepsake_phone
//   --gtest_filter='Guess*'
// All of them ask the function that looks for a pass, on a disk; one in a hundred goes the whole
// way, by a socket.

namespace onggi::phone::guess_test {
namespace {

constexpr std::int64_t kNow = 1'780'000'000;
constexpr char kLetters[] = "abcdefghijkmnpqrstuvwxyz23456789";

class Guess : public ::testing::Test {
 protected:
  void SetUp() override {
    for (int n = 0; n < 20; ++n) {
      const std::string visit = "2026-05-04_1415" + std::to_string(10 + n) + "_moon_jar";
      std::filesystem::create_directories(scratch_.path() / visit);
      const auto pass = passes_.give(visit, kNow, 24);
      ASSERT_TRUE(pass) << to_text(pass.error());
      tokens_.push_back(pass->token);
    }
    if (const char* many = std::getenv("ONGGI_GUESSES")) guesses_ = std::atoi(many);
  }
  /// Of four kinds: anything; a true token with one letter wrong; the halves of two true ones; the
  /// next after a true one, as whoever counts would have it.
  std::string next() {
    std::string guess = tokens_[random_() % tokens_.size()];
    switch (asked_++ % 4) {
      case 0:
        for (char& letter : guess) letter = kLetters[random_() % 32];
        break;
      case 1: {
        char& letter = guess[random_() % guess.size()];
        const char was = letter;
        while (letter == was) letter = kLetters[random_() % 32];
        break;
      }
      case 2: {
        std::string other = guess;
        while (other == guess) other = tokens_[random_() % tokens_.size()];
        guess = guess.substr(0, 13) + other.substr(13);
        break;
      }
      default: {
        const std::string letters = kLetters;
        std::size_t carry = 1 + random_() % 1000;
        for (std::size_t n = guess.size(); n-- > 0 && carry > 0;) {
          carry += letters.find(guess[n]);
          guess[n] = letters[carry % 32];
          carry /= 32;
        }
      }
    }
    return guess;
  }
  void progress(int n, const char* how) const {
    if (guesses_ < 1'000'000 || n % (guesses_ / 20) != 0) return;
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun_;
    std::fprintf(stderr, "%d guesses %s, %.0f s, %d hits\n", n, how, took.count(), hits_);
  }
  files::test::ScratchFolder scratch_;
  souvenir::Passes passes_{scratch_.path()};
  souvenir::OpenPasses open_{scratch_.path()};
  std::vector<std::string> tokens_;
  std::mt19937_64 random_{305};
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
  int guesses_ = 20'000, asked_ = 0, hits_ = 0;
};

TEST_F(Guess, NoneOfManyHitsAndEachCostsTheSameWork) {
  const std::size_t letters = 20 * souvenir::kTokenLetters;
  int unlike = 0;
  for (int n = 1; n <= guesses_; ++n) {
    souvenir::OpenPasses::Work work;
    hits_ += open_.find(next(), kNow + 60, &work) ? 1 : 0;
    unlike += work.letters == letters && work.files == 1 ? 0 : 1;
    progress(n, "at the function");
  }
  EXPECT_EQ(hits_, 0);
  EXPECT_EQ(unlike, 0);
  for (const std::string& token : tokens_)
    EXPECT_TRUE(open_.find(token, kNow + 60)) << "a true one";
}

TEST_F(Guess, NoneOfManyOverASocketHearsAnythingButTheOneAnswer) {
  Answers answers(open_, [] { return kNow + 60; });
  auto server = web::Server::listen("127.0.0.1", 0, answers);
  ASSERT_TRUE(server);
  std::thread runs([&] { (*server)->run([] { return false; }); });
  const auto hear = [&](const std::string& target) {
    return test::hear((*server)->port(), test::request(target));
  };
  const std::string nothing = hear("/");
  EXPECT_EQ(nothing.substr(0, 12), "HTTP/1.1 404");
  for (int n = 1; n <= guesses_ / 100; ++n) {
    hits_ += hear("/k/" + next()) == nothing ? 0 : 1;
    progress(100 * n, "in all; one in a hundred over a socket");
  }
  EXPECT_EQ(hits_, 0);
  EXPECT_EQ(hear("/k/" + tokens_.front()).substr(0, 12), "HTTP/1.1 200");
  (*server)->stop();
  runs.join();
}

}  // namespace
}  // namespace onggi::phone::guess_test
