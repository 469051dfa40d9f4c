#include "kiosk/program/setup/machine_setup.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <string>

#include "tests/kiosk/program/setup/setup_image.h"

namespace onggi::setup::machine_setup_test {
namespace {

using files::test::content;
using test::good;
using test::Image;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
namespace fs = std::filesystem;

TEST(machine_setup, a_bare_machine_becomes_a_kiosk) {
  const Image image;
  good(set_up(image.options()));
  EXPECT_EQ(content(image.root() / "srv/onggi/config/scenes/soft.toml"), "clay");
  EXPECT_EQ(content(image.root() / "srv/onggi/content/vessels/jar/vessel.toml"), "jar");
  EXPECT_EQ(content(image.root() / "srv/onggi/content/glazes.toml"), "glazes");
  EXPECT_EQ(content(image.root() / "srv/onggi/content/missions.toml"), "missions");
  EXPECT_TRUE(fs::is_directory(image.root() / "srv/onggi/keepsakes"));
  EXPECT_EQ(fs::read_symlink(image.root() / "etc/X11/xorg.conf.d/90-onggi.conf"),
            "/usr/share/onggi/system/90-onggi.conf");
  EXPECT_TRUE(fs::exists(image.root() / "usr/share/onggi/system/90-onggi.conf"));
  EXPECT_TRUE(image.starts("onggi.service"));
  EXPECT_TRUE(image.starts("onggi-display.service"));
  EXPECT_FALSE(image.starts("getty@tty1.service", "getty"));
}

TEST(machine_setup, the_staffs_page_starts_with_the_machine_only_when_asked_to_and_undo_ends_that) {
  const Image image;
  good(set_up(image.options()));
  EXPECT_FALSE(image.starts("onggi-console.service"));
  SetupOptions options = image.options();
  options.console = "127.0.0.1";
  EXPECT_THAT(good(set_up(options)).changed,
              ElementsAre(HasSubstr("config"), HasSubstr("content"), HasSubstr("revisions"),
                          HasSubstr("onggi-console.service")))
      << "on a machine that is a kiosk already";
  EXPECT_TRUE(image.starts("onggi-console.service"));
  good(undo_setup(image.system()));
  EXPECT_FALSE(image.starts("onggi-console.service"));
}

TEST(machine_setup, a_second_setup_changes_nothing_and_leaves_what_the_museum_changed) {
  const Image image;
  good(set_up(image.options()));
  image.put("srv/onggi/config/exhibit.toml", "the museum's own title");
  const auto before = image.all();
  EXPECT_THAT(good(set_up(image.options())).changed, IsEmpty());
  EXPECT_EQ(image.all(), before);
}

TEST(machine_setup, a_dry_run_tells_the_same_changes_and_makes_none) {
  const Image image;
  const auto before = image.all();
  SetupOptions dry = image.options();
  dry.dry = true;
  const auto told = good(set_up(dry));
  EXPECT_EQ(image.all(), before);
  EXPECT_EQ(told.changed, good(set_up(image.options())).changed);
}

TEST(machine_setup, undo_gives_the_machine_back_and_the_museum_keeps_its_exhibit) {
  const Image image;
  auto before = image.all();
  good(set_up(image.options()));
  image.put("srv/onggi/keepsakes/jar/postcard.png", "a visitor's");
  good(undo_setup(image.system()));
  for (const auto& [file, held] : image.all())
    if (file.find("/srv/onggi/") == std::string::npos) {
      EXPECT_EQ(before[file], held) << file;
      before.erase(file);
    }
  EXPECT_THAT(before, IsEmpty());
  EXPECT_EQ(content(image.root() / "srv/onggi/keepsakes/jar/postcard.png"), "a visitor's");
  EXPECT_EQ(undo_setup(image.system()).error().exit_code, 2);
}

TEST(machine_setup, undo_leaves_what_somebody_put_in_its_place_since) {
  const Image image;
  good(set_up(image.options()));
  fs::remove(image.root() / "etc/X11/xorg.conf.d/90-onggi.conf");
  image.put("etc/X11/xorg.conf.d/90-onggi.conf", "another screen");
  const auto report = good(undo_setup(image.system()));
  EXPECT_EQ(content(image.root() / "etc/X11/xorg.conf.d/90-onggi.conf"), "another screen");
  EXPECT_THAT(report.stayed, Contains(HasSubstr("90-onggi.conf: stays")));
}

TEST(machine_setup, what_was_there_before_setup_stays_and_is_there_after_undo) {
  const Image image;
  image.put("etc/systemd/journald.conf.d/onggi.conf", "the machine's own log");
  EXPECT_THAT(good(set_up(image.options())).stayed, Contains(HasSubstr("the machine's own")));
  good(undo_setup(image.system()));
  EXPECT_EQ(content(image.root() / "etc/systemd/journald.conf.d/onggi.conf"),
            "the machine's own log");
}

TEST(machine_setup, undo_can_be_tried_first_and_changes_nothing_then) {
  const Image image;
  good(set_up(image.options()));
  const auto before = image.all();
  const auto told = good(undo_setup(image.system(), true));
  EXPECT_EQ(image.all(), before);
  const auto done = good(undo_setup(image.system()));
  EXPECT_EQ(told.changed, done.changed);
  EXPECT_EQ(told.stayed, done.stayed);
  EXPECT_EQ(undo_setup(image.system(), true).error().exit_code, 2);
}

TEST(machine_setup, a_vessel_that_the_museum_took_off_its_shelf_stays_off) {
  const Image image;
  good(set_up(image.options()));
  fs::remove_all(image.root() / "srv/onggi/content/vessels/jar");
  EXPECT_THAT(good(set_up(image.options())).changed, IsEmpty());
  EXPECT_FALSE(fs::exists(image.root() / "srv/onggi/content/vessels/jar"));
}

TEST(machine_setup, a_vessel_stays_off_its_shelf_on_a_machine_that_was_set_up_anew_too) {
  const Image image;
  good(set_up(image.options()));
  good(undo_setup(image.system()));
  good(set_up(image.options()));
  fs::remove_all(image.root() / "srv/onggi/content/vessels/jar");
  EXPECT_THAT(good(set_up(image.options())).changed, IsEmpty());
  EXPECT_FALSE(fs::exists(image.root() / "srv/onggi/content/vessels/jar"));
}

TEST(machine_setup, a_user_onggi_without_numbers_is_none) {
  for (const char* numbers : {":", "x:1", "1:x", "1x:1", "-1:1", "99999999999:1"}) {
    const Image image;
    image.put("etc/passwd", "onggi:x:" + std::string(numbers) + ":Onggi kiosk:/:/bin/false\n");
    const auto failed = set_up(image.options());
    ASSERT_FALSE(failed) << numbers;
    EXPECT_THAT(to_text(failed.error()), HasSubstr("no user onggi")) << numbers;
    EXPECT_EQ(failed.error().exit_code, 1) << numbers;
  }
}

TEST(machine_setup, a_keepsake_folder_of_somebody_else_is_given_to_the_kiosk) {
  if (getuid() != 0) GTEST_SKIP() << "only root gives a file to another";
  const Image image;
  const fs::path folder = image.root() / "srv/onggi/keepsakes";
  fs::create_directories(folder);
  ASSERT_EQ(chown(folder.c_str(), 4242, 4242), 0);
  EXPECT_THAT(good(set_up(image.options())).changed,
              Contains(HasSubstr("given to the user onggi")));
  struct stat now {};
  ASSERT_EQ(stat(folder.c_str(), &now), 0);
  EXPECT_EQ(now.st_uid, getuid());
}

/// As Debian starts gdm3 and lightdm: by a link of this name, and their units cannot be enabled.
TEST(machine_setup, a_desktop_is_replaced_only_when_asked_to_and_comes_back) {
  const Image image;
  const fs::path link = image.root() / "etc/systemd/system/display-manager.service";
  image.put("lib/systemd/system/gdm3.service", "[Service]\nExecStart=/bin/true\n");
  image.link("etc/systemd/system/display-manager.service", "/lib/systemd/system/gdm3.service");
  const auto before = image.all();
  const auto refused = set_up(image.options());
  ASSERT_FALSE(refused);
  EXPECT_THAT(to_text(refused.error()), HasSubstr("gdm3.service"));
  EXPECT_THAT(to_text(refused.error()), HasSubstr("--replace-desktop"));
  EXPECT_EQ(image.all(), before);

  SetupOptions replace = image.options();
  replace.replace_desktop = true;
  good(set_up(replace));
  EXPECT_FALSE(fs::is_symlink(link));
  good(undo_setup(image.system()));
  EXPECT_EQ(fs::read_symlink(link), "/lib/systemd/system/gdm3.service");
}

TEST(machine_setup, what_went_with_its_package_since_holds_up_no_undo) {
  const Image image;
  const fs::path link = image.root() / "etc/systemd/system/display-manager.service";
  image.link("etc/systemd/system/display-manager.service", "/lib/systemd/system/gdm3.service");
  SetupOptions replace = image.options();
  replace.replace_desktop = true;
  good(set_up(replace));
  fs::remove(image.root() / "lib/systemd/system/gdm3.service");
  fs::remove(image.root() / "lib/systemd/system/getty@.service");
  const auto report = good(undo_setup(image.system()));
  EXPECT_THAT(report.stayed, Contains(HasSubstr("display-manager.service: stays away")));
  EXPECT_THAT(report.stayed, Contains(HasSubstr("getty@tty1.service: stays as it is")));
  EXPECT_FALSE(fs::is_symlink(link));
  EXPECT_FALSE(image.starts("onggi.service"));
}

TEST(machine_setup, health_goes_to_node_exporter_where_there_is_one) {
  const Image image;
  EXPECT_THAT(good(set_up(image.options())).stayed, Contains(HasSubstr("left out")));
  const Image other;
  const std::string folder = "var/lib/prometheus/node-exporter";
  fs::create_directories(other.root() / folder);
  good(set_up(other.options()));
  EXPECT_EQ(fs::read_symlink(other.root() / folder / "onggi.prom"), "/run/onggi/onggi.prom");
}

TEST(machine_setup, a_step_that_fails_is_told_and_undo_takes_back_those_before_it) {
  const Image image;
  const auto before = image.all();
  image.put("etc/X11", "a file where a folder has to be");
  const auto failed = set_up(image.options());
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().exit_code, 1);
  fs::remove(image.root() / "etc/X11");
  EXPECT_THAT(good(undo_setup(image.system())).stayed, SizeIs(8));
  EXPECT_TRUE(image.starts("getty@tty1.service", "getty"));
  EXPECT_EQ(content(image.root() / "etc/passwd"), before.at(image.root() / "etc/passwd"));
}

}  // namespace
}  // namespace onggi::setup::machine_setup_test
