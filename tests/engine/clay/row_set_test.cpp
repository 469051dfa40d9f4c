#include "engine/clay/row_set.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace onggi::row_set_test {
namespace {

std::vector<int> taken(RowSet rows) {
  std::vector<int> all;
  for (int j = rows.take(); j >= 0; j = rows.take()) all.push_back(j);
  return all;
}

TEST(RowSet, BeginsEmptyAndGivesItsRowsFromTheLowestUp) {
  RowSet rows(200);
  EXPECT_EQ(rows.take(), -1);
  for (const int j : {199, 0, 63, 64, 130}) rows.add(j);
  EXPECT_EQ(taken(rows), (std::vector<int>{0, 63, 64, 130, 199}));
  EXPECT_EQ(rows.room(), 256);
}

TEST(RowSet, TakesNothingBelowWhereItIsAskedToBegin) {
  RowSet rows(200);
  for (const int j : {3, 64, 199}) rows.add(j);
  EXPECT_EQ(rows.take(4), 64);
  EXPECT_EQ(rows.take(64), 199);
  EXPECT_EQ(rows.take(200), -1);
  EXPECT_EQ(rows.take(256), -1);
  EXPECT_EQ(taken(rows), std::vector<int>{3});
}

TEST(RowSet, WithoutRoomHasNothingToTake) {
  RowSet none;
  EXPECT_EQ(none.room(), 0);
  EXPECT_EQ(none.take(), -1);
}

RC_GTEST_PROP(RowSet, IsWhatASetOfNumbersIs, ()) {
  constexpr int kRows = 150;
  RowSet rows(kRows);
  std::set<int> numbers;
  const auto steps = *rc::gen::container<std::vector<std::pair<int, int>>>(
      rc::gen::pair(rc::gen::inRange(0, 5), rc::gen::inRange(0, kRows)));
  for (const auto& [what, j] : steps) {
    if (what == 0) rows.add(j), numbers.insert(j);
    if (what == 1) rows.remove(j), numbers.erase(j);
    if (what == 2) {
      const auto next = numbers.lower_bound(j);
      RC_ASSERT(rows.take(j) == (next == numbers.end() ? -1 : *next));
      if (next != numbers.end()) numbers.erase(next);
    }
    if (what == 3) {  // the row, the next but one, and the last of 64 where it is there
      std::uint64_t which = 0;
      for (const int k : {0, 2, 63})
        if (j + k < kRows) which |= std::uint64_t{1} << k, numbers.insert(j + k);
      rows.add(j, which);
    }
    if (what == 4) {
      RowSet more(kRows);
      more.add(j);
      rows.add(more), numbers.insert(j);
    }
    for (int n = 0; n < kRows; ++n) RC_ASSERT(rows.has(n) == numbers.contains(n));
  }
  rows.clear();
  RC_ASSERT(rows.take() == -1);
}

TEST(RowSet, ItsHashTellsWhichRowsAreInIt) {
  const auto hash_with = [](int j) {
    RowSet rows(100);
    rows.add(j);
    StateHash hash;
    rows.add_to(hash);
    return hash.value();
  };
  EXPECT_EQ(hash_with(70), hash_with(70));
  EXPECT_NE(hash_with(70), hash_with(71));
}

RC_GTEST_PROP(RowSetProperty, OpensAndClosesPlacesAsASetOfNumbersDoes, ()) {
  constexpr int kRows = 150;
  RowSet rows(kRows);
  std::vector<bool> model(static_cast<std::size_t>(rows.room()));
  for (const int what : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 4))) {
    const int j = *rc::gen::inRange(0, kRows);
    if (what == 0) {
      rows.add(j);
      model[static_cast<std::size_t>(j)] = true;
    } else if (what == 1) {
      rows.open(j);
      model.insert(model.begin() + j, false);
      model.pop_back();
    } else if (what == 2) {
      rows.close(j);
      model.erase(model.begin() + j);
      model.push_back(false);
    } else {
      const int end = *rc::gen::inRange(j, kRows + 1);
      rows.add_range(j, end);
      std::fill(model.begin() + j, model.begin() + end, true);
    }
    for (int k = 0; k < rows.room(); ++k)
      RC_ASSERT(rows.has(k) == model[static_cast<std::size_t>(k)]);
    RC_ASSERT(rows.empty() == (std::find(model.begin(), model.end(), true) == model.end()));
  }
}

}  // namespace
}  // namespace onggi::row_set_test
