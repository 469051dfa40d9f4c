#include "kiosk/program/watch/last_good.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "tests/kiosk/ground/files/disk.h"

namespace onggi::watch::last_good_test {
namespace {

using files::test::content;
using files::test::ScratchFolder;
namespace fs = std::filesystem;

/// A site with a link in it, as a curator may have made.
class Site {
 public:
  Site() {
    put("config/exhibit.toml", "title");
    put("config/scenes/soft.toml", "clay");
    put("content/vessels/jar/vessel.toml", "jar");
    put("elsewhere/bowl/vessel.toml", "bowl");
    fs::create_directory_symlink(path() / "elsewhere/bowl", path() / "content/vessels/bowl");
  }
  fs::path path() const { return folder_.path() / "site"; }
  fs::path state() const { return folder_.path() / "state"; }
  fs::path keepsakes() const { return path() / "keepsakes"; }
  void put(const std::string& name, const std::string& text) const {
    fs::create_directories((path() / name).parent_path());
    std::ofstream(path() / name) << text;
  }
  void keep() const {
    const auto kept = keep_last_good(path(), *files_of(path()), keepsakes(), state());
    ASSERT_TRUE(kept) << to_text(kept.error());
    ASSERT_TRUE(*kept);
  }

 private:
  ScratchFolder folder_;
};

TEST(last_good, nothing_is_good_before_it_was_kept) { EXPECT_FALSE(last_good(Site().state())); }

TEST(last_good, a_kept_exhibit_is_whole_and_its_keepsakes_go_where_they_went) {
  const Site site;
  site.keep();
  site.put("config/exhibit.toml", "broken");  // the copy is of its own
  const auto good = last_good(site.state());
  ASSERT_TRUE(good);
  EXPECT_EQ(content(good->exhibit), "title");
  const fs::path root = good->exhibit.parent_path().parent_path();
  EXPECT_EQ(content(root / "config/scenes/soft.toml"), "clay");
  EXPECT_EQ(content(root / "content/vessels/bowl/vessel.toml"), "bowl");
  EXPECT_FALSE(fs::exists(root / "elsewhere"));
  EXPECT_EQ(good->keepsakes, site.keepsakes());
}

TEST(last_good, a_changed_exhibit_takes_the_place_of_the_one_before_and_what_it_lost_is_gone) {
  const Site site;
  site.keep();
  site.put("config/exhibit.toml", "another title");
  fs::remove_all(site.path() / "content/vessels/jar");
  site.keep();
  const auto good = last_good(site.state());
  ASSERT_TRUE(good);
  EXPECT_EQ(content(good->exhibit), "another title");
  EXPECT_FALSE(fs::exists(good->exhibit.parent_path().parent_path() / "content/vessels/jar"));
}

// Two links that lead back would be two to the power of forty files.
TEST(last_good, links_that_lead_back_are_not_followed_and_others_are) {
  const Site site;
  const std::string before = *files_of(site.path());
  EXPECT_NE(before.find("content/vessels/bowl/vessel.toml"), std::string::npos);
  for (const char* link : {"content/vessels/a", "content/vessels/b"})
    fs::create_directory_symlink(".", site.path() / link);
  fs::create_directory_symlink(site.path() / "content", site.path() / "content/vessels/jar/all");
  EXPECT_EQ(*files_of(site.path()), before);
}

TEST(last_good, the_same_exhibit_is_not_copied_again) {
  const Site site;
  site.keep();
  const auto before = fs::last_write_time(last_good(site.state())->exhibit);
  const auto inode = [&] { return fs::hard_link_count(last_good(site.state())->exhibit); };
  fs::create_hard_link(last_good(site.state())->exhibit, site.state() / "same");
  site.keep();
  EXPECT_EQ(inode(), 2u) << "a copy made anew would have one name";
  EXPECT_EQ(fs::last_write_time(last_good(site.state())->exhibit), before);
}

TEST(last_good, a_copy_that_was_cut_short_is_none) {
  const Site site;
  site.keep();
  fs::remove(site.state() / "last_good/files.txt");
  EXPECT_FALSE(last_good(site.state()));
  site.keep();
  EXPECT_TRUE(last_good(site.state()));
}

TEST(last_good, a_site_that_is_not_what_was_shown_is_left_and_the_one_before_stays) {
  const Site site;
  site.keep();
  const std::string shown = *files_of(site.path());
  site.put("config/exhibit.toml", "a broken title");
  const auto kept = keep_last_good(site.path(), shown, site.keepsakes(), site.state());
  ASSERT_TRUE(kept);
  EXPECT_FALSE(*kept);
  EXPECT_EQ(content(last_good(site.state())->exhibit), "title");
}

TEST(last_good, a_full_disk_is_told_and_leaves_the_one_before) {
  const Site site;
  site.put("content/vessels/jar/scan.glb", std::string(200'000, 'x'));
  fs::create_directories(site.state());
  const int status = files::test::on_a_disk(site.state(), 0, "size=512k", [&] {
    site.keep();
    site.put("config/exhibit.toml", "newer");
    site.put("content/vessels/bowl/scan.glb", std::string(200'000, 'y'));
    const auto kept =
        keep_last_good(site.path(), *files_of(site.path()), site.keepsakes(), site.state());
    const auto good = last_good(site.state());
    return !kept && kept.error().exit_code == 1 && good && content(good->exhibit) == "title" &&
           !fs::exists(site.state() / "last_good.new");
  });
  if (WEXITSTATUS(status) == files::test::kNoMounts) GTEST_SKIP() << "no mounts here";
  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace onggi::watch::last_good_test
