#include "kiosk/ground/web/connection_shares.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <map>
#include <string>
#include <vector>

namespace onggi::web::connection_shares_test {
namespace {

TEST(ConnectionShares, IdleOnesOfOneAddressGoBeforeAnybodyElse) {
  ConnectionShares shares(8);
  const auto visitor = shares.enter("visitor").in;
  std::vector<ConnectionShares::Number> idle;
  for (int n = 0; n < 4; ++n) idle.push_back(shares.enter("idle").in);
  for (int n = 0; n < 100; ++n) {
    const auto entry = shares.enter("idle");
    EXPECT_NE(entry.in, 0u) << "the newest comes in";
    EXPECT_EQ(entry.out, idle.front()) << "and the oldest of its own goes";
    idle.erase(idle.begin());
    idle.push_back(entry.in);
  }
  EXPECT_EQ(shares.open(), 5u);
  shares.asked(visitor);
  EXPECT_EQ(shares.enter("another").out, 0u);
}

TEST(ConnectionShares, WhereEverythingIsTakenTheOldestSilentOneGoesAndADownloadGoesOn) {
  ConnectionShares shares(6);
  const auto download = shares.enter("a").in, silent = shares.enter("a").in;
  shares.asked(download);
  for (const char* address : {"b", "c", "d", "e"}) shares.asked(shares.enter(address).in);
  EXPECT_EQ(shares.enter("f").out, silent);
  EXPECT_EQ(shares.open(), 6u);
}

TEST(ConnectionShares, AnAddressFullOfDownloadsRefusesItsOwnAndGivesOneToAnother) {
  ConnectionShares shares(8);
  for (const char* address : {"a", "b"})
    for (int n = 0; n < 4; ++n) shares.asked(shares.enter(address).in);
  EXPECT_EQ(shares.enter("a").in, 0u);
  const auto entry = shares.enter("c");
  EXPECT_NE(entry.in, 0u);
  EXPECT_EQ(entry.out, 1u) << "the oldest of the most";
}

// By the order of their names, the visitor at 127.0.0.2 went before each of 16,000 at 127.1.
TEST(ConnectionShares, OfAddressesWithAsManyTheOldestConnectionGoesWhateverTheirNames) {
  ConnectionShares shares(3);
  const auto first = shares.enter("c").in, second = shares.enter("b").in;
  (void)shares.enter("a");
  EXPECT_EQ(shares.enter("0").out, first);
  EXPECT_EQ(shares.enter("d").out, second);
  ConnectionShares busy(4);
  std::vector<ConnectionShares::Number> all;
  for (const char* address : {"b", "a", "b", "a"}) all.push_back(busy.enter(address).in);
  for (const auto number : all) busy.asked(number);
  EXPECT_EQ(busy.enter("c").out, all[0]);
}

TEST(ConnectionShares, TheWorkForANewcomerHardlyGrowsWithTheNumberOfAddresses) {
  const auto work = [](int addresses) {
    ConnectionShares shares(static_cast<std::size_t>(addresses));
    for (int n = 0; n < addresses; ++n) {
      const auto number = shares.enter("10.0." + std::to_string(n)).in;
      if (n % 2 == 0) shares.asked(number);
    }
    const auto before = shares.compared();
    for (int n = 0; n < 1000; ++n) {
      EXPECT_NE(shares.enter("10.1." + std::to_string(n)).out, 0u) << "everything is taken";
    }
    return static_cast<double>(shares.compared() - before) / 1000;
  };
  const double of_few = work(100), of_many = work(16'000);
  EXPECT_GT(of_few, 0);
  EXPECT_LT(of_many, 3 * of_few);
}

// Whoever comes and goes in whatever order.
TEST(ConnectionShares, NobodyWhoHoldsLittleIsClosedForWhoeverHoldsMuch) {
  EXPECT_TRUE(rc::check([] {
    const auto all = *rc::gen::inRange<std::size_t>(1, 24);
    ConnectionShares shares(all);
    std::map<ConnectionShares::Number, std::pair<std::string, bool>> open;  // asked: true
    const auto of = [&](const std::string& address, bool silent_alone) {
      std::size_t count = 0;
      for (const auto& [number, what] : open)
        count += what.first == address && !(silent_alone && what.second) ? 1 : 0;
      return count;
    };
    for (const int act : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 1000))) {
      if (act % 10 < 6) {
        const std::string address(1, static_cast<char>('a' + act / 10 % 4 * (act % 3)));
        bool any_silent = false;
        for (const auto& [number, what] : open) any_silent |= !what.second;
        const std::size_t held = of(address, false);
        const auto entry = shares.enter(address);
        if (entry.out != 0) {
          const auto [victim, asked] = open.at(entry.out);
          // The share, or everything, was taken.
          RC_ASSERT(held == shares.share() || open.size() == all);
          if (held == shares.share()) RC_ASSERT(victim == address && !asked);
          if (asked) RC_ASSERT(!any_silent && of(victim, false) > held + 1);
          if (!asked)
            for (const auto& [number, what] : open) {
              if (what.second) continue;
              RC_ASSERT(held == shares.share() || of(what.first, true) <= of(victim, true));
              RC_ASSERT(what.first != victim || number >= entry.out);
            }
          open.erase(entry.out);
        }
        if (entry.in == 0) {
          RC_ASSERT(held == shares.share() || open.size() == all);
          RC_ASSERT(of(address, true) == 0u);
        } else {
          open[entry.in] = {address, false};
        }
      } else if (!open.empty()) {
        auto one = open.begin();
        std::advance(one, static_cast<std::size_t>(act / 10) % open.size());
        if (act % 10 < 8) {
          shares.asked(one->first);
          one->second.second = true;
        } else {
          shares.leave(one->first);
          open.erase(one);
        }
      }
      RC_ASSERT(shares.open() == open.size());
      RC_ASSERT(open.size() <= all);
    }
  }));
}

}  // namespace
}  // namespace onggi::web::connection_shares_test
