#include "kiosk/collection/archives/unpack.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <string>
#include <vector>

#include "tests/kiosk/collection/archives/zip_maker.h"
#include "tests/kiosk/ground/files/disk.h"

namespace onggi::archives::unpack_test {
namespace {

namespace fs = std::filesystem;
using files::test::content;
using test::deflated_zeros;
using test::zip_of;
using test::ZipEntry;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class Unpack : public ::testing::Test {
 protected:
  /// What unpacking `bytes` says; "" where it went well.
  std::string told(const std::string& bytes) {
    const fs::path file = scratch_ / "scan.zip";
    test::write_zip(file, bytes);
    fs::remove_all(folder_);
    const auto done = unpack(file, folder_, limits_);
    EXPECT_EQ(fs::exists(folder_), done.has_value()) << "all or nothing";
    EXPECT_FALSE(fs::exists(scratch_ / "out"));
    return done ? "" : to_text(done.error());
  }
  std::string told(const std::vector<ZipEntry>& entries) { return told(zip_of(entries)); }
  /// A good entry first, so that something was written before `wrong` is seen.
  std::string told_of(const ZipEntry& wrong) { return told({{"a.glb", "glTF"}, wrong}); }
  std::vector<std::string> all() const {
    std::vector<std::string> names;
    for (const auto& at : fs::recursive_directory_iterator(folder_))
      names.push_back(at.path().lexically_relative(folder_).string());
    std::sort(names.begin(), names.end());
    return names;
  }
  files::test::ScratchFolder scratch_;
  fs::path folder_ = scratch_ / "folder";
  UnpackLimits limits_{.entries = 20, .bytes = 1u << 20, .depth = 4, .reserve = 0};
};

TEST_F(Unpack, FilesAndFoldersComeOutAsTheyWereWithoutASystemsLitter) {
  const std::string zeros(1 + 258 * 100, '\0');
  ZipEntry deflated{"jar/textures/zeros.bin", zeros, test::kFile, 8};
  deflated.packed = deflated_zeros(zeros.size());
  EXPECT_EQ(told({{"jar/", "", test::kFolder},
                  {"jar/scan.gltf", "{}", test::kFile},
                  deflated,
                  {"jar/.DS_Store", "x"},
                  {"__MACOSX/jar/._scan.gltf", "x"},
                  {"항아리.txt", ""}}),
            "");
  EXPECT_THAT(all(), ElementsAre("jar", "jar/scan.gltf", "jar/textures", "jar/textures/zeros.bin",
                                 "항아리.txt"));
  EXPECT_EQ(content(folder_ / "jar/scan.gltf"), "{}");
  EXPECT_TRUE(content(folder_ / "jar/textures/zeros.bin") == zeros);
  struct stat info {};
  ASSERT_EQ(::stat((folder_ / "jar/scan.gltf").c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 07133, 0u) << "no program, and nobody else writes it";
}

TEST_F(Unpack, ANameThatLeadsOutIsRefusedAndNothingIsLeft) {
  for (const char* name : {"../out", "/tmp/out", "a/../../out", "..\\out", "C:\\out", "C:/out"})
    EXPECT_THAT(told_of({name, "x"}), HasSubstr("no plain path")) << name;
  EXPECT_THAT(told_of({"jar\xff.obj", "x"}), AllOf(HasSubstr("scan.zip, jar?.obj: "),
                                                   HasSubstr("not UTF-8"), HasSubstr("Rename")));
  EXPECT_THAT(told_of({std::string("b.glb\0.txt", 10), "x"}), HasSubstr("zero byte"));
  EXPECT_THAT(told_of({"A.GLB", "x"}), HasSubstr("another file has this name"));
  EXPECT_THAT(told_of({"1/2/3/4/5", "x"}), HasSubstr("deeper than 4"));
}

TEST_F(Unpack, LinksAndSpecialFilesAreRefused) {
  for (const std::uint32_t kind : {test::kLink, test::kPipe, 0020644u << 16, test::kFolder})
    EXPECT_THAT(told_of({"b", "/etc/passwd", kind}), HasSubstr("a link or a special file")) << kind;
  EXPECT_THAT(told_of({"b/", "", test::kLink}), HasSubstr("a link or a special file"));
}

TEST_F(Unpack, LockedAndStrangelyPackedEntriesAreRefused) {
  ZipEntry locked{"b.glb", "0123456789abcdef"};
  locked.flags = 1;
  EXPECT_THAT(told_of(locked), HasSubstr("locked with a password"));
  ZipEntry strange{"b.glb", "x", 0, 12};
  strange.packed = "BZh9";
  EXPECT_THAT(told_of(strange), HasSubstr("packed in a way"));
}

TEST_F(Unpack, TooManyEntriesAreRefusedByTheDirectoryItself) {
  std::vector<ZipEntry> entries;
  for (int n = 0; n < 20; ++n) entries.push_back({"file" + std::to_string(n), "x"});
  EXPECT_EQ(told(entries), "");
  entries.push_back({"one_more", "x"});
  EXPECT_THAT(told(entries), HasSubstr("more than 20 files and folders"));
}

TEST_F(Unpack, MoreThanTheLimitOfBytesIsRefusedBeforeAnythingIsWritten) {
  limits_.bytes = 100;
  EXPECT_EQ(told({{"a", std::string(60, 'x')}, {"b", std::string(40, 'x')}}), "");
  EXPECT_THAT(told({{"a", std::string(60, 'x')}, {"b", std::string(41, 'x')}}),
              HasSubstr("unpacked, this archive has more than"));
  ZipEntry most{"b", "x"};
  most.claim = 0xFFFFFFFE;
  EXPECT_THAT(told_of(most), HasSubstr("unpacked, this archive has more than"));
}

TEST_F(Unpack, ABombThatLiesAboutItsSizeIsStoppedWhileItIsWritten) {
  const std::size_t size = 1 + 258 * 400'000;  // 103 MB in 650 kB
  ZipEntry bomb{"b.bin", "", test::kFile, 8};
  bomb.packed = deflated_zeros(size);
  bomb.claim = 100'000;
  const int status = files::test::on_a_disk(scratch_.path(), 0, "size=4m", [&] {
    return told_of(bomb).find("more bytes than it claims") != std::string::npos;
  });
  if (WEXITSTATUS(status) != files::test::kNoMounts) {
    EXPECT_EQ(status, 0);
  }
  EXPECT_THAT(told_of(bomb), HasSubstr("more bytes than it claims"));
  ZipEntry stored{"b.bin", std::string(5000, 'x')};
  stored.claim = 10;
  EXPECT_THAT(told_of(stored), HasSubstr("is damaged"));
  stored.claim = 6000;
  EXPECT_THAT(told_of(stored), HasSubstr("is damaged"));
}

TEST_F(Unpack, ADamagedEntryIsRefused) {
  ZipEntry wrong{"b.bin", "the museum's"};
  wrong.crc = 1;
  EXPECT_THAT(told_of(wrong),
              AllOf(HasSubstr("scan.zip, b.bin: this is damaged"), HasSubstr("copy all of it")));
  ZipEntry broken{"b.bin", std::string(259, '\0'), 0, 8};
  broken.packed = "\xff\xff\xff";
  EXPECT_THAT(told_of(broken), HasSubstr("is damaged"));
}

TEST_F(Unpack, WhatIsNoArchiveIsSaid) {
  EXPECT_THAT(told(std::string()), HasSubstr("no zip archive"));
  EXPECT_THAT(told(std::string(100'000, 'x')), HasSubstr("no zip archive"));
  const std::string whole = zip_of({{"a.glb", std::string(1000, 'x')}});
  EXPECT_THAT(told(whole.substr(0, whole.size() - 10)), HasSubstr("no zip archive"));
  EXPECT_THAT(told(whole.substr(500)), HasSubstr("is damaged")) << "the beginning is missing";
  EXPECT_THAT(told("PK\5\6" + std::string(18, '\0')), "") << "an empty archive is an empty folder";
  EXPECT_FALSE(unpack(scratch_ / "none.zip", folder_, limits_));
  EXPECT_FALSE(unpack(scratch_.path(), folder_, limits_));
}

TEST_F(Unpack, AFolderThatIsThereIsNotTouched) {
  const fs::path file = scratch_ / "scan.zip";
  test::write_zip(file, zip_of({{"a.glb", "glTF"}}));
  fs::create_directory(folder_);
  std::ofstream(folder_ / "own") << "the museum's";
  EXPECT_FALSE(unpack(file, folder_, limits_));
  EXPECT_THAT(all(), ElementsAre("own"));
}

TEST_F(Unpack, ADiskWithoutTheRoomIsTheMachinesFaultAndItsReserveStays) {
  const int status = files::test::on_a_disk(scratch_.path(), 0, "size=1m", [&] {
    const std::string bytes = zip_of({{"a", std::string(100'000, 'x')}});
    limits_.reserve = 1u << 19;
    const bool fits = told(bytes).empty();
    limits_.reserve = 900'000;
    const bool refused = told(bytes).find("not that much room") != std::string::npos;
    return fits && refused;
  });
  if (WEXITSTATUS(status) == files::test::kNoMounts) GTEST_SKIP() << "no mounts here";
  EXPECT_EQ(status, 0);
}

TEST(ArchiveEnding, IsZipInAnyCase) {
  EXPECT_TRUE(is_archive_ending("a/scan.zip") && is_archive_ending("SCAN.ZIP"));
  EXPECT_FALSE(is_archive_ending("zip") || is_archive_ending("scan.glb"));
}

}  // namespace
}  // namespace onggi::archives::unpack_test
