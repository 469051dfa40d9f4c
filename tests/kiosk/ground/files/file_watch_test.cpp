#include "kiosk/ground/files/file_watch.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/kiosk/ground/files/disk.h"

namespace onggi::files::file_watch_test {
namespace {

using files::test::ScratchFolder;
namespace fs = std::filesystem;

TEST(file_watch, a_folder_at_rest_has_not_changed) {
  const ScratchFolder folder;
  std::ofstream(folder.path() / "exhibit.toml") << "title";
  FileWatch watch({folder.path()});
  std::ifstream(folder.path() / "exhibit.toml").get();  // reading is no change
  for (double now = 0.0; now < 5.0; now += 0.5) EXPECT_FALSE(watch.changed(now));
}

TEST(file_watch, a_change_is_told_once_and_only_when_its_last_step_has_come_to_rest) {
  const ScratchFolder folder;
  FileWatch watch({folder.path()});
  for (int step = 0; step < 5; ++step) {  // a copy that takes four seconds
    std::ofstream(folder.path() / "scan.glb", std::ios::app) << "more";
    EXPECT_FALSE(watch.changed(0.9 * step)) << step;
    EXPECT_TRUE(watch.pending());
  }
  EXPECT_FALSE(watch.changed(3.6 + 0.9));
  EXPECT_TRUE(watch.changed(3.61 + FileWatch::kSettle));
  EXPECT_FALSE(watch.changed(100.0));
}

TEST(file_watch, every_way_in_which_a_file_changes_is_seen) {
  const ScratchFolder folder, elsewhere;
  const fs::path file = folder.path() / "exhibit.toml", other = elsewhere.path() / "exhibit.toml";
  std::ofstream(file) << "title";
  FileWatch watch({folder.path()});
  double now = 0.0;
  const auto seen = [&] {
    watch.changed(now);
    return watch.changed(now += 10.0);
  };
  std::ofstream(file) << "written in place";
  EXPECT_TRUE(seen());
  std::ofstream(other) << "moved over it, as editors do";
  fs::rename(other, file);
  EXPECT_TRUE(seen());
  fs::rename(file, other);
  EXPECT_TRUE(seen());
  fs::create_directory(folder.path() / "jar");
  EXPECT_TRUE(seen());
  fs::remove(folder.path() / "jar");
  EXPECT_TRUE(seen());
  EXPECT_FALSE(seen());
}

TEST(file_watch, a_file_that_is_cut_in_place_or_written_and_kept_open_has_changed) {
  const ScratchFolder folder;
  const fs::path file = folder.path() / "exhibit.toml";
  std::ofstream(file) << "title";
  std::ofstream held(file, std::ios::app);
  FileWatch watch({folder.path()});
  fs::resize_file(file, 0);  // by its name: nobody opens or closes it
  EXPECT_FALSE(watch.changed(0.0));
  EXPECT_TRUE(watch.changed(5.0));
  held << "more" << std::flush;
  EXPECT_FALSE(watch.changed(10.0));
  EXPECT_TRUE(watch.changed(15.0));
}

TEST(file_watch, a_folder_that_is_not_there_is_passed_over) {
  const ScratchFolder folder;
  FileWatch watch({folder.path() / "nowhere", folder.path()});
  EXPECT_EQ(watch.watched(), 1);
  std::ofstream(folder.path() / "x") << "x";
  watch.changed(0.0);
  EXPECT_TRUE(watch.changed(2.0));
}

}  // namespace
}  // namespace onggi::files::file_watch_test
