#include "kiosk/keepsake/store/visit_store.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <nlohmann/json.hpp>
#include <set>

#include "kiosk/keepsake/store/migrations.h"
#include "tests/kiosk/ground/files/disk.h"
#include "tests/kiosk/keepsake/store/visits.h"

namespace fs = std::filesystem;

namespace onggi::store::visit_store_test {
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

std::string epoch_of(const fs::path& file) {
  Database database = Database::open(file, Database::Mode::read);
  Statement row(database, "SELECT value FROM about WHERE key = 'epoch'");
  return row.step() ? row.text(0) : std::string();
}

/// All bytes of the store and of its log.
std::string bytes_of(const fs::path& file) {
  return files::test::content(file) + files::test::content(file.string() + "-wal");
}

TEST(VisitStore, AVisitComesBackAsItWasButForItsMomentAndItsNumberIsNeverUsedTwice) {
  const StoreFolder folder;
  const auto visits = scripted_visits(50, 1);
  {
    VisitStore store = open(folder.file());
    ASSERT_TRUE(store.add(visits));
  }
  const std::string epoch = epoch_of(folder.file());
  EXPECT_EQ(epoch.size(), 32u);
  {
    Database database = Database::open(folder.file(), Database::Mode::read);
    Statement row(database,
                  "SELECT start, day, hour, vessel, scene, language, way, reached, left_at, ended, "
                  "active_s, throwing_s, pots, likeness, kept, mission FROM visits ORDER BY seq");
    for (VisitRecord visit : visits) {
      ASSERT_TRUE(row.step());
      EXPECT_EQ(row.integer(0) % 900, 0) << "no moment, a quarter of an hour";
      EXPECT_LE(row.integer(0), visit.start);
      EXPECT_GT(row.integer(0), visit.start - 900);
      visit.start = row.integer(0);
      const VisitRecord found{row.integer(0),
                              row.text(1),
                              static_cast<int>(row.integer(2)),
                              row.text(3),
                              row.text(4),
                              row.text(5),
                              row.text(6),
                              row.text(7),
                              row.text(8),
                              row.text(9),
                              row.real(10),
                              row.real(11),
                              static_cast<int>(row.integer(12)),
                              row.null(13) ? std::nullopt : std::optional(row.real(13)),
                              row.integer(14) != 0,
                              row.text(15)};
      EXPECT_EQ(found, visit);
    }
    EXPECT_FALSE(row.step());
  }
  const auto last = count(folder.file(), "SELECT max(seq) FROM visits");
  {
    VisitStore store = open(folder.file());
    ASSERT_TRUE(store.forget_before("2027-01-01"));
    ASSERT_TRUE(store.add(std::span(visits).first(1)));
  }
  EXPECT_GT(count(folder.file(), "SELECT min(seq) FROM visits"), last);
  EXPECT_EQ(epoch_of(folder.file()), epoch) << "whoever reads on, reads on in the same numbers";
}

// Every table of the file: a copy beside the visits would outlive them.
TEST(VisitStore, NothingInItSaysWhoItWas) {
  const StoreFolder folder;
  {
    VisitStore store = open(folder.file());
    ASSERT_TRUE(store.add(scripted_visits(3, 3)));
  }
  Database database = Database::open(folder.file(), Database::Mode::read);
  std::set<std::string> columns;
  Statement rows(database,
                 "SELECT t.name || '.' || c.name FROM sqlite_master t, pragma_table_info(t.name) c "
                 "WHERE t.type = 'table'");
  while (rows.step()) columns.insert(rows.text(0));
  std::set<std::string> known{"about.key", "about.value", "sqlite_sequence.name",
                              "sqlite_sequence.seq"};
  for (const char* column :
       {"seq", "start", "day", "hour", "vessel", "scene", "language", "way", "reached", "left_at",
        "ended", "active_s", "throwing_s", "pots", "likeness", "kept", "mission"})
    known.insert(std::string("visits.") + column);
  // Not the visit's row, nor the keepsake's name: nobody finds out whose it was.
  known.insert({"fetches.id", "fetches.day"});
  EXPECT_EQ(columns, known) << "a further one is a decision: see kiosk/docs/store.md";
  EXPECT_EQ(count(folder.file(), "SELECT count(*) FROM about"), 1);
}

TEST(VisitStore, AFileOfEveryFormerVersionIsBroughtForwardWithItsRows) {
  for (int version = 1; version <= newest_version(); ++version) {
    const StoreFolder folder;
    {
      Database old = Database::open(folder.file(), Database::Mode::own);
      ASSERT_TRUE(migrate(old, version));
      ASSERT_TRUE(
          old.run("INSERT INTO visits VALUES (7, 900, '2026-05-01', 10, 'moon_jar', 's', 'ko', "
                  "'touch', 'result', 'throw', 'idle', 61.5, 30, 2, 88.25, 1" +
                  std::string(version < 6 ? ")" : ", 'litre_jar')")));
      if (version >= 5) {
        ASSERT_TRUE(old.run("INSERT INTO fetches VALUES ('an id', '2026-05-02')"));
      }
      if (version < 4) {
        ASSERT_TRUE(old.run("INSERT INTO outbox VALUES (9, 'visit', '{a second copy}')"));
      }
      if (version == 2 || version == 3) {
        ASSERT_TRUE(old.run("INSERT INTO keepsakes VALUES ('a', 10, 5, 0, 'ff')"));
      }
      if (version == 3) {
        ASSERT_TRUE(old.run("INSERT INTO settings VALUES ('k', 'v')"));
      }
      ASSERT_EQ(old.number("PRAGMA user_version"), version);
    }
    {
      VisitStore store = open(folder.file());
      ASSERT_TRUE(store.add(scripted_visits(3, 2)));
    }
    EXPECT_EQ(count(folder.file(), "PRAGMA user_version"), newest_version());
    EXPECT_EQ(count(folder.file(), "SELECT count(*) FROM visits"), 4);
    EXPECT_EQ(count(folder.file(), "SELECT count(*) FROM fetches"), version < 5 ? 0 : 1);
    EXPECT_EQ(count(folder.file(), "SELECT 1 FROM visits WHERE seq = 7 AND likeness = 88.25"), 1);
    EXPECT_EQ(count(folder.file(), "SELECT count(*) FROM visits WHERE seq = 7 AND mission = ''"),
              version < 6 ? 1 : 0)
        << "what was chosen before there were missions was none";
    EXPECT_EQ(folder.files_with("damaged"), 0);
    EXPECT_EQ(bytes_of(folder.file()).find("a second copy"), std::string::npos);
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
      EXPECT_NE(remarks[0].what.find("set aside"), std::string::npos);
    }
  }
  // Cut to nothing it is an empty file, and that is a new one.
  EXPECT_GE(aside, static_cast<int>(2 * size / 4096 - 3));
}

// What SQLite itself keeps of the rows' numbers is turned into something else: a check of the file
// finds nothing, and the next row does.
void damage_unseen(const fs::path& file) {
  Database database = Database::open(file, Database::Mode::own);
  ASSERT_TRUE(
      database.run("PRAGMA writable_schema=ON; UPDATE sqlite_master SET sql='CREATE TABLE "
                   "sqlite_sequence(name,seq,more)' WHERE name='sqlite_sequence'"));
}

TEST(VisitStore, DamageThatIsFoundWhileAVisitIsWrittenIsToldAsDamage) {
  const StoreFolder folder;
  {
    VisitStore store = open(folder.file());
    ASSERT_TRUE(store.add(scripted_visits(3, 3)));
  }
  damage_unseen(folder.file());
  VisitStore store = open(folder.file());
  ASSERT_FALSE(store.add(scripted_visits(3, 3)));
  EXPECT_EQ(store.trouble(), Trouble::damaged);
}

TEST(VisitStore, ATroubleThatPassesIsForgottenAndDamageIsNot) {
  const StoreFolder folder;
  Database database = Database::open(folder.file(), Database::Mode::own);
  EXPECT_FALSE(database.run("SELECT * FROM nothing"));
  EXPECT_TRUE(database.run("SELECT 1"));
  EXPECT_EQ(database.trouble(), Trouble::unfit) << "what succeeds afterwards mends nothing";
  EXPECT_NE(database.message().find("nothing"), std::string::npos);
  database.retry();
  EXPECT_EQ(database.trouble(), Trouble::none);
  ASSERT_TRUE(migrate(database));
  { const Database gone = std::move(database); }
  damage_unseen(folder.file());
  Database damaged = Database::open(folder.file(), Database::Mode::own);
  EXPECT_FALSE(damaged.run("SELECT * FROM nothing"));
  EXPECT_FALSE(damaged.run("INSERT INTO visits (start) VALUES (1)"));
  EXPECT_EQ(damaged.trouble(), Trouble::damaged) << "it weighs more than what came before";
  damaged.retry();
  EXPECT_EQ(damaged.trouble(), Trouble::damaged);
}

TEST(VisitStore, AFullDiskWhileAFileIsBroughtForwardLeavesItWhereItIs) {
  const StoreFolder folder;
  {
    Database old = Database::open(folder.file(), Database::Mode::own);
    ASSERT_TRUE(migrate(old, 1));
    ASSERT_TRUE(old.run("INSERT INTO outbox (kind, body) VALUES ('visit', '{}')"));
  }
  const int status = files::test::in_child([&] {
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{4096, 4096};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    std::vector<Problem> remarks;
    const auto opened = VisitStore::open(folder.file(), "then", remarks);
    return !opened && remarks.empty() &&
           opened.error().remedy.find("room on the disk") != std::string::npos;
  });
  EXPECT_EQ(status, 0);
  EXPECT_EQ(folder.files_with("damaged"), 0);
  EXPECT_EQ(count(folder.file(), "SELECT count(*) FROM outbox"), 1);
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

TEST(VisitStore, OfVisitsThatAreForgottenNothingIsLeftAndTheOthersStay) {
  const StoreFolder folder;
  auto visits = scripted_visits(300, 7);
  std::int64_t young = 0;
  for (VisitRecord& visit : visits) {
    const bool old = visit.day < "2026-05-15";
    visit.vessel = old ? "long_forgotten_jar" : "moon_jar";
    young += old ? 0 : 1;
  }
  ASSERT_GT(young, 0);
  ASSERT_LT(young, 300);
  VisitStore store = open(folder.file());
  ASSERT_TRUE(store.add(visits));
  ASSERT_NE(bytes_of(folder.file()).find("long_forgotten_jar"), std::string::npos);
  ASSERT_TRUE(store.forget_before("2026-05-15"));
  EXPECT_EQ(bytes_of(folder.file()).find("long_forgotten_jar"), std::string::npos)
      << "a row that is only marked as deleted can be read by anybody";
  store = open(folder.path() / "other.sqlite");  // lets go of the first
  EXPECT_EQ(count(folder.file(), "SELECT count(*) FROM visits"), young);
  EXPECT_EQ(count(folder.file(), "SELECT count(*) FROM visits WHERE day < '2026-05-15'"), 0);
}

TEST(VisitStore, WhatWasSetAsideIsForgottenByItsDayAndNoOtherFileIs) {
  const StoreFolder folder;
  const std::vector<std::string> stay{"onggi.sqlite.damaged-2026-05-04_141503",
                                      "onggi.sqlite.damaged-2026-05-04_141503-wal",
                                      "onggi.sqlite.damaged-0 see my note",
                                      "other.sqlite.damaged-2001-05-04_141503", "onggi.sqlite"};
  const std::vector<std::string> go{"onggi.sqlite.damaged-2026-05-03_141503",
                                    "onggi.sqlite.damaged-2026-05-03_141503-wal"};
  for (const auto* names : {&stay, &go})
    for (const std::string& name : *names) std::ofstream(folder.path() / name) << "x";
  fs::create_directories(folder.path() / "onggi.sqlite.damaged-2001-01-01_000000");
  ASSERT_TRUE(VisitStore::forget_aside(folder.file(), "2026-05-04"));
  for (const std::string& name : stay) EXPECT_TRUE(fs::exists(folder.path() / name)) << name;
  for (const std::string& name : go) EXPECT_FALSE(fs::exists(folder.path() / name)) << name;
  EXPECT_TRUE(fs::exists(folder.path() / "onggi.sqlite.damaged-2001-01-01_000000"));
}

}  // namespace
}  // namespace onggi::store::visit_store_test
