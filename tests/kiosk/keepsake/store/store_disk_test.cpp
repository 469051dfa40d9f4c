#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "kiosk/keepsake/store/statistics.h"
#include "kiosk/keepsake/store/store_thread.h"
#include "tests/kiosk/ground/files/disk.h"
#include "tests/kiosk/keepsake/store/visits.h"

namespace fs = std::filesystem;

namespace onggi::store::store_disk_test {
namespace {

using files::test::in_child;
using files::test::on_a_disk;

std::int64_t counted(const fs::path& file) {
  const auto found = read_statistics(file.string(), "", "");
  return found ? found->all.visits + found->brief : -1;
}

/// Hands over one visit after the other, and waits for each.
void visit(StoreThread& store, int visits) {
  for (const VisitRecord& one : scripted_visits(visits, 40)) {
    store.visit(one);
    store.finish();
  }
}

bool is_said_once(StoreThread& store, const std::string& words) {
  const std::vector<Problem> remarks = store.remarks();
  return remarks.size() == 1 && to_text(remarks[0]).find(words) != std::string::npos;
}

constexpr int kParty = 7;  ///< Visits of one transaction.

/// A store as a power cut leaves it: its last transactions are in the log alone.
void leave_in_log(const fs::path& file, int parties) {
  const StoreFolder open;
  std::vector<Problem> remarks;
  auto store = VisitStore::open(open.file(), "then", remarks);
  ASSERT_TRUE(store);
  for (int n = 0; n < parties; ++n)
    ASSERT_TRUE(store->add(scripted_visits(kParty, static_cast<unsigned>(n))));
  for (const char* tail : {"", "-wal"})
    fs::copy_file(open.file().string() + tail, file.string() + tail);
}

// At every 4 KiB, and a byte of each turned over.
TEST(StoreDisk, ALogThatAPowerCutLeftHalfWrittenGivesWholeTransactionsAndIsNoDamage) {
  const StoreFolder whole;
  constexpr int kParties = 8;
  leave_in_log(whole.file(), kParties);
  const auto size = fs::file_size(whole.file().string() + "-wal");
  ASSERT_GT(size, 60'000u);
  std::int64_t before = -1;
  std::vector<std::uintmax_t> cuts;
  for (std::uintmax_t cut = 0; cut < size; cut += 4096) cuts.push_back(cut);
  cuts.push_back(size);
  for (const std::uintmax_t cut : cuts)
    for (const bool torn : {false, true}) {
      if (torn && cut == size) continue;
      const StoreFolder folder;
      const fs::path log = folder.file().string() + "-wal";
      fs::copy_file(whole.file(), folder.file());
      fs::copy_file(whole.file().string() + "-wal", log);
      if (torn) {
        std::fstream byte(log, std::ios::in | std::ios::out | std::ios::binary);
        byte.seekg(static_cast<std::streamoff>(cut));
        const int was = byte.get();
        byte.seekp(static_cast<std::streamoff>(cut));
        byte.put(static_cast<char>(was ^ 0x5a));
      } else {
        fs::resize_file(log, cut);
      }
      std::vector<Problem> remarks;
      {
        auto store = VisitStore::open(folder.file(), "then", remarks);
        ASSERT_TRUE(store) << cut << ' ' << store.error().what;
        ASSERT_TRUE(store->add(scripted_visits(kParty, 99))) << cut;
      }
      EXPECT_TRUE(remarks.empty()) << cut;
      Database database = Database::open(folder.file(), Database::Mode::read);
      const std::int64_t found = database.number("SELECT count(*) FROM visits").value_or(-1);
      EXPECT_EQ(found % kParty, 0) << cut << ": a transaction is whole or absent";
      if (torn) continue;
      EXPECT_GE(found, before) << cut << ": a longer log tells no less";
      before = found;
    }
  EXPECT_EQ(before, (kParties + 1) * kParty) << "the whole log tells all";
}

TEST(StoreDisk, WhatWasCountedBeforeAProgramIsKilledIsCountedAfterwards) {
  const StoreFolder folder;
  for (int round = 1; round <= 3; ++round) {
    const int status = in_child([&] {
      StoreThread store(folder.file(), 0);
      for (int n = 0; n < 4; ++n) {
        for (const VisitRecord& one : scripted_visits(kParty, 41)) store.visit(one);
        store.finish();
      }
      for (const VisitRecord& one : scripted_visits(kParty, 42)) store.visit(one);
      ::kill(::getpid(), SIGKILL);
      return false;
    });
    ASSERT_TRUE(WIFSIGNALED(status));
    EXPECT_GE(counted(folder.file()), round * 4 * kParty);
    EXPECT_LE(counted(folder.file()), round * 5 * kParty);
  }
  EXPECT_EQ(folder.files_with("damaged"), 0);
}

/// A disk that takes nothing more, until it does again; twice.
bool goes_on_after(const fs::path& file, const std::function<void()>& fill,
                   const std::function<void()>& make_room) {
  StoreThread store(file, 0);
  visit(store, 3);
  if (!store.remarks().empty()) return false;
  for (int n = 1; n <= 2; ++n) {
    fill();
    visit(store, 200);
    if (!is_said_once(store, "Make room on the disk")) return false;
    make_room();
    visit(store, 1);
    if (!store.remarks().empty() || counted(file) != 3 + 201 * n) return false;
  }
  return true;
}

TEST(StoreDisk, AFullDiskIsSaidOnceAndWhatItDidNotTakeIsCountedWhenThereIsRoom) {
  const StoreFolder folder;
  const auto aside = [&] { return folder.files_with("damaged"); };
  const int status = on_a_disk(folder.path(), 0, "size=400k", [&] {
    const fs::path filler = folder.path() / "filler";
    const auto fill = [&] {
      std::ofstream out(filler, std::ios::binary);
      while (out.write("x", 1).flush()) {
      }
    };
    return goes_on_after(folder.file(), fill, [&] { fs::remove(filler); }) && aside() == 0;
  });
  if (WEXITSTATUS(status) == files::test::kNoMounts)
    GTEST_SKIP() << "a disk of our own is not allowed here";
  EXPECT_EQ(status, 0);
}

// Everywhere, though less like a disk: no file may grow beyond so many bytes.
TEST(StoreDisk, AFileThatMayNotGrowIsNoDamageEither) {
  const StoreFolder folder;
  const int status = in_child([&] {
    ::signal(SIGXFSZ, SIG_IGN);
    const auto limit = [](rlim_t bytes) {
      rlimit now{};
      ::getrlimit(RLIMIT_FSIZE, &now);
      now.rlim_cur = bytes;
      ::setrlimit(RLIMIT_FSIZE, &now);
    };
    return goes_on_after(
        folder.file(), [&] { limit(50'000); }, [&] { limit(RLIM_INFINITY); });
  });
  EXPECT_EQ(status, 0);
  EXPECT_EQ(folder.files_with("damaged"), 0);
}

TEST(StoreDisk, OnAReadOnlyDiskNothingIsCountedAndThatIsSaidOnceUntilItCanBeWritten) {
  const StoreFolder folder;
  for (const bool damaged : {false, true}) {
    const int status = on_a_disk(folder.path(), 0, "size=400k", [&] {
      if (damaged) std::ofstream(folder.file()) << std::string(9000, 'x');
      const auto remount = [&](unsigned long flags) {
        return ::mount("none", folder.path().c_str(), nullptr, MS_REMOUNT | flags, nullptr) == 0;
      };
      if (!remount(MS_RDONLY)) ::_exit(files::test::kNoMounts);
      StoreThread store(folder.file(), 1);
      visit(store, 4);
      if (!is_said_once(store, "writable")) return false;
      if (!remount(0)) return false;
      visit(store, 1);
      const auto remarks = store.remarks().size();
      return counted(folder.file()) == 5 && remarks == (damaged ? 1u : 0u);
    });
    if (WEXITSTATUS(status) == files::test::kNoMounts)
      GTEST_SKIP() << "a disk of our own is not allowed here";
    EXPECT_EQ(status, 0) << damaged;
  }
}

}  // namespace
}  // namespace onggi::store::store_disk_test
