#include "kiosk/keepsake/store/store_thread.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "kiosk/ground/files/local_time.h"
#include "kiosk/keepsake/souvenir/fetch_note.h"
#include "kiosk/keepsake/store/statistics.h"
#include "tests/kiosk/keepsake/store/visits.h"

namespace fs = std::filesystem;

namespace onggi::store::store_thread_test {
namespace {

TEST(StoreThread, WhatWasHandedOverLastIsOnTheDiskWhenItHasEnded) {
  const StoreFolder folder;
  for (int n = 0; n < 5; ++n) {
    StoreThread store(folder.file(), 0);
    for (const VisitRecord& visit : scripted_visits(7, 20)) store.visit(visit);
  }
  const auto found = read_statistics(folder.file().string(), "", "");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->all.visits + found->brief, 35);
}

TEST(StoreThread, WhatPhonesFetchedIsTakenUpOnceEachAtTheStartMeanwhileAndAtTheEnd) {
  const StoreFolder folder;
  const fs::path notes = folder.path() / "phone/fetched";
  const auto id = [](char c) { return std::string(26, c); };
  const auto leave = [&](char c, const char* day) {
    EXPECT_TRUE(souvenir::leave_fetch_note(notes, {id(c), day}));
  };
  const auto counted = [&] {
    const auto found = read_statistics(folder.file().string(), "2026-05-01", "2026-05-02");
    return found ? found->fetched : -1;
  };
  leave('a', "2026-05-01");
  leave('b', "2026-04-30");
  {
    StoreThread store(folder.file(), 0, StoreThread::kDaily, notes, std::chrono::milliseconds(20));
    store.finish();
    EXPECT_EQ(counted(), 1) << "the other is of another day";
    EXPECT_TRUE(souvenir::fetch_notes(notes, 9).empty());
    leave('c', "2026-05-02");
    for (int n = 0; n < 1000 && !souvenir::fetch_notes(notes, 9).empty(); ++n)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_EQ(counted(), 2);
    leave('a', "2026-05-02");  // opened again, or not removed when it was counted
  }
  EXPECT_EQ(counted(), 2);
  EXPECT_TRUE(souvenir::fetch_notes(notes, 9).empty());
  leave('d', "2026-05-02");
  {
    // Nothing is taken up before it is on the disk.
    std::ofstream(folder.path() / "away") << "a file where a folder is wanted";
    StoreThread store(folder.path() / "away/onggi.sqlite", 0, StoreThread::kDaily, notes);
  }
  EXPECT_EQ(souvenir::fetch_notes(notes, 9).size(), 1u);
  // Years later all of it is forgotten.
  { StoreThread store(folder.file(), 1, StoreThread::kDaily, notes); }
  const auto left = read_statistics(folder.file().string(), "", "");
  ASSERT_TRUE(left);
  EXPECT_EQ(left->fetched, 1) << "taken up after the forgetting of the start";
}

TEST(StoreThread, ADamagedFileIsSaidInOneLineAndCountingGoesOn) {
  const StoreFolder folder;
  std::ofstream(folder.file()) << std::string(20'000, 'x');
  StoreThread store(folder.file(), 0);
  for (const VisitRecord& visit : scripted_visits(9, 21)) {
    store.visit(visit);
    store.finish();
  }
  const auto remarks = store.remarks();
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_NE(remarks[0].what.find("set aside"), std::string::npos);
  EXPECT_EQ(folder.files_with("damaged"), 1);
  const auto found = read_statistics(folder.file().string(), "", "");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->all.visits + found->brief, 9);
}

TEST(StoreThread, WhatTheDiskDoesNotTakeIsSaidOnceAndCountedWhenItTakesItAgain) {
  const StoreFolder folder;
  const fs::path away = folder.path() / "away";
  std::ofstream(away) << "a file where a folder is wanted";
  StoreThread store(away / "onggi.sqlite", 0);
  const auto visits = scripted_visits(6, 22);
  for (int n = 0; n < 5; ++n) {
    store.visit(visits[static_cast<std::size_t>(n)]);
    store.finish();
  }
  EXPECT_EQ(store.remarks().size(), 1u);
  fs::remove(away);
  store.visit(visits[5]);
  store.finish();
  EXPECT_TRUE(store.remarks().empty());
  const auto found = read_statistics((away / "onggi.sqlite").string(), "", "");
  ASSERT_TRUE(found) << found.error().what;
  EXPECT_EQ(found->all.visits + found->brief, 6);
}

TEST(StoreThread, WhatTheDiskDidNotTakeIsTriedOnceMoreAtTheEndAndWhatIsLostThenIsSaid) {
  for (const bool room : {true, false}) {
    const StoreFolder folder;
    const fs::path away = folder.path() / "away";
    std::ofstream(away) << "a file where a folder is wanted";
    StoreThread store(away / "onggi.sqlite", 0);
    for (const VisitRecord& visit : scripted_visits(6, 27)) store.visit(visit);
    store.finish();
    EXPECT_EQ(store.remarks().size(), 1u);
    if (room) fs::remove(away);
    store.end();
    const auto remarks = store.remarks();
    const auto found = read_statistics((away / "onggi.sqlite").string(), "", "");
    if (room) {
      EXPECT_TRUE(remarks.empty());
      ASSERT_TRUE(found) << found.error().what;
      EXPECT_EQ(found->all.visits + found->brief, 6);
    } else {
      EXPECT_FALSE(found);
      ASSERT_EQ(remarks.size(), 1u);
      EXPECT_NE(remarks[0].what.find("6 visits"), std::string::npos) << remarks[0].what;
    }
  }
}

// An index that leads nowhere: the check of the file does not look, and taking a row away does.
TEST(StoreThread, AFileThatTurnsOutDamagedWhileOldVisitsAreForgottenIsSetAside) {
  const StoreFolder folder;
  VisitRecord old = scripted_visits(1, 28)[0];
  old.day = "2001-01-01";
  {
    StoreThread store(folder.file(), 0);
    store.visit(old);
  }
  {
    Database database = Database::open(folder.file(), Database::Mode::own);
    ASSERT_TRUE(database.run(
        "CREATE INDEX i ON visits(start); PRAGMA writable_schema=ON; "
        "UPDATE sqlite_master SET sql='CREATE INDEX i ON visits(hour)' WHERE name='i'"));
  }
  StoreThread store(folder.file(), 12);
  store.finish();
  const auto remarks = store.remarks();
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_NE(remarks[0].what.find("is set aside as"), std::string::npos) << remarks[0].what;
  EXPECT_EQ(folder.files_with("damaged"), 1);
}

// A check of this file finds nothing, and the next row does (visit_store_test.cpp).
TEST(StoreThread, AFileThatTurnsOutDamagedWhileItIsWrittenIsReplacedAndTheVisitIsCounted) {
  const StoreFolder folder;
  const auto visits = scripted_visits(6, 25);
  {
    StoreThread store(folder.file(), 0);
    store.visit(visits[0]);
  }
  {
    Database database = Database::open(folder.file(), Database::Mode::own);
    ASSERT_TRUE(
        database.run("PRAGMA writable_schema=ON; UPDATE sqlite_master SET sql='CREATE TABLE "
                     "sqlite_sequence(name,seq,more)' WHERE name='sqlite_sequence'"));
  }
  StoreThread store(folder.file(), 0);
  for (std::size_t n = 1; n < visits.size(); ++n) {
    store.visit(visits[n]);
    store.finish();
  }
  const auto remarks = store.remarks();
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_NE(remarks[0].what.find("set aside"), std::string::npos);
  EXPECT_EQ(folder.files_with("damaged"), 1);
  const auto found = read_statistics(folder.file().string(), "", "");
  ASSERT_TRUE(found) << found.error().what;
  EXPECT_EQ(found->all.visits + found->brief, 5);
}

TEST(StoreThread, OfMoreVisitsThanItHoldsTheOldestGoAndThatIsSaidOnceAndTheirNumberAtTheEnd) {
  const StoreFolder folder;
  const fs::path away = folder.path() / "away";
  std::ofstream(away) << "a file where a folder is wanted";
  StoreThread store(away / "onggi.sqlite", 0);
  const auto visits = scripted_visits(static_cast<int>(StoreThread::kMost), 26, 1);
  for (const VisitRecord& visit : visits) store.visit(visit);
  store.finish();
  EXPECT_EQ(store.remarks().size(), 1u);
  VisitRecord last = visits[0];
  last.day = "2026-06-01";
  last.active_s = 100.0;
  for (int n = 0; n < 3; ++n) {
    store.visit(last);
    store.finish();
  }
  const auto full = store.remarks();
  ASSERT_EQ(full.size(), 1u);
  EXPECT_NE(full[0].what.find("the oldest are dropped"), std::string::npos);
  fs::remove(away);
  store.visit(last);
  store.finish();
  const auto again = store.remarks();
  ASSERT_EQ(again.size(), 1u);
  EXPECT_NE(again[0].what.find("; 3 that"), std::string::npos) << again[0].what;
  const auto found = read_statistics((away / "onggi.sqlite").string(), "", "");
  ASSERT_TRUE(found) << found.error().what;
  EXPECT_EQ(found->all.visits + found->brief, static_cast<std::int64_t>(StoreThread::kMost) + 1);
  EXPECT_EQ(found->tables.at(7).cells.back().visits, 4) << "the last ones are all there";
}

TEST(StoreThread, WhatIsOlderThanItsMonthsIsForgottenAtTheStartAndDailyFromThenOn) {
  const StoreFolder folder;
  VisitRecord old = scripted_visits(1, 23)[0], young = old;
  old.day = "2001-01-01";
  young.day = "2999-01-01";
  old.active_s = young.active_s = 100.0;
  const fs::path aside = folder.file().string() + ".damaged-2001-01-01_120000";
  {
    StoreThread store(folder.file(), 0);
    store.visit(old);
    store.visit(young);
  }
  std::ofstream(aside) << "x";
  const auto visits = [&folder] {
    const auto found = read_statistics(folder.file().string(), "", "");
    return found ? found->all.visits : -1;
  };
  EXPECT_EQ(visits(), 2);
  {
    StoreThread store(folder.file(), 12);
    store.finish();
    EXPECT_EQ(visits(), 1);
    EXPECT_FALSE(fs::exists(aside));
  }
  StoreThread store(folder.file(), 12, std::chrono::milliseconds(20));
  store.finish();
  store.visit(old);
  std::ofstream(aside) << "x";
  for (int n = 0; n < 200 && (visits() != 1 || fs::exists(aside)); ++n)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(visits(), 1);
  EXPECT_FALSE(fs::exists(aside));
  EXPECT_TRUE(store.remarks().empty());
}

TEST(StoreThread, AFileThatIsTakenAwayIsSaidAndCountingBeginsAnewAtOnce) {
  const StoreFolder folder;
  {
    StoreThread store(folder.file(), 0);
    const auto count = [&](unsigned seed) {
      for (const VisitRecord& one : scripted_visits(3, seed)) store.visit(one);
      store.finish();
    };
    count(1);
    EXPECT_TRUE(store.remarks().empty());
    std::filesystem::remove_all(folder.path());
    count(2);
    const std::vector<Problem> said = store.remarks();
    ASSERT_EQ(said.size(), 1u);
    EXPECT_NE(said[0].what.find("was removed"), std::string::npos);
    count(3);
    EXPECT_TRUE(store.remarks().empty());
  }
  Database database = Database::open(folder.file(), Database::Mode::read);
  EXPECT_EQ(database.number("SELECT count(*) FROM visits"), 6);
}

// Ten years ahead by mistake, and set right within the day.
TEST(StoreThread, AClockThatLeaptYearsAheadForgetsNothingUntilItHasGoneOnForADay) {
  const StoreFolder folder;
  const auto visit_of = [](std::time_t ago) {
    VisitRecord visit = scripted_visits(1, 5)[0];
    visit.start = std::time(nullptr) - ago;
    visit.day = files::local_time(visit.start, files::kDay);
    return visit;
  };
  constexpr std::time_t kDay = 86400;
  const auto counted_after = [&](std::initializer_list<std::time_t> days_ago) {
    {
      StoreThread store(folder.file(), 0);
      for (const std::time_t days : days_ago) store.visit(visit_of(days * kDay));
    }
    StoreThread(folder.file(), 12).finish();
    Database database = Database::open(folder.file(), Database::Mode::read);
    return database.number("SELECT count(*) FROM visits").value_or(-1);
  };
  EXPECT_EQ(counted_after({400, 401}), 2);
  EXPECT_EQ(counted_after({0}), 3) << "the first visit since";
  EXPECT_EQ(counted_after({2}), 2) << "now the clock is believed";
}

}  // namespace
}  // namespace onggi::store::store_thread_test
