#include "kiosk/ground/web/call.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "kiosk/ground/files/free_space.h"
#include "tests/kiosk/ground/files/disk.h"
#include "tests/kiosk/ground/web/uploads.h"

namespace onggi::web::call_test {
namespace {

using files::free_bytes;
using files::test::content;
using files::test::names_in;
using phone::test::hear;
using phone::test::PhoneConnection;
using test::file_head;
using test::say_megabytes;
using test::Serving;
using test::soon;
using test::Taker;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;
using namespace std::chrono_literals;

class BodyIntoFile : public ::testing::Test {
 protected:
  std::string bytes_of(std::size_t size) const {
    std::string bytes(size, '\0');
    for (std::size_t n = 0; n < size; ++n) bytes[n] = static_cast<char>(n * 2654435761u >> 13);
    return bytes;
  }
  std::vector<std::string> files() const { return names_in(scratch_.path()); }
  files::test::ScratchFolder scratch_, elsewhere_;
  Taker taker_{scratch_.path()};
};

TEST_F(BodyIntoFile, AFileThatIsSentIsWholeInTheHandsOfWhoeverAnswers) {
  taker_.keep_as = elsewhere_ / "scan.glb";
  const Serving serving(taker_);
  const std::string scan = bytes_of(300'001);
  EXPECT_THAT(hear(serving.port(), file_head(scan.size()) + scan + "more than was said"),
              HasSubstr("took 300001"));
  EXPECT_TRUE(content(elsewhere_ / "scan.glb") == scan);
  EXPECT_THAT(files(), IsEmpty());
}

TEST_F(BodyIntoFile, WhatNobodyTakesOverIsRemoved) {
  const Serving serving(taker_);
  EXPECT_THAT(hear(serving.port(), file_head(5) + "12345"), HasSubstr("took 5"));
  EXPECT_THAT(hear(serving.port(), file_head(0)), HasSubstr("took 0"));
  EXPECT_THAT(files(), IsEmpty());
}

TEST_F(BodyIntoFile, ABodyForMemoryIsReadAsEver) {
  const Serving serving(taker_);
  EXPECT_THAT(
      hear(serving.port(), phone::test::request("/", "POST", "Content-Length: 5\r\n") + "pots?"),
      HasSubstr("hello pots?"));
  EXPECT_THAT(hear(serving.port(), phone::test::request("/", "POST", "Content-Length: 1025\r\n")),
              HasSubstr("longer than 1024 bytes"));
  const std::string chunked =
      phone::test::request("/", "POST", "Transfer-Encoding: chunked\r\n") + "401\r\n";
  EXPECT_THAT(hear(serving.port(), chunked + std::string(1025, 'x') + "\r\n0\r\n\r\n"),
              HasSubstr("longer than 1024 bytes"));
}

TEST_F(BodyIntoFile, WithoutALengthTooLongOrWithoutRoomItIsRefusedInWordsBeforeItIsRead) {
  taker_.into.most = 5u << 20;
  const Serving serving(taker_);
  const std::string chunked =
      phone::test::request("/file", "POST", "Transfer-Encoding: chunked\r\n");
  // The answer comes although nothing of the body does.
  PhoneConnection unsaid(serving.port()), long_one(serving.port());
  ASSERT_TRUE(unsaid.say(chunked));
  EXPECT_THAT(unsaid.some(4096), testing::AllOf(StartsWith("HTTP/1.1 411"),
                                                HasSubstr("The size of this file was not said.")));
  ASSERT_TRUE(long_one.say(file_head((5u << 20) + 1)));
  EXPECT_THAT(
      long_one.some(4096),
      testing::AllOf(StartsWith("HTTP/1.1 413"),
                     HasSubstr("This file has 6 MB, which is too large. Send at most 5 MB.")));
  EXPECT_THAT(files(), IsEmpty());
}

TEST_F(BodyIntoFile, AFileThatWouldTakeTheReserveOfTheDiskIsRefusedBeforeItIsRead) {
  taker_.into.reserve = free_bytes(scratch_.path()) - 1000;
  const Serving serving(taker_);
  PhoneConnection browser(serving.port());
  ASSERT_TRUE(browser.say(file_head(4u << 20)));
  EXPECT_THAT(browser.some(4096),
              testing::AllOf(StartsWith("HTTP/1.1 507"), HasSubstr("the disk has room for")));
  EXPECT_THAT(files(), IsEmpty());
}

TEST_F(BodyIntoFile, AFolderThatIsNotThereIsTheMachinesFault) {
  taker_.into.folder = scratch_ / "none";
  const Serving serving(taker_);
  EXPECT_THAT(hear(serving.port(), file_head(0)), StartsWith("HTTP/1.1 500"));
  // The room on a disk that is not there cannot be asked.
  EXPECT_THAT(hear(serving.port(), file_head(1)).substr(0, 12), "HTTP/1.1 507");
}

TEST_F(BodyIntoFile, ABrowserThatSends300MegabytesStillSeesThatTheyAreRefused) {
  taker_.into.most = 200u << 20;
  const Serving serving(taker_);
  PhoneConnection browser(serving.port());
  ASSERT_TRUE(browser.say(file_head(300u << 20)));
  ASSERT_TRUE(say_megabytes(browser, 300)) << "browsers look at the answer last";
  EXPECT_THAT(browser.to_the_end(), StartsWith("HTTP/1.1 413"));
}

TEST_F(BodyIntoFile, WhoSendsOnWithoutAnEndIsNotHeardOut) {
  taker_.into.most = 0;
  const Serving serving(taker_, {.asking = 5s, .progress = 400ms});
  PhoneConnection silent(serving.port()), talker(serving.port());
  ASSERT_TRUE(silent.say(file_head(300u << 20)) && talker.say(file_head(1ull << 40)));
  silent.some(4096);
  EXPECT_EQ(silent.some(4096), "");
  EXPECT_FALSE(say_megabytes(talker, 1200)) << "a gigabyte is heard out";
}

TEST_F(BodyIntoFile, ALongUploadOutlivesThePatienceForARequest) {
  const Serving serving(taker_, {.asking = 200ms, .progress = 5s});
  PhoneConnection browser(serving.port());
  ASSERT_TRUE(browser.say(file_head(6)));
  for (const char* byte : {"1", "2", "3", "4", "5", "6"}) {
    std::this_thread::sleep_for(100ms);
    ASSERT_TRUE(browser.say(byte));
  }
  EXPECT_THAT(browser.to_the_end(), HasSubstr("took 6"));
}

TEST_F(BodyIntoFile, WhoStopsSendingOrSendsAByteNowAndThenIsDroppedAndThePartRemoved) {
  const Serving serving(taker_, {.asking = 5s, .progress = 400ms});
  {
    PhoneConnection browser(serving.port());
    ASSERT_TRUE(browser.say(file_head(1'000'000) + bytes_of(200'000)));
    EXPECT_TRUE(soon([&] { return files().size() == 1; }));
    EXPECT_TRUE(browser.closed(5000));
  }
  EXPECT_TRUE(soon([&] { return files().empty(); }));
  PhoneConnection trickle(serving.port());
  ASSERT_TRUE(trickle.say(file_head(1'000'000)));
  int said = 0;
  for (; said < 100 && !trickle.closed(50); ++said) static_cast<void>(trickle.say("x"));
  EXPECT_LT(said, 100);
  EXPECT_TRUE(soon([&] { return files().empty(); }));
}

TEST_F(BodyIntoFile, WhoHangsUpLeavesNothing) {
  const Serving serving(taker_);
  {
    PhoneConnection browser(serving.port());
    ASSERT_TRUE(browser.say(file_head(1'000'000) + bytes_of(200'000)));
    EXPECT_TRUE(soon([&] { return files().size() == 1; }));
  }
  EXPECT_TRUE(soon([&] { return files().empty(); }));
}

TEST_F(BodyIntoFile, WhileOneIsUnderWayAnotherCanBeRefusedAndThenNoMore) {
  const Serving serving(taker_);
  PhoneConnection first(serving.port());
  ASSERT_TRUE(first.say(file_head(10) + "1234"));
  EXPECT_TRUE(soon([&] { return files().size() == 1; }));
  EXPECT_THAT(hear(serving.port(), file_head(10) + "1234567890"), StartsWith("HTTP/1.1 503"));
  ASSERT_TRUE(first.say("567890"));
  EXPECT_THAT(first.to_the_end(), HasSubstr("took 10"));
  EXPECT_THAT(hear(serving.port(), file_head(10) + "1234567890"), HasSubstr("took 10"));
}

TEST_F(BodyIntoFile, ABrowserThatAsksWhetherToGoOnIsToldSoOrRefused) {
  const Serving serving(taker_);
  PhoneConnection browser(serving.port());
  ASSERT_TRUE(browser.say(file_head(3, "Expect: 100-continue\r\n")));
  EXPECT_EQ(browser.some(4096), "HTTP/1.1 100 Continue\r\n\r\n");
  ASSERT_TRUE(browser.say("pot"));
  EXPECT_THAT(browser.to_the_end(), HasSubstr("took 3"));
  EXPECT_THAT(hear(serving.port(), file_head(2ull << 30, "Expect: 100-continue\r\n")).substr(0, 12),
              "HTTP/1.1 413")
      << "it hangs up without sending";
}

TEST_F(BodyIntoFile, ADiskThatBecomesFullMidwayIsSaidAndThePartRemoved) {
  const int status = files::test::on_a_disk(scratch_.path(), 0, "size=8m", [&] {
    const Serving serving(taker_);
    PhoneConnection browser(serving.port());
    if (!browser.say(file_head(6u << 20)) || !say_megabytes(browser, 1)) return false;
    if (!soon([&] { return free_bytes(scratch_.path()) < (8u << 20) - (1u << 20) + 4096; }))
      return false;
    std::ofstream(scratch_ / "other") << std::string(4u << 20, 'x');
    if (!say_megabytes(browser, 5)) return false;
    const std::string heard = browser.to_the_end();
    const auto left = names_in(scratch_.path());
    return heard.starts_with("HTTP/1.1 507") && heard.find("became full") != std::string::npos &&
           left == std::vector<std::string>{"other"};
  });
  if (WEXITSTATUS(status) == files::test::kNoMounts) GTEST_SKIP() << "no mounts here";
  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace onggi::web::call_test
