#include "kiosk/keepsake/store/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "kiosk/keepsake/store/store_thread.h"
#include "tests/kiosk/keepsake/store/visits.h"

namespace onggi::store::statistics_test {
namespace {

/// Counts visits by hand, in another way than the store does.
struct Tally {
  Cell all;
  std::int64_t brief = 0, pots = 0;
  double throwing_s = 0.0;
  std::vector<double> times;
  std::map<std::string, std::map<std::string, Cell>> tables;

  static void add(Cell& cell, const VisitRecord& v) {
    ++cell.visits;
    cell.kept += v.kept ? 1 : 0;
    cell.active_s += v.active_s;
    cell.judged += v.likeness ? 1 : 0;
    cell.likeness += v.likeness.value_or(0.0);
  }
  void count(const VisitRecord& v) {
    if (v.active_s < 3.0) {
      ++brief;
      return;
    }
    add(all, v);
    pots += v.pots;
    throwing_s += v.throwing_s;
    times.push_back(v.active_s);
    const std::string hour = (v.hour < 10 ? "0" : "") + std::to_string(v.hour);
    const std::string month = v.day.substr(0, 7);
    for (const auto& [table, name] :
         {std::pair<const char*, const std::string&>{"vessel", v.vessel},
          {"mission", v.mission},
          {"reached", v.reached},
          {"left", v.left},
          {"ended", v.ended},
          {"language", v.language},
          {"way", v.way},
          {"month", month},
          {"day", v.day},
          {"hour", hour}})
      add(tables[table][name], v);
  }
};

void expect_alike(const Statistics& found, Tally& by_hand) {
  EXPECT_EQ(found.all, by_hand.all);
  EXPECT_EQ(found.brief, by_hand.brief);
  EXPECT_EQ(found.pots, by_hand.pots);
  EXPECT_EQ(found.throwing_s, by_hand.throwing_s);
  std::sort(by_hand.times.begin(), by_hand.times.end());
  const std::size_t n = by_hand.times.size();
  ASSERT_GT(n, 0u);
  EXPECT_EQ(found.median_s, 0.5 * (by_hand.times[(n - 1) / 2] + by_hand.times[n / 2]));
  EXPECT_EQ(found.tables.size(), by_hand.tables.size());
  for (const Table& table : found.tables) {
    auto& expected = by_hand.tables.at(table.name);
    EXPECT_EQ(table.cells.size(), expected.size()) << table.name;
    for (const Cell& cell : table.cells) {
      expected[cell.name].name = cell.name;
      EXPECT_EQ(cell, expected[cell.name]) << table.name << ' ' << cell.name;
    }
    const bool in_order = table.name == "month" || table.name == "day" || table.name == "hour";
    for (std::size_t k = 1; k < table.cells.size(); ++k)
      EXPECT_TRUE(in_order ? table.cells[k - 1].name < table.cells[k].name
                           : table.cells[k - 1].visits >= table.cells[k].visits);
  }
}

// Times and likeness are quarters, so that sums are exact in any order. ONGGI_VISITS makes it more.
TEST(Statistics, OfManyScriptedVisitsEveryFigureIsExactlyWhatIsCountedByHand) {
  const char* asked = std::getenv("ONGGI_VISITS");
  const int number = asked != nullptr ? std::atoi(asked) : 10'000;
  const StoreFolder folder;
  const auto visits = scripted_visits(number, 11);
  {
    StoreThread store(folder.file(), 0);
    for (const VisitRecord& visit : visits) store.visit(visit);
    store.finish();
    EXPECT_TRUE(store.remarks().empty());
  }
  for (const auto& [from, to] :
       {std::pair{"", ""}, {"2026-05-08", "2026-05-14"}, {"2026-05-20", ""}, {"", "2026-05-01"}}) {
    Tally tally;
    for (const VisitRecord& visit : visits)
      if (visit.day >= from && (*to == '\0' || visit.day <= to)) tally.count(visit);
    const auto found = read_statistics(folder.file().string(), from, to);
    ASSERT_TRUE(found) << found.error().what;
    expect_alike(*found, tally);
  }
}

TEST(Statistics, OfAStoreThatIsBeingWrittenAreThoseOfOneOfItsMoments) {
  const StoreFolder folder;
  StoreThread store(folder.file(), 0);
  const auto visits = scripted_visits(400, 12);
  std::int64_t before = 0;
  for (int n = 0; n < 400; ++n) {
    store.visit(visits[static_cast<std::size_t>(n)]);
    if (n % 100 != 99) continue;
    store.finish();
    const auto found = read_statistics(folder.file().string(), "", "");
    ASSERT_TRUE(found) << found.error().what;
    EXPECT_EQ(found->all.visits + found->brief, n + 1);
    EXPECT_GE(found->all.visits, before);
    before = found->all.visits;
  }
}

TEST(Statistics, OfANewerOnggisStoreAreRefusedInOneWord) {
  const StoreFolder folder;
  {
    Database newer = Database::open(folder.file(), Database::Mode::own);
    ASSERT_TRUE(newer.run("CREATE TABLE visits (other); PRAGMA user_version=99"));
  }
  const auto found = read_statistics(folder.file().string(), "", "");
  ASSERT_FALSE(found);
  EXPECT_NE(found.error().what.find("newer onggi"), std::string::npos) << found.error().what;
  EXPECT_EQ(found.error().exit_code, 2);
}

TEST(Statistics, OfNoStoreOrOfSomethingElseAreRefusedWithARemedy) {
  const StoreFolder folder;
  const auto none = read_statistics(folder.file().string(), "", "");
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().exit_code, 2);
  EXPECT_NE(none.error().remedy.find("--store"), std::string::npos);
  std::ofstream(folder.file()) << std::string(9000, 'x');
  const auto other = read_statistics(folder.file().string(), "", "");
  ASSERT_FALSE(other);
  EXPECT_NE(other.error().what.find("cannot read it as a store"), std::string::npos);
}

TEST(Statistics, OfDaysWithoutVisitsAreNoughts) {
  const StoreFolder folder;
  {
    StoreThread store(folder.file(), 0);
    store.visit(scripted_visits(1, 13)[0]);
  }
  const auto found = read_statistics(folder.file().string(), "2031-01-01", "2031-12-31");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->all, Cell{});
  EXPECT_FALSE(found->median_s);
  for (const Table& table : found->tables) EXPECT_TRUE(table.cells.empty());
}

TEST(StatisticsOfAFile, WithoutAFolderForTemporaryFilesThatIsTold) {
  const StoreFolder folder;
  std::vector<Problem> remarks;
  ASSERT_TRUE(VisitStore::open(folder.file(), "then", remarks));
  const char* before = std::getenv("TMPDIR");
  const std::string kept = before != nullptr ? before : "";
  ::setenv("TMPDIR", "/nowhere/at/all", 1);
  const auto told = read_statistics(folder.file().string(), "", "");
  before != nullptr ? ::setenv("TMPDIR", kept.c_str(), 1) : ::unsetenv("TMPDIR");
  ASSERT_FALSE(told);
  EXPECT_NE(told.error().remedy.find("TMPDIR"), std::string::npos);
}

}  // namespace
}  // namespace onggi::store::statistics_test
