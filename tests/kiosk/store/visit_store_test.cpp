#include "kiosk/store/visit_store.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "kiosk/store/migrations.h"
#include "tests/kiosk/store/visits.h"

namespace fs = std::filesystem;

namespace onggi::store {
namespace {

VisitStore open(const fs::path& file) {
  std::vector<Problem> remarks;
  auto opened = VisitStore::open(file, "then", remarks);
  EXPECT_TRUE(opened) << opened.error().what;
  EXPECT_TRUE(remarks.empty());
  return std::move(*opened);
}

std::int64_t count(const fs::path& file, const std::string& sql) {
  Database database = Database::open(file, Database::Mode::read);
  return database.number(sql).value_or(-1);
}

TEST(VisitStore, AVisitAndWhatAHubIsToldOfItAreKeptTogetherAndComeBackAfterTheEnd) {
  const StoreFolder folder;
  const auto visits = scripted_visits(50, 1);
  std::string epoch;
  {
    VisitStore store = open(folder.file());
    ASSERT_TRUE(store.add(visits));
    epoch = store.epoch().value();
    EXPECT_EQ(epoch.size(), 32u);
  }
  VisitStore store = open(folder.file());
  EXPECT_EQ(store.epoch().value(), epoch);
  const auto rows = store.outbox(1000).value();
  ASSERT_EQ(rows.size(), visits.size());
  for (std::size_t n = 0; n < rows.size(); ++n) {
    const auto body = nlohmann::json::parse(rows[n].body);
    EXPECT_EQ(body.at("vessel"), visits[n].vessel);
    EXPECT_EQ(body.at("active_s"), visits[n].active_s);
    EXPECT_EQ(body.at("likeness").is_null(), !visits[n].likeness.has_value());
    EXPECT_EQ(body.at("start").get<std::int64_t>() % 900, 0) << "no moment, a quarter of an hour";
    EXPECT_LE(body.at("start").get<std::int64_t>(), visits[n].start);
    EXPECT_GT(body.at("start").get<std::int64_t>(), visits[n].start - 900);
  }
  ASSERT_TRUE(store.acknowledged(rows[29].seq));
  EXPECT_EQ(store.outbox(1000).value().size(), 20u);
  ASSERT_TRUE(store.acknowledged(rows[49].seq));
  ASSERT_TRUE(store.add(std::span(visits).first(1)));
  EXPECT_GT(store.outbox(1).value().at(0).seq, rows[49].seq) << "a number is never used twice";
}

TEST(VisitStore, NothingInItSaysWhoItWas) {
  const StoreFolder folder;
  { VisitStore store = open(folder.file()); }
  Database database = Database::open(folder.file(), Database::Mode::read);
  std::set<std::string> columns;
  Statement rows(database, "SELECT name FROM pragma_table_info('visits')");
  while (rows.step()) columns.insert(rows.text(0));
  EXPECT_EQ(columns, (std::set<std::string>{"seq", "start", "day", "hour", "vessel", "scene",
                                            "language", "way", "reached", "left_at", "ended",
                                            "active_s", "throwing_s", "pots", "likeness", "kept"}))
      << "a further one is a decision: see kiosk/docs/store.md";
}

TEST(VisitStore, AFileOfEveryFormerVersionIsBroughtForwardWithItsRows) {
  for (int version = 1; version <= newest_version(); ++version) {
    const StoreFolder folder;
    {
      Database old = Database::open(folder.file(), Database::Mode::own);
      ASSERT_TRUE(migrate(old, version));
      ASSERT_TRUE(
          old.run("INSERT INTO visits VALUES (7, 900, '2026-05-01', 10, 'moon_jar', 's', 'ko', "
                  "'touch', 'result', 'throw', 'idle', 61.5, 30, 2, 88.25, 1);"
                  "INSERT INTO outbox VALUES (9, 'visit', '{}')"));
      if (version >= 2) {
        ASSERT_TRUE(old.run("INSERT INTO keepsakes VALUES ('a', 10, 5, 0, 'ff')"));
      }
      if (version >= 3) {
        ASSERT_TRUE(old.run("INSERT INTO settings VALUES ('k', 'v')"));
      }
      ASSERT_EQ(old.number("PRAGMA user_version"), version);
    }
    {
      VisitStore store = open(folder.file());
      EXPECT_EQ(store.outbox(9).value().at(0).seq, 9);
      EXPECT_EQ(store.due(100, 1 << 20).value().size(), 0u);
      EXPECT_EQ(store.due(100, 9).value().size(), version >= 2 ? 1u : 0u);
      EXPECT_EQ(store.setting("k").value(), version >= 3 ? "v" : "");
      ASSERT_TRUE(store.add(scripted_visits(3, 2)));
      ASSERT_TRUE(store.set("k", "w"));
    }
    EXPECT_EQ(count(folder.file(), "PRAGMA user_version"), newest_version());
    EXPECT_EQ(count(folder.file(), "SELECT count(*) FROM visits"), 4);
    EXPECT_EQ(count(folder.file(), "SELECT 1 FROM visits WHERE seq = 7 AND likeness = 88.25"), 1);
    EXPECT_EQ(folder.files_with("damaged"), 0);
  }
}

TEST(VisitStore, AFileOfANewerOnggiIsLeftAsItIsAndSaid) {
  const StoreFolder folder;
  {
    VisitStore store = open(folder.file());
    ASSERT_TRUE(store.add(scripted_visits(3, 3)));
  }
  {
    Database newer = Database::open(folder.file(), Database::Mode::own);
    ASSERT_TRUE(newer.run("PRAGMA user_version=99"));
  }
  std::vector<Problem> remarks;
  const auto opened = VisitStore::open(folder.file(), "then", remarks);
  ASSERT_FALSE(opened);
  EXPECT_NE(opened.error().what.find("newer onggi"), std::string::npos);
  EXPECT_EQ(count(folder.file(), "SELECT count(*) FROM visits"), 3);
  EXPECT_EQ(folder.files_with("damaged"), 0);
}

// Cut at every 4 KiB, and with bytes turned over in it.
TEST(VisitStore, ADamagedFileIsSetAsideByNameAndANewOneCounts) {
  const StoreFolder whole;
  {
    VisitStore store = open(whole.file());
    ASSERT_TRUE(store.add(scripted_visits(200, 4)));
  }
  const auto size = fs::file_size(whole.file());
  ASSERT_GT(size, 40'000u);
  int aside = 0;
  for (std::uintmax_t cut = 0; cut < size; cut += 4096) {
    for (const bool torn : {false, true}) {
      const StoreFolder folder;
      fs::copy_file(whole.file(), folder.file());
      if (!torn) {
        fs::resize_file(folder.file(), cut);
      } else {
        std::fstream page(folder.file(), std::ios::in | std::ios::out | std::ios::binary);
        page.seekp(static_cast<std::streamoff>(cut));
        page << std::string(4096, '\x5a');
      }
      std::vector<Problem> remarks;
      auto opened = VisitStore::open(folder.file(), "then", remarks);
      ASSERT_TRUE(opened) << cut << ' ' << opened.error().what;
      ASSERT_TRUE(opened->add(scripted_visits(5, 5))) << cut;
      ASSERT_LE(remarks.size(), 1u);
      EXPECT_EQ(folder.files_with("onggi.sqlite.damaged-then"), static_cast<int>(remarks.size()));
      aside += static_cast<int>(remarks.size());
      if (remarks.empty()) continue;
      EXPECT_EQ(opened->outbox(100).value().size(), 5u);
      EXPECT_NE(remarks[0].what.find("set aside"), std::string::npos);
    }
  }
  // Cut to nothing it is an empty file, and that is a new one.
  EXPECT_GE(aside, static_cast<int>(2 * size / 4096 - 3));
}

TEST(VisitStore, AnotherOnggiThatHasItAndADiskThatTakesNothingAreSaidApart) {
  const StoreFolder folder;
  {
    VisitStore first = open(folder.file());
    std::vector<Problem> remarks;
    const auto second = VisitStore::open(folder.file(), "then", remarks);
    ASSERT_FALSE(second);
    EXPECT_NE(second.error().what.find("another onggi"), std::string::npos);
    EXPECT_EQ(folder.files_with("damaged"), 0);
    EXPECT_TRUE(first.add(scripted_visits(1, 6)));
  }
  const StoreFolder other;
  fs::create_directory(other.file());
  std::vector<Problem> remarks;
  const auto no_file = VisitStore::open(other.file(), "then", remarks);
  ASSERT_FALSE(no_file);
  EXPECT_EQ(no_file.error().exit_code, 1);
  EXPECT_NE(no_file.error().remedy.find("writable"), std::string::npos);
}

TEST(VisitStore, KeepsakesThatExpiredGoAndThenTheOldestUntilTheQuotaHolds) {
  const StoreFolder folder;
  VisitStore store = open(folder.file());
  for (const KeepsakeRecord& k : {KeepsakeRecord{"a", 100, 1000, 0, "1"},
                                  {"b", 100, 2000, 5000, "2"},
                                  {"c", 100, 3000, 9000, ""},
                                  {"d", 100, 4000, 0, "4"}})
    ASSERT_TRUE(store.keep(k));
  const auto names = [&store](std::int64_t now, std::int64_t quota) {
    std::string all;
    const std::vector<KeepsakeRecord> gone = store.due(now, quota).value();
    for (const KeepsakeRecord& k : gone) all += k.name;
    return all;
  };
  EXPECT_EQ(names(4999, 400), "");
  EXPECT_EQ(names(5000, 400), "b");
  EXPECT_EQ(names(5000, 300), "b") << "what has expired takes no room";
  EXPECT_EQ(names(4999, 399), "a");
  EXPECT_EQ(names(4999, 150), "abc");
  EXPECT_EQ(names(9000, 0), "abcd");
  ASSERT_TRUE(store.dropped("a"));
  EXPECT_EQ(names(4999, 0), "bcd");
}

TEST(VisitStore, OldVisitsAreForgottenAndWhatTheHubIsToldIsNot) {
  const StoreFolder folder;
  VisitStore store = open(folder.file());
  const auto visits = scripted_visits(300, 7);
  ASSERT_TRUE(store.add(visits));
  ASSERT_TRUE(store.forget_before("2026-05-15"));
  EXPECT_EQ(store.outbox(1000).value().size(), 300u);
  EXPECT_EQ(store.trouble(), Trouble::none);
}

TEST(VisitStore, ASettingOfTheMachineIsKeptUntilItIsSetAnew) {
  const StoreFolder folder;
  VisitStore store = open(folder.file());
  EXPECT_EQ(store.setting("touch_map").value(), "");
  ASSERT_TRUE(store.set("touch_map", "1"));
  ASSERT_TRUE(store.set("touch_map", "2"));
  EXPECT_EQ(store.setting("touch_map").value(), "2");
}

}  // namespace
}  // namespace onggi::store
