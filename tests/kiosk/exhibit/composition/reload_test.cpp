#include "kiosk/exhibit/composition/reload.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "tests/kiosk/ground/files/disk.h"

namespace onggi::exhibit::reload_test {
namespace {

using files::test::ScratchFolder;
namespace fs = std::filesystem;

/// A museum's site with one vessel, whose keepsakes lie in it, as `onggi setup` makes them.
class Museum {
 public:
  Museum() {
    fs::copy("config", at("config"), fs::copy_options::recursive);
    fs::create_directories(at("content/vessels"));
    fs::create_directories(at("keepsakes"));
    fs::copy("content/lessons", at("content/lessons"), fs::copy_options::recursive);
    fs::copy("content/ways", at("content/ways"), fs::copy_options::recursive);
    fs::copy("content/glazes.toml", at("content/glazes.toml"));
    fs::copy("content/missions.toml", at("content/missions.toml"));
    add_vessel("moon_jar");
  }
  fs::path at(const std::string& name) const { return folder_.path() / name; }
  fs::path exhibit() const { return at("config/exhibit.toml"); }
  void add_vessel(const std::string& id) const {
    fs::copy("content/vessels/" + id, at("content/vessels/" + id), fs::copy_options::recursive);
  }
  void append(const std::string& name, const std::string& text) const {
    std::ofstream(at(name), std::ios::app) << text;
  }

 private:
  ScratchFolder folder_;
};

/// Its frames: the kiosk's own seconds go by faster than a check takes.
class Frames {
 public:
  Frames(const Museum& museum, Reload::Shown shown) : reload_(museum.exhibit(), shown) { pass(); }
  /// Long enough for a change that began before to be looked at, where the machine is not slow.
  void pass() {
    for (int frame = 0; frame < 1000; ++frame) one();
  }
  bool wanted() const { return reload_.wanted(); }
  bool soon_wanted() {
    for (int frame = 0; frame < 15000 && !wanted(); ++frame) one();
    return wanted();
  }
  void take_up() { reload_.taken_up(); }

 private:
  void one() {
    reload_.look(now_ += 0.05);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  Reload reload_;
  double now_ = 0.0;
};

TEST(Reload, a_change_is_wanted_once_and_no_more_when_it_has_been_taken_up) {
  const Museum museum;
  Frames frames(museum, Reload::Shown::this_one);
  EXPECT_FALSE(frames.wanted());
  museum.add_vessel("tea_bowl");
  EXPECT_TRUE(frames.soon_wanted());
  frames.take_up();
  museum.append("config/unfinished", "an editor's own");
  fs::remove(museum.at("config/unfinished"));
  frames.pass();
  EXPECT_FALSE(frames.wanted());
}

TEST(Reload, what_visitors_leave_and_the_kiosk_tries_on_the_disk_is_no_change) {
  const Museum museum;
  Frames frames(museum, Reload::Shown::this_one);
  museum.append("keepsakes/.trial", "a trial\n");
  fs::create_directories(museum.at("keepsakes/2026-05-04_141503"));
  museum.append("onggi.log", "beside config and content");
  museum.append("config/notes.txt", "what no exhibit asks for");
  frames.pass();
  EXPECT_FALSE(frames.wanted());
}

TEST(Reload, a_file_that_is_written_again_as_it_was_and_put_back_is_no_change) {
  const Museum museum;
  const auto time = fs::last_write_time(museum.exhibit());
  Frames frames(museum, Reload::Shown::this_one);
  fs::copy_file(museum.exhibit(), museum.at("content/copy"));
  fs::remove(museum.exhibit());
  fs::rename(museum.at("content/copy"), museum.exhibit());
  fs::last_write_time(museum.exhibit(), time);
  frames.pass();
  EXPECT_FALSE(frames.wanted());
}

TEST(Reload, a_broken_change_is_not_wanted_until_it_is_mended) {
  const Museum museum;
  Frames frames(museum, Reload::Shown::this_one);
  museum.append("config/exhibit.toml", "\nshelf = [\n");
  frames.pass();
  EXPECT_FALSE(frames.wanted());
  fs::copy_file("config/exhibit.toml", museum.exhibit(), fs::copy_options::overwrite_existing);
  museum.append("config/exhibit.toml", "\n# ours\n");
  EXPECT_TRUE(frames.soon_wanted());
}

TEST(Reload, what_breaks_while_the_files_are_read_for_the_first_time_was_not_wrong_already) {
  for (const int wait : {0, 1, 2, 4, 8, 16}) {
    const Museum museum;
    Reload reload(museum.exhibit(), Reload::Shown::this_one);
    double now = 0.0;
    reload.look(now);
    std::this_thread::sleep_for(std::chrono::milliseconds(wait));
    museum.append("config/exhibit.toml", "\nshelf = [\n");
    for (int frame = 0; frame < 200; ++frame) {
      reload.look(now += 0.05);
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      ASSERT_FALSE(reload.wanted()) << "broken " << wait << " ms after the first look";
    }
  }
}

TEST(Reload, an_exhibit_that_goes_away_is_not_wanted_though_a_good_change_came_before_it) {
  const Museum museum;
  Frames frames(museum, Reload::Shown::this_one);
  museum.add_vessel("tea_bowl");
  ASSERT_TRUE(frames.soon_wanted());  // and a visitor plays on
  fs::rename(museum.exhibit(), museum.at("exhibit.kept"));
  frames.pass();
  EXPECT_FALSE(frames.wanted());
  fs::rename(museum.at("exhibit.kept"), museum.exhibit());
  EXPECT_TRUE(frames.soon_wanted());
}

TEST(Reload, a_folder_that_is_put_in_another_ones_place_is_a_change) {
  const Museum museum;
  Frames frames(museum, Reload::Shown::this_one);
  fs::copy(museum.at("config"), museum.at("config.new"), fs::copy_options::recursive);
  museum.append("config.new/exhibit.toml", "\n# ours\n");
  fs::rename(museum.at("config"), museum.at("config.old"));
  frames.pass();  // it is looked at while there is none
  EXPECT_FALSE(frames.wanted());
  fs::rename(museum.at("config.new"), museum.at("config"));
  EXPECT_TRUE(frames.soon_wanted());
}

TEST(Reload, a_link_to_the_next_exhibit_is_a_change) {
  const Museum museum;
  fs::rename(museum.at("config"), museum.at("first"));
  fs::copy(museum.at("first"), museum.at("next"), fs::copy_options::recursive);
  museum.append("next/exhibit.toml", "\n# ours\n");
  fs::create_directory_symlink("first", museum.at("config"));
  Frames frames(museum, Reload::Shown::this_one);
  fs::create_directory_symlink("next", museum.at("link"));
  fs::rename(museum.at("link"), museum.at("config"));
  EXPECT_TRUE(frames.soon_wanted());
}

TEST(Reload, what_was_wrong_already_keeps_no_change_out) {
  const Museum museum;
  museum.append("config/exhibit.toml", "\ncrediit = \"us\"\n");
  Frames frames(museum, Reload::Shown::this_one);
  museum.add_vessel("tea_bowl");
  EXPECT_TRUE(frames.soon_wanted());
}

TEST(Reload, while_another_is_shown_the_museums_waits_for_a_change_that_mends_it) {
  const Museum museum;
  museum.append("config/exhibit.toml", "\nshelf = [\n");
  Frames frames(museum, Reload::Shown::another);
  EXPECT_FALSE(frames.wanted());
  museum.add_vessel("tea_bowl");
  frames.pass();
  EXPECT_FALSE(frames.wanted()) << "it is as broken as before";
  fs::copy_file("config/exhibit.toml", museum.exhibit(), fs::copy_options::overwrite_existing);
  EXPECT_TRUE(frames.soon_wanted());
}

TEST(Reload, while_another_is_shown_a_vessel_that_cannot_be_read_keeps_the_museums_not_out) {
  const Museum museum;
  museum.add_vessel("tea_bowl");
  museum.append("content/vessels/moon_jar/vessel.toml", "\nbroken = [\n");
  Frames frames(museum, Reload::Shown::another);
  museum.append("config/exhibit.toml", "\n# ours\n");
  EXPECT_TRUE(frames.soon_wanted());
  frames.take_up();
  for (const char* vessel : {"tea_bowl", "moon_jar"})
    fs::remove_all(museum.at("content/vessels") / vessel);
  frames.pass();
  EXPECT_FALSE(frames.wanted()) << "the museum's is shown now, and what was good in it is known";
}

}  // namespace
}  // namespace onggi::exhibit::reload_test
