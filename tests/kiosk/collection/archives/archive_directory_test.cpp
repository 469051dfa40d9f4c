#include "kiosk/collection/archives/archive_directory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <string>

#include "tests/kiosk/collection/archives/zip_maker.h"
#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::archives::archive_directory_test {
namespace {

using test::end_of;
using test::little;
using test::zip_of;
using ::testing::HasSubstr;

class ArchiveDirectory : public ::testing::Test {
 protected:
  std::string told(const std::string& bytes, std::size_t most = 20) {
    test::write_zip(file_, bytes);
    const auto good = check_directory(file_, most);
    return good ? "" : to_text(good.error());
  }
  files::test::ScratchFolder scratch_;
  std::filesystem::path file_ = scratch_ / "scan.zip";
};

// Before: a library would take memory for as many entries as these 22 bytes claim.
TEST_F(ArchiveDirectory, ACountThatIsClaimedAndNotThereIsRefused) {
  EXPECT_EQ(told(end_of(20, 0, 0)), "");
  EXPECT_THAT(told(end_of(21, 0, 0)), HasSubstr("more than 20 files and folders"));
  EXPECT_THAT(told(end_of(1, 20 * 2048 + 1, 0)), HasSubstr("more than 20 files and folders"));
}

TEST_F(ArchiveDirectory, EntriesBeyondTheirCountAreCounted) {
  std::vector<test::ZipEntry> entries;
  for (int n = 0; n < 30; ++n) entries.push_back({"file" + std::to_string(n)});
  std::string bytes = zip_of(entries);
  // Info-ZIP writes a count of 65536 as 0, and libraries go on to the directory's end.
  bytes.replace(bytes.size() - 14, 4, little(5 << 16 | 5, 4));
  EXPECT_THAT(told(bytes), HasSubstr("more than 20 files and folders"));
  EXPECT_EQ(told(bytes, 30), "");
}

TEST_F(ArchiveDirectory, ALargeArchivesSecondEndIsReadToo) {
  const auto with_far_end = [](std::uint64_t entries, std::uint64_t length) {
    const std::string far = "PK\6\6" + little(44, 8) + little(45, 2) + little(45, 2) +
                            little(0, 8) + little(entries, 8) + little(entries, 8) +
                            little(length, 8) + little(0, 8);
    return far + "PK\6\7" + little(0, 4) + little(0, 8) + little(1, 4) + end_of(1, 46, 0);
  };
  EXPECT_EQ(told(with_far_end(20, 46)), "");
  EXPECT_THAT(told(with_far_end(21, 46)), HasSubstr("more than 20 files"));
  EXPECT_THAT(told(with_far_end(1, 1ull << 40)), HasSubstr("more than 20 files"));
  // A place beyond the file, and a number that is as large as numbers are.
  EXPECT_EQ(told("PK\6\7" + little(0, 4) + little(~0ull, 8) + little(1, 4) + end_of(1, 0, 0)), "");
}

TEST_F(ArchiveDirectory, AnEndBehindACommentIsFoundAndManyEndsAreNone) {
  std::string bytes = zip_of({{"a.glb", "glTF"}});
  bytes.replace(bytes.size() - 2, 2, little(60'000, 2));
  EXPECT_EQ(told(bytes + std::string(60'000, ' ')), "");
  std::string many;
  for (int n = 0; n < 9; ++n) many += end_of(0, 0, 0);
  EXPECT_THAT(told(many), HasSubstr("no zip archive"));
}

TEST_F(ArchiveDirectory, APipeIsNoArchiveAndNobodyWaitsForIt) {
  ASSERT_EQ(::mkfifo(file_.c_str(), 0600), 0);
  const auto pipe = check_directory(file_, 20);
  EXPECT_THAT(pipe ? "" : to_text(pipe.error()), HasSubstr("is not there, or cannot be read"));
}

}  // namespace
}  // namespace onggi::archives::archive_directory_test
