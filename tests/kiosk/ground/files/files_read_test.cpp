#include "kiosk/ground/files/files_read.h"

#include <gtest/gtest.h>

#include <fstream>

#include "kiosk/ground/files/read_file.h"
#include "tests/kiosk/ground/files/disk.h"

namespace onggi::files::files_read_test {
namespace {

TEST(files_read, a_program_that_writes_no_output_keeps_no_list_of_all_it_ever_read) {
  const test::ScratchFolder folder;
  const auto read = [&folder](const std::string& name) {
    const auto file = folder.path() / name;
    std::ofstream(file) << name;
    EXPECT_TRUE(read_file(file, 100));
    struct stat info {};
    EXPECT_EQ(::stat(file.c_str(), &info), 0);
    return info;
  };
  const struct stat first = read("first");
  EXPECT_TRUE(was_read(first));
  note_reads(false);
  EXPECT_FALSE(was_read(first));
  EXPECT_FALSE(was_read(read("second")));
  note_reads(true);
  EXPECT_TRUE(was_read(read("third")));
  note_reads(false);  // the next file may have the inode of one that was deleted
  note_reads(true);
}

}  // namespace
}  // namespace onggi::files::files_read_test
