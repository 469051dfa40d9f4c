#include "kiosk/program/console/kept_files.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>

#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::console::kept_files_test {
namespace {

namespace fs = std::filesystem;

TEST(kept_files, TheNewestStay) {
  const files::test::ScratchFolder folder;
  const auto now = fs::file_time_type::clock::now();
  for (int n = 0; n < 5; ++n) {
    const fs::path file = folder / std::to_string(n);
    std::ofstream(file) << n;
    fs::last_write_time(file, now - std::chrono::hours(n));
  }
  keep_newest(folder.path(), 2);
  for (int n = 0; n < 5; ++n) EXPECT_EQ(fs::exists(folder / std::to_string(n)), n < 2) << n;
  keep_newest(folder / "none", 2);
}

}  // namespace
}  // namespace onggi::console::kept_files_test
