#include "kiosk/ground/web/sending.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>

#include <fstream>
#include <random>

#include "tests/kiosk/ground/files/disk.h"

namespace onggi::web::sending_test {
namespace {

class SendingTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::mt19937 random(42);
    for (char& byte : bytes_) byte = static_cast<char>(random());
    std::ofstream(file_, std::ios::binary) << bytes_;
    ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, ends_), 0);
  }
  void TearDown() override {
    for (const int end : ends_) ::close(end);
  }
  SentFile opened() const {
    return {.file = files::Descriptor(::open(file_.c_str(), O_RDONLY)), .size = bytes_.size()};
  }
  /// What the phone has by now.
  void take() {
    char some[4096];
    for (ssize_t n = 0; (n = ::recv(ends_[1], some, sizeof some, 0)) > 0;)
      heard_.append(some, static_cast<std::size_t>(n));
  }
  files::test::ScratchFolder scratch_;
  std::filesystem::path file_ = scratch_.path() / "pot.stl";
  std::string bytes_ = std::string(300'000, '\0'), heard_;
  int ends_[2] = {-1, -1};
};

TEST_F(SendingTest, AnAnswerGoesInPiecesAndNoneOfTheFileIsHeld) {
  const std::string head(40'000, 'h');
  Sending sending(head, opened(), {1000, 250'000});
  std::uint64_t before = 0;
  for (Sending::Step step = Sending::Step::more; step != Sending::Step::all;) {
    step = sending.step(ends_[0]);
    ASSERT_NE(step, Sending::Step::broken);
    EXPECT_LE(sending.given() - before, Sending::kPiece);
    before = sending.given();
    if (before >= head.size()) {
      EXPECT_LT(sending.held(), 64u);
    }
    take();
  }
  EXPECT_EQ(sending.given(), head.size() + 250'000);
  EXPECT_EQ(heard_, head + bytes_.substr(1000, 250'000));
}

TEST_F(SendingTest, ASocketThatIsFullIsWaitedForAndOneThatIsGoneIsNot) {
  Sending sending("head", opened(), {0, bytes_.size()});
  for (std::uint64_t before = ~0ull; before != sending.given();) {
    before = sending.given();
    ASSERT_EQ(sending.step(ends_[0]), Sending::Step::more);
  }
  EXPECT_LT(sending.given(), 4 + bytes_.size()) << "the phone takes nothing";
  ::signal(SIGPIPE, SIG_IGN);
  ::close(ends_[1]);
  EXPECT_EQ(sending.step(ends_[0]), Sending::Step::broken);
}

TEST_F(SendingTest, AFileThatIsDeletedIsSeenToBeAndOneThatGotShorterEndsTheAnswer) {
  Sending sending("", opened(), {0, bytes_.size()});
  EXPECT_FALSE(sending.deleted());
  std::filesystem::resize_file(file_, 10'000);
  EXPECT_EQ(sending.step(ends_[0]), Sending::Step::more);
  EXPECT_EQ(sending.step(ends_[0]), Sending::Step::broken);
  std::filesystem::remove(file_);
  EXPECT_TRUE(sending.deleted());
}

}  // namespace
}  // namespace onggi::web::sending_test
