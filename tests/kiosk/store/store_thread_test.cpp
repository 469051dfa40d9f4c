#include "kiosk/store/store_thread.h"

#include <gtest/gtest.h>

#include <ctime>

#include "kiosk/store/statistics.h"
#include "tests/kiosk/store/visits.h"

namespace fs = std::filesystem;

namespace onggi::store {
namespace {

TEST(StoreThread, WhatWasHandedOverLastIsOnTheDiskWhenItHasEnded) {
  const StoreFolder folder;
  for (int n = 0; n < 5; ++n) {
    StoreThread store(folder.file(), 0);
    for (const VisitRecord& visit : scripted_visits(7, 20)) store.visit(visit);
    const std::string name = "k" + std::to_string(n);
    fs::create_directory(folder.path() / name);
    std::ofstream(folder.path() / name / "pot.glb") << std::string(1000, 'x');
    store.keepsake({name, 0, 2, 0, ""});
  }
  const auto found = read_statistics(folder.file().string(), "", "");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->all.visits + found->brief, 35);
  Database database = Database::open(folder.file(), Database::Mode::read);
  EXPECT_EQ(database.number("SELECT sum(bytes) FROM keepsakes"), 5000);
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

TEST(StoreThread, AKeepsakeThatExpiredIsRemovedAndNoOtherFolderEverIs) {
  const StoreFolder folder;
  for (const char* name : {"old", "new", "for_ever", "not_noted", "gone"})
    fs::create_directory(folder.path() / name);
  fs::create_directory(folder.path().parent_path() /
                       (folder.path().filename().string() + "-beside"));
  const std::string outside = "../" + folder.path().filename().string() + "-beside";
  const std::int64_t now = std::time(nullptr);
  {
    StoreThread store(folder.file(), 0);
    store.keepsake({"old", 1, now - 100, now - 1, ""});
    store.keepsake({"new", 1, now - 100, now + 1000, ""});
    store.keepsake({"for_ever", 1, 1, 0, ""});
    store.keepsake({"gone", 1, now, 0, ""});
    store.keepsake({outside, 1, 1, 2, ""});
    store.keepsake({".", 1, 1, 2, ""});
    store.finish();
    fs::remove(folder.path() / "gone");
    store.visit(scripted_visits(1, 24)[0]);
    store.finish();
    EXPECT_TRUE(store.remarks().empty());
  }
  EXPECT_FALSE(fs::exists(folder.path() / "old"));
  for (const char* name : {"new", "for_ever", "not_noted"})
    EXPECT_TRUE(fs::exists(folder.path() / name)) << name;
  EXPECT_TRUE(fs::exists(folder.path() / outside));
  fs::remove(folder.path() / outside);
  Database database = Database::open(folder.file(), Database::Mode::read);
  EXPECT_EQ(database.number("SELECT count(*) FROM keepsakes WHERE name IN ('old', 'gone')"), 0);
  EXPECT_EQ(database.number("SELECT count(*) FROM keepsakes WHERE name IN ('new', 'for_ever')"), 2);
}

TEST(StoreThread, VisitsOlderThanItsMonthsAreForgottenWhenItOpens) {
  const StoreFolder folder;
  VisitRecord old = scripted_visits(1, 23)[0];
  old.day = "2001-01-01";
  old.active_s = 100.0;
  { StoreThread(folder.file(), 0).visit(old); }
  EXPECT_EQ(read_statistics(folder.file().string(), "", "")->all.visits, 1);
  old.day = "2999-01-01";
  { StoreThread(folder.file(), 12).visit(old); }
  const auto found = read_statistics(folder.file().string(), "", "");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->all.visits, 1);
  EXPECT_EQ(found->tables.at(7).cells.at(0).name, "2999-01-01");
}

}  // namespace
}  // namespace onggi::store
