#include "kiosk/collection/archives/entry_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace onggi::archives::entry_names_test {
namespace {

using namespace std::string_literals;
using ::testing::HasSubstr;

std::string told(const Result<void>& result) { return result ? "" : to_text(result.error()); }

TEST(EntryNames, ANameThatIsNoPathInTheArchiveIsRefused) {
  const EntryNames names("scan.zip", 4);
  for (const char* wrong : {"", "/", "/etc/passwd", "..", "../x", "a/../../x", "a/..", "./a",
                            "a/./b", "a//b", "C:/x", "c:x", "a\\b", "..\\x", "//host/x", "a//"})
    EXPECT_THAT(told(names.check(wrong)), HasSubstr("no plain path")) << wrong;
  for (const char* good :
       {"a", "a/", "a/b/c.glb", "...", "a..b", "a/..b", "항아리/scan.glb", "1:2.obj"})
    EXPECT_EQ(told(names.check(good)), "") << good;
}

TEST(EntryNames, ANameThatIsNoTextIsRefused) {
  const EntryNames names("scan.zip", 4);
  for (const std::string& wrong : {"a\xff.glb"s, "\xc7\xd7.glb"s, "a\n.glb"s, "a\x1b[2J"s, "a\0b"s})
    EXPECT_THAT(told(names.check(wrong)), HasSubstr("not UTF-8")) << wrong;
}

TEST(EntryNames, ANameThatIsTooLongOrTooDeepIsRefused) {
  const EntryNames names("scan.zip", 4);
  EXPECT_EQ(told(names.check(std::string(255, 'a'))), "");
  EXPECT_THAT(told(names.check(std::string(256, 'a'))), HasSubstr("too long"));
  std::string path;
  for (int n = 0; n < 6; ++n) path += std::string(200, 'a') + '/';
  EXPECT_THAT(told(names.check(path)), HasSubstr("too long"));
  EXPECT_EQ(told(names.check("1/2/3/4")), "");
  EXPECT_EQ(told(names.check("1/2/3/4/")), "");
  EXPECT_THAT(told(names.check("1/2/3/4/5")), HasSubstr("deeper than 4 folders"));
}

TEST(EntryNames, TwoEntriesNeverBecomeOneFile) {
  const std::pair<const char*, const char*> clashes[] = {
      {"a", "a"},   {"a.glb", "A.GLB"}, {"x/a", "X/b"}, {"x/", "X/"},
      {"x", "x/a"}, {"x/a", "x"},       {"x", "x/"},    {"x/a", "x/A"}};
  for (const auto& [first, second] : clashes) {
    EntryNames names("scan.zip", 4);
    EXPECT_EQ(told(names.add(first)), "");
    EXPECT_THAT(told(names.add(second)), HasSubstr("another file has this name"))
        << first << ' ' << second;
  }
  EntryNames names("scan.zip", 4);
  for (const char* good : {"x/", "x/", "x/a", "x/b/c", "x/b/", "y", "z/a"})
    EXPECT_EQ(told(names.add(good)), "") << good;
}

TEST(EntryNames, WhatAnOperatingSystemAddsIsNoPartOfAScan) {
  for (const char* litter :
       {"__MACOSX/", "__MACOSX/x/._a.glb", "x/.DS_Store", "._a", "x/Thumbs.db", "desktop.ini"})
    EXPECT_TRUE(is_litter(litter)) << litter;
  for (const char* part : {"a.glb", "x/MACOSX", "x/.hidden", "thumbs.db/a", "x._a"})
    EXPECT_FALSE(is_litter(part)) << part;
}

}  // namespace
}  // namespace onggi::archives::entry_names_test
