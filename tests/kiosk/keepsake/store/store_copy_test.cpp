#include "kiosk/keepsake/store/store_copy.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "kiosk/keepsake/store/visit_store.h"
#include "tests/kiosk/keepsake/store/visits.h"

namespace fs = std::filesystem;

namespace onggi::store::store_copy_test {
namespace {

std::int64_t visits_in(const fs::path& file) {
  Database database = Database::open(file, Database::Mode::read);
  return database.number("SELECT count(*) FROM visits").value_or(-1);
}

TEST(StoreCopy, IsWholeWhereNothingIsWrittenAndRefusedWhereAVisitIsWrittenInItsMiddle) {
  const StoreFolder folder, elsewhere;
  std::vector<Problem> remarks;
  auto store = VisitStore::open(folder.file(), "then", remarks);
  ASSERT_TRUE(store);
  ASSERT_TRUE(store->add(scripted_visits(7, 31)));
  EXPECT_TRUE(copy_still(folder.file(), elsewhere.file()));
  EXPECT_EQ(visits_in(elsewhere.file()), 7) << "what is still in the log counts";

  EXPECT_FALSE(copy_still(folder.file(), elsewhere.file(), [&] {
    EXPECT_TRUE(store->add(scripted_visits(1, 32)));
  })) << "the log grows";
  EXPECT_FALSE(copy_still(folder.file(), elsewhere.file(), [&] {
    EXPECT_TRUE(store->forget_before("2026-05-10"));
    EXPECT_TRUE(store->add(scripted_visits(1, 33)));
  })) << "the log is emptied into the file and begun anew";
  EXPECT_TRUE(copy_still(folder.file(), elsewhere.file()));
  EXPECT_FALSE(copy_still(folder.path() / "none", elsewhere.file()));
}

TEST(StoreCopy, APipeInThePlaceOfItsLogMakesNobodyWait) {
  const StoreFolder folder, elsewhere;
  std::vector<Problem> remarks;
  ASSERT_TRUE(VisitStore::open(folder.file(), "then", remarks));
  fs::remove(folder.file().string() + "-wal");
  ASSERT_EQ(::mkfifo((folder.file().string() + "-wal").c_str(), 0600), 0);
  EXPECT_FALSE(copy_still(folder.file(), elsewhere.file()));
}

TEST(StoreCopy, ItsFolderIsGoneWithIt) {
  fs::path was;
  {
    const CopyFolder folder;
    was = folder.path();
    ASSERT_TRUE(fs::is_directory(was));
    std::ofstream(was / "copy") << "x";
  }
  EXPECT_FALSE(fs::exists(was));
}

}  // namespace
}  // namespace onggi::store::store_copy_test
