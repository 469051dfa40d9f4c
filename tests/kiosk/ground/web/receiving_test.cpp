#include "kiosk/ground/web/receiving.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iostream>
#include <string>
#include <thread>

#include "kiosk/ground/files/descriptor.h"
#include "tests/kiosk/ground/files/disk.h"
#include "tests/kiosk/ground/web/uploads.h"
#include "tests/support/sanitized.h"

namespace onggi::web::receiving_test {
namespace {

using files::test::content;
using files::test::names_in;
using phone::test::PhoneConnection;
using ::testing::IsEmpty;
using Clock = std::chrono::steady_clock;

class ReceivingTest : public ::testing::Test {
 protected:
  void SetUp() override {
    int ends[2] = {-1, -1};
    ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends), 0);
    here_ = files::Descriptor(ends[0]), there_ = files::Descriptor(ends[1]);
  }
  IntoFile into() const { return {.folder = scratch_.path(), .most = 1u << 20, .reserve = 0}; }
  files::test::ScratchFolder scratch_;
  files::Descriptor here_, there_;
};

TEST_F(ReceivingTest, ABodyComesInPiecesAndNoByteBehindItIsTaken) {
  const std::string body(150'000, 'b');
  auto receiving = Receiving::begin(into(), body.size(), files::test::bytes("first")).value();
  EXPECT_EQ(receiving.received(), 5u);
  EXPECT_EQ(receiving.step(here_.get()), Receiving::Step::more) << "nothing is there yet";
  ASSERT_TRUE(files::write_all(there_.get(), files::test::bytes(body)));
  for (auto step = Receiving::Step::more; step != Receiving::Step::all;) {
    const std::uint64_t before = receiving.received();
    step = receiving.step(here_.get());
    ASSERT_NE(step, Receiving::Step::broken);
    EXPECT_LE(receiving.received() - before, Receiving::kPiece);
  }
  EXPECT_EQ(receiving.received(), body.size());
  char rest[16];
  EXPECT_EQ(::recv(here_.get(), rest, sizeof rest, MSG_DONTWAIT), 5) << "the next request's";
  const auto file = receiving.take();
  EXPECT_TRUE(content(file->path()) == "first" + body.substr(5));
}

TEST_F(ReceivingTest, OfWhatCameWithTheHeadItTakesItsOwn) {
  auto receiving = Receiving::begin(into(), 3, files::test::bytes("potGET /")).value();
  EXPECT_EQ(receiving.step(here_.get()), Receiving::Step::all);
  EXPECT_EQ(content(receiving.take()->path()), "pot");
}

TEST_F(ReceivingTest, ABrowserThatIsGoneBreaksItAndThePartGoes) {
  {
    auto receiving = Receiving::begin(into(), 100, files::test::bytes("half")).value();
    there_.close();
    EXPECT_EQ(receiving.step(here_.get()), Receiving::Step::broken);
  }
  EXPECT_THAT(names_in(scratch_.path()), IsEmpty());
}

TEST_F(ReceivingTest, TheLimitAndTheReserveAreExact) {
  EXPECT_TRUE(Receiving::begin(into(), 1u << 20, {}));
  const auto longer = Receiving::begin(into(), (1u << 20) + 1, {});
  ASSERT_FALSE(longer);
  EXPECT_EQ(longer.error().status, 413);
  const int status = files::test::on_a_disk(scratch_.path(), 0, "size=1m", [&] {
    IntoFile place = into();
    place.reserve = 1u << 19;
    const auto fits = Receiving::begin(place, 1u << 19, {});
    const auto more = Receiving::begin(place, (1u << 19) + 1, {});
    return fits && !more && more.error().status == 507;
  });
  if (WEXITSTATUS(status) == files::test::kNoMounts) GTEST_SKIP() << "no mounts here";
  EXPECT_EQ(status, 0);
}

/// A number of kB in /proc/PID/status.
long kilobytes(pid_t process, const std::string& name) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(name + ':')) return std::stol(line.substr(name.size() + 1));
  return -1;
}

/// A process of its own that serves files into `folder`, and its port.
std::pair<pid_t, std::uint16_t> serving_process(const std::filesystem::path& folder) {
  int said[2] = {-1, -1};
  if (::pipe(said) != 0) return {-1, 0};
  const pid_t process = ::fork();
  if (process == 0) {
    test::Taker taker(folder);
    const auto server = Server::listen("127.0.0.1", 0, taker).value();
    const std::uint16_t port = server->port();
    static_cast<void>(::write(said[1], &port, sizeof port));
    server->run([] { return false; });
    ::_exit(0);
  }
  std::uint16_t port = 0;
  const bool good = ::read(said[0], &port, sizeof port) == sizeof port;
  ::close(said[0]), ::close(said[1]);
  return {process, good ? port : std::uint16_t{0}};
}

TEST(ReceivingProcess, TwoHundredMegabytesTakeAFewOfMemoryAndNobodyElseWaits) {
  constexpr int kMegabytes = 200;
  const files::test::ScratchFolder scratch;
  const auto [process, port] = serving_process(scratch.path());
  ASSERT_NE(port, 0);
  const std::string hello = phone::test::request("/");
  ASSERT_THAT(phone::test::hear(port, hello), testing::HasSubstr("hello"));
  const long before = kilobytes(process, "VmRSS");
  std::string heard;
  double seconds = 0;
  std::atomic<bool> over{false};
  std::thread browser([&heard, &seconds, &over, at = port] {
    const auto begin = Clock::now();
    PhoneConnection own(at);
    if (own.say(test::file_head(std::uint64_t{kMegabytes} << 20)) &&
        test::say_megabytes(own, kMegabytes))
      heard = own.to_the_end();
    seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    over = true;
  });
  double longest = 0;
  int asked = 0;
  while (!over) {
    if (names_in(scratch.path()).empty()) continue;
    const auto begin = Clock::now();
    if (phone::test::hear(port, hello).empty()) break;
    longest = std::max(longest, std::chrono::duration<double>(Clock::now() - begin).count());
    ++asked;
  }
  browser.join();
  const long most = kilobytes(process, "VmHWM");
  ::kill(process, SIGTERM);
  ::waitpid(process, nullptr, 0);
  EXPECT_THAT(heard, testing::HasSubstr("took " + std::to_string(kMegabytes << 20)));
  std::cout << "VmHWM " << most << " kB, " << most - before << " kB more than before; " << seconds
            << " s; " << asked << " others answered meanwhile, the slowest in " << longest * 1e3
            << " ms\n";
  EXPECT_GT(asked, 0);
  if (ONGGI_SANITIZED == 0) {
    EXPECT_LT(most - before, 2048);
  }
  EXPECT_THAT(names_in(scratch.path()), IsEmpty());
}

}  // namespace
}  // namespace onggi::web::receiving_test
