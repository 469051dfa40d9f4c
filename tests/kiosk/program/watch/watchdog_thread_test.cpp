#include "kiosk/program/watch/watchdog_thread.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <systemd/sd-daemon.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>

#include "kiosk/program/watch/last_good.h"
#include "kiosk/program/watch/service.h"
#include "tests/kiosk/ground/files/disk.h"

namespace onggi::watch::watchdog_thread_test {
namespace {

using files::test::content;
using files::test::ScratchFolder;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;
namespace fs = std::filesystem;

/// systemd's end of sd_notify: a socket that takes what is said, as it is said. One that is left
/// full holds up whoever speaks.
class Systemd {
 public:
  Systemd() : socket_(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const std::string path = (folder_.path() / "notify").string();
    path.copy(address.sun_path, sizeof address.sun_path - 1);
    ::bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address);
    ::setenv("NOTIFY_SOCKET", path.c_str(), 1);
    ::setenv("WATCHDOG_USEC", "9000000", 1);
    ::setenv("WATCHDOG_PID", std::to_string(::getpid()).c_str(), 1);
    listener_ = std::thread([this] { listen(); });
  }
  ~Systemd() {
    sd_notify(0, kEnd);
    listener_.join();
    for (const char* name : {"NOTIFY_SOCKET", "WATCHDOG_USEC", "WATCHDOG_PID"}) ::unsetenv(name);
    ::close(socket_);
  }
  /// What was said since the last call: all that came before it.
  std::vector<std::string> heard() {
    const std::string mark = "X_MARK=" + std::to_string(++marks_);
    sd_notify(0, mark.c_str());
    std::unique_lock lock(mutex_);
    marked_.wait(lock, [&] { return !said_.empty() && said_.back() == mark; });
    said_.pop_back();
    return std::exchange(said_, {});
  }

 private:
  static constexpr const char* kEnd = "X_END=1";

  void listen() {
    char text[4096];
    for (ssize_t n = 0; (n = ::recv(socket_, text, sizeof text, 0)) >= 0;) {
      const std::string said(text, static_cast<std::size_t>(n));
      if (said == kEnd) return;
      const std::lock_guard lock(mutex_);
      // The keeper's thread speaks when it likes: of lines of status a test asks nothing.
      if (!said.starts_with("STATUS=")) said_.push_back(said);
      marked_.notify_all();
    }
  }

  ScratchFolder folder_;
  int socket_;
  int marks_ = 0;
  std::mutex mutex_;
  std::condition_variable marked_;
  std::vector<std::string> said_;
  std::thread listener_;
};

struct Kept {
  explicit Kept(const Systemd&) : ledger(folder.path() / "state") {
    fs::create_directories(folder.path() / "site/config");
    fs::create_directories(folder.path() / "site/content");
    std::ofstream(folder.path() / "site/config/exhibit.toml") << "title";
    EXPECT_TRUE(ledger.begin());
    options.state = folder.path() / "state";
    options.health = folder.path() / "onggi.prom";
    options.version = "0.1.0";
    options.watchdog_s = Service::watchdog_s();
    options.health_every = 0.01;  // of the kiosk's time, which a test makes
    options.trial_every = 0.01;
  }
  /// The keeper's thread has its own pace: waits for what it is to bring about.
  static bool soon(const std::function<bool()>& good) {
    for (int i = 0; i < 2000 && !good(); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return good();
  }
  fs::path site() const { return folder.path() / "site"; }
  fs::path keepsakes() const { return folder.path() / "keepsakes"; }
  Shown shown() const { return {site(), *files_of(site()), keepsakes(), false}; }
  ScratchFolder folder;
  RunHistory ledger;
  WatchdogOptions options;
};

TEST(keeper, systemd_hears_of_the_start_and_then_often_enough_while_all_moves) {
  Systemd systemd;
  Kept kept(systemd);
  EXPECT_DOUBLE_EQ(kept.options.watchdog_s, 9.0);
  WatchdogThread keeper(kept.options, kept.ledger);
  keeper.shows(kept.shown());
  keeper.look({1, 1, 1}, {}, 100.0);
  EXPECT_THAT(systemd.heard(), Contains("READY=1"));
  double silent = 0.0, longest = 0.0;
  for (std::uint64_t frame = 2; frame < 2000; ++frame) {
    keeper.look({frame, 33 * frame, frame}, {}, 100.0 + 0.033 * static_cast<double>(frame));
    silent += 0.033;
    for (const std::string& said : systemd.heard())
      if (said == "WATCHDOG=1") silent = 0.0;
    longest = std::max(longest, silent);
  }
  EXPECT_LT(longest, kept.options.watchdog_s / 2);
}

TEST(keeper, a_wheel_that_stands_is_told_and_systemd_hears_nothing_more) {
  Systemd systemd;
  Kept kept(systemd);
  WatchdogThread keeper(kept.options, kept.ledger);
  keeper.shows(kept.shown());
  std::vector<std::string> heard;
  for (std::uint64_t frame = 0; frame < 1000; ++frame) {
    keeper.look({frame, 500, frame}, {}, 0.1 * static_cast<double>(frame));
    for (std::string& said : systemd.heard())
      if (frame >= 90) heard.push_back(std::move(said));
  }
  EXPECT_THAT(heard, Not(Contains("WATCHDOG=1")));
  EXPECT_THAT(keeper.remarks(), Contains("Stopped: the wheel's loop."));
  keeper.look({1000, 501, 1000}, {}, 100.0);
  EXPECT_THAT(systemd.heard(), Contains("WATCHDOG=1"));
}

TEST(keeper, an_exhibit_that_ran_for_an_hour_is_kept_as_the_last_good_one_and_not_before) {
  Systemd systemd;
  Kept kept(systemd);
  WatchdogThread keeper(kept.options, kept.ledger);
  keeper.shows(kept.shown());
  keeper.look({1, 1, 1}, {}, 0.0);
  keeper.look({2, 2, 2}, {}, 3599.0);
  EXPECT_TRUE(Kept::soon([&] { return fs::exists(kept.options.health); }));
  EXPECT_FALSE(last_good(kept.options.state));
  keeper.look({3, 3, 3}, {}, 3600.0);
  EXPECT_TRUE(Kept::soon([&] { return last_good(kept.options.state).has_value(); }));
}

TEST(keeper, another_exhibit_has_an_hour_of_its_own) {
  Systemd systemd;
  Kept kept(systemd);
  WatchdogThread keeper(kept.options, kept.ledger);
  keeper.shows(kept.shown());
  keeper.look({1, 1, 1}, {}, 0.0);
  keeper.look({2, 2, 2}, {}, 3000.0);
  std::ofstream(kept.site() / "config/exhibit.toml") << "another title";
  keeper.shows(kept.shown());
  keeper.look({3, 3, 3}, {}, 6500.0);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_FALSE(last_good(kept.options.state));
  keeper.look({4, 4, 4}, {}, 6600.0);
  EXPECT_TRUE(Kept::soon([&] { return last_good(kept.options.state).has_value(); }));
  EXPECT_EQ(content(last_good(kept.options.state)->exhibit), "another title");
}

TEST(keeper, a_change_that_visitors_never_saw_is_not_kept_as_good_until_it_is_taken_back) {
  Systemd systemd;
  Kept kept(systemd);
  const fs::path exhibit = kept.site() / "config/exhibit.toml";
  const auto time = fs::last_write_time(exhibit);
  WatchdogThread keeper(kept.options, kept.ledger);
  keeper.shows(kept.shown());
  std::ofstream(exhibit) << "broken";
  keeper.look({1, 1, 1}, {}, 0.0);
  keeper.look({2, 2, 2}, {}, 4000.0);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_FALSE(last_good(kept.options.state));
  std::ofstream(exhibit) << "title";
  fs::last_write_time(exhibit, time);
  keeper.look({3, 3, 3}, {}, 4001.0);
  EXPECT_TRUE(Kept::soon([&] { return last_good(kept.options.state).has_value(); }));
}

TEST(keeper, an_exhibit_that_the_disk_did_not_take_is_kept_once_it_does_and_the_refusal_told_once) {
  Systemd systemd;
  Kept kept(systemd);
  const fs::path blocked = kept.folder.path() / "blocked";
  std::ofstream(blocked) << "a file where the folder has to be";
  kept.options.state = blocked / "state";
  WatchdogThread keeper(kept.options, kept.ledger);
  keeper.shows(kept.shown());
  int refusals = 0;
  double now = 0.0;
  keeper.look({1, 1, 1}, {}, now);
  const auto look = [&] {
    keeper.look({1, 1, 1}, {}, now += 3600.0);
    for (const std::string& line : keeper.remarks())
      refusals += line.find("last_good.new") != std::string::npos ? 1 : 0;
  };
  EXPECT_TRUE(Kept::soon([&] { return look(), refusals > 0; }));
  for (int more = 0; more < 20; ++more) {
    look();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  EXPECT_EQ(refusals, 1);
  fs::remove(blocked);
  EXPECT_TRUE(Kept::soon([&] { return look(), last_good(kept.options.state).has_value(); }));
}

TEST(keeper, where_keepsakes_go_is_remembered_for_a_run_that_finds_no_exhibit) {
  Systemd systemd;
  Kept kept(systemd);
  WatchdogThread keeper(kept.options, kept.ledger);
  keeper.shows(kept.shown());
  keeper.look({1, 1, 1}, {}, 0.0);
  EXPECT_TRUE(Kept::soon([&] { return remembered_keepsakes(kept.options.state).has_value(); }));
  EXPECT_EQ(remembered_keepsakes(kept.options.state), kept.keepsakes());
}

TEST(keeper, no_health_is_told_of_a_kiosk_that_has_made_no_picture) {
  Systemd systemd;
  Kept kept(systemd);
  WatchdogThread keeper(kept.options, kept.ledger);
  keeper.shows(kept.shown());
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_FALSE(fs::exists(kept.options.health));
}

TEST(keeper, the_health_says_what_the_kiosk_counted_and_that_the_disk_writes) {
  Systemd systemd;
  Kept kept(systemd);
  WatchdogThread keeper(kept.options, kept.ledger);
  keeper.shows(kept.shown());
  Health health;
  health.kept = 7;
  keeper.look({1, 1, 1}, health, 0.0);
  EXPECT_TRUE(Kept::soon([&] {
    keeper.look({1, 1, 1}, health, 1.0);
    return content(kept.options.health).find("\nonggi_keepsakes_total 7\n") != std::string::npos;
  }));
  EXPECT_THAT(content(kept.options.health), HasSubstr("\nonggi_disk_writes 1\n"));
  EXPECT_THAT(content(kept.options.health), HasSubstr("onggi_info{version=\"0.1.0\"} 1"));
}

TEST(keeper, a_disk_that_takes_nothing_is_told_once_and_then_that_it_does_again) {
  Systemd systemd;
  Kept kept(systemd);
  std::ofstream(kept.keepsakes()) << "a file where the folder has to be";
  WatchdogThread keeper(kept.options, kept.ledger);
  keeper.shows(kept.shown());
  std::vector<std::string> told;
  double now = 0.0;
  const auto hears = [&](const char* words) {
    return Kept::soon([&] {
      keeper.look({1, 1, 1}, {}, now += 1.0);
      for (std::string& line : keeper.remarks()) told.push_back(std::move(line));
      return std::any_of(told.begin(), told.end(), [&](const std::string& line) {
        return line.find(words) != std::string::npos;
      });
    });
  };
  EXPECT_TRUE(hears("A file is in the place of a folder"));
  for (int more = 0; more < 20; ++more) {  // trials that fail as the first did
    keeper.look({1, 1, 1}, {}, now += 1.0);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  fs::remove(kept.keepsakes());
  EXPECT_TRUE(hears("The disk can be written again."));
  EXPECT_EQ(std::count_if(told.begin(), told.end(),
                          [](const std::string& line) {
                            return line.find("A file is in") != std::string::npos;
                          }),
            1);
}

}  // namespace
}  // namespace onggi::watch::watchdog_thread_test
