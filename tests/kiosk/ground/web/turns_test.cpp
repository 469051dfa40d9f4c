#include "kiosk/ground/web/turns.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <string>
#include <vector>

namespace onggi::web::turns_test {
namespace {

TEST(Turns, AnAddressWithMuchWorkMakesAnotherWaitForOnePiece) {
  Turns turns;
  std::vector<std::string> done;
  for (int n = 0; n < 8000; ++n) turns.add("crowd", [&done] { done.push_back("crowd"); });
  for (int n = 0; n < 100; ++n) turns.next();
  done.clear();
  turns.add("visitor", [&done] { done.push_back("visitor"); });
  turns.next();
  turns.next();
  EXPECT_EQ(done, (std::vector<std::string>{"crowd", "visitor"}));
}

TEST(Turns, WhoeverHasWorkWaitsForAtMostOnePieceOfEachOtherAndOwnWorkKeepsItsOrder) {
  std::mt19937 chance(7);
  for (int round = 0; round < 200; ++round) {
    Turns turns;
    std::map<std::string, std::vector<int>> added, done;
    std::map<std::string, int> since;  // pieces of others since an address had or got work
    const int addresses = 1 + static_cast<int>(chance() % 6);
    int number = 0;
    const auto add = [&] {
      const std::string address(1 + chance() % static_cast<unsigned>(addresses), 'a');
      if (added[address].size() == done[address].size()) since[address] = 0;
      added[address].push_back(++number);
      turns.add(address, [&, address, own = number] {
        done[address].push_back(own);
        EXPECT_LT(since[address], addresses) << address;
        since[address] = 0;
        for (auto& [other, pieces] : since)
          if (other != address && added[other].size() > done[other].size()) ++pieces;
      });
    };
    for (int n = 0; n < 300; ++n) {
      if (chance() % 2 == 0)
        add();
      else
        turns.next();
    }
    while (!turns.empty()) turns.next();
    EXPECT_EQ(added, done);
  }
}

TEST(Turns, WorkMayAddWorkAndItComesAfterThatOfOthers) {
  Turns turns;
  std::string done;
  turns.add("a", [&] {
    done += "a";
    turns.add("a", [&] { done += "A"; });
  });
  turns.add("b", [&] { done += "b"; });
  while (!turns.empty()) turns.next();
  EXPECT_EQ(done, "abA");
  turns.next();
}

}  // namespace
}  // namespace onggi::web::turns_test
