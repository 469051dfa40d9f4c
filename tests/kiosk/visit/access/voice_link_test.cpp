#include "kiosk/visit/access/voice_link.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <thread>

#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::access::voice_link_test {
namespace {

namespace fs = std::filesystem;

/// A voice that a shell plays; what it is told goes to a file.
class Voice : public ::testing::Test {
 protected:
  VoiceLink link(const std::string& script) {
    return VoiceLink("/bin/sh", {"-c", "told='" + told().string() + "'; " + script});
  }
  fs::path told() const { return folder_ / "told"; }
  std::string heard() const { return files::test::content(told()); }
  /// Looks until `so` or ten seconds are over; the link's own clock goes `pace` times as fast.
  template <class So>
  bool until(VoiceLink& link, So&& so, double pace = 1) {
    for (int n = 0; n < 1000 && !so(); ++n) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      link.look(now_ += 0.01 * pace);
      for (const auto id : link.ended()) ended_.push_back(id);
      for (auto& line : link.remarks()) remarks_.push_back(line);
    }
    return so();
  }
  const files::test::ScratchFolder folder_;
  double now_ = 100;
  std::vector<std::uint64_t> ended_;
  std::vector<std::string> remarks_;
};

constexpr const char* kGood =
    "echo ready; while read verb id rest; do echo \"$verb $id $rest\" >> $told; "
    "echo \"taken ${id:-0}\"; echo \"ended $id\"; done";

TEST_F(Voice, IsToldWhatToSayOnOneLineAndSaysWhenItHas) {
  VoiceLink voice = link(kGood);
  voice.begin(now_);
  voice.say({"en", "before it is ready", 2, 1}, now_);
  voice.say({"en", "one\nline\r and no more", 2, 2}, now_);
  ASSERT_TRUE(until(voice, [&] { return !ended_.empty(); }));
  voice.say({"ko", "달항아리", 1, 3}, now_);
  ASSERT_TRUE(until(voice, [&] { return ended_.size() == 2; }));
  EXPECT_EQ(heard(), "say 2 en one line  and no more\nsay 3 ko 달항아리\n");
  EXPECT_EQ(ended_, (std::vector<std::uint64_t>{2, 3}));
  voice.say({"", "", 3, 4}, now_);
  ASSERT_TRUE(until(voice, [&] { return heard().find("hush") != std::string::npos; }));
  EXPECT_TRUE(remarks_.empty());
}

TEST_F(Voice, IsNotStartedBeforeAVisitorWantsOne) {
  VoiceLink voice = link(kGood);
  voice.say({"en", "hello", 2, 1}, now_);
  voice.look(now_ + 1);
  EXPECT_FALSE(voice.running());
}

TEST_F(Voice, OneThatHangsIsKilledAndBegunAnewAndNothingWaitsForIt) {
  VoiceLink voice = link("echo x >> $told; echo ready; sleep 1000");
  voice.begin(now_);
  const auto before = std::chrono::steady_clock::now();
  voice.say({"en", "hello", 2, 1}, now_);
  EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::milliseconds(100));
  ASSERT_TRUE(until(
      voice,
      [&] {
        if (heard() == "x\n") voice.say({"en", "hello", 2, 2}, now_);
        return heard() == "x\nx\n";
      },
      10))
      << heard();
  ASSERT_FALSE(remarks_.empty());
  EXPECT_NE(remarks_[0].find("did not answer"), std::string::npos);
}

TEST_F(Voice, OneThatNeverBecomesReadyIsKilledToo) {
  VoiceLink voice = link("sleep 1000");
  voice.begin(now_);
  ASSERT_TRUE(until(
      voice, [&] { return voice.failures() > 0; }, 20));
  EXPECT_FALSE(voice.running());
}

TEST_F(Voice, OneThatDiesAtOnceIsLeftAloneAfterEightTimesAndToldOfTwice) {
  VoiceLink voice = link("echo x >> $told");
  voice.begin(now_);
  ASSERT_TRUE(until(
      voice, [&] { return voice.failures() >= VoiceLink::kMost; }, 200));
  const auto dead = heard();
  EXPECT_EQ(std::count(dead.begin(), dead.end(), 'x'), VoiceLink::kMost);
  for (int n = 0; n < 20; ++n) voice.look(now_ += 60);
  EXPECT_EQ(heard(), dead);
  EXPECT_EQ(remarks_.size(), 2u) << "the first and the last";
  voice.begin(now_);
  EXPECT_TRUE(until(voice, [&] { return heard() != dead; })) << "the next visitor may ask again";
}

TEST_F(Voice, ALanguageThatNobodySpeaksIsToldOnceAndSaidNothingIn) {
  VoiceLink voice = link(
      "echo ready; while read verb id language rest; do echo $language >> $told; "
      "if [ $language = ko ]; then echo 'voiceless ko'; else echo taken $id; fi; done");
  voice.begin(now_);
  for (const std::uint64_t id : {1, 2, 3}) {
    voice.say({"ko", "안녕", 2, id}, now_);
    until(voice, [&] { return !remarks_.empty(); });
  }
  EXPECT_EQ(remarks_.size(), 1u);
  EXPECT_EQ(heard(), "ko\n");
  voice.say({"en", "hello", 2, 4}, now_);
  EXPECT_TRUE(until(voice, [&] { return heard() == "ko\nen\n"; }));
}

TEST_F(Voice, OneThatTalksNonsenseOrDoesNotListenIsNoDangerToAnybody) {
  VoiceLink chatty = link("yes 0123456789 | tr -d '\\n'");
  chatty.begin(now_);
  EXPECT_TRUE(until(chatty, [&] { return chatty.failures() > 0; }));
  VoiceLink deaf = link("echo ready; exec sleep 1000");
  deaf.begin(now_);
  ASSERT_TRUE(until(deaf, [&] { return deaf.running(); }));
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  deaf.look(now_);
  const std::string long_text(60000, 'a');
  const int before = deaf.failures();
  for (int n = 0; n < 40; ++n) deaf.say({"en", long_text, 2, 1}, now_);
  EXPECT_GT(deaf.failures(), before) << "its pipe is full, and nobody waited";
}

}  // namespace
}  // namespace onggi::access::voice_link_test
