#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "kiosk/program/setup/machine_setup.h"
#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::setup::test {

namespace fs = std::filesystem;

/// An image of a Debian with the package in it, small enough for a test. Its units are real ones to
/// systemctl, which changes an image as it does a machine.
class Image {
 public:
  Image() {
    give_users(getuid(), getgid(), getgid(), getgid());
    put("etc/hostname", "kiosk\n");
    put("usr/share/onggi/config/exhibit.toml", "title");
    put("usr/share/onggi/config/scenes/soft.toml", "clay");
    put("usr/share/onggi/content/vessels/jar/vessel.toml", "jar");
    put("usr/share/onggi/content/lessons/first.toml", "lesson");
    put("usr/share/onggi/content/ways/painted.toml", "way");
    put("usr/share/onggi/content/glazes.toml", "glazes");
    put("usr/share/onggi/content/missions.toml", "missions");
    put("usr/share/onggi/system/90-onggi.conf", "screen");
    put("usr/share/onggi/system/journald.conf", "log");
    link("lib", "usr/lib");
    for (const char* unit : {"onggi", "onggi-display", "onggi-console", "onggi-staff-web", "gdm3"})
      put("usr/lib/systemd/system/" + std::string(unit) + ".service",
          "[Service]\nExecStart=/bin/true\n[Install]\nWantedBy=multi-user.target\n");
    put("usr/lib/systemd/system/getty@.service",
        "[Service]\nExecStart=/bin/true\n[Install]\nWantedBy=getty.target\nDefaultInstance=tty1\n");
    link("etc/systemd/system/getty.target.wants/getty@tty1.service",
         "/usr/lib/systemd/system/getty@.service");
  }
  /// The kiosk's user, and the groups that share its folders, by these numbers.
  void give_users(uid_t kiosk, gid_t own, gid_t keepsakes, gid_t site) const {
    const auto text = [](auto number) { return std::to_string(number); };
    put("etc/passwd", "root:x:0:0:root:/root:/bin/sh\nonggi:x:" + text(kiosk) + ":" + text(own) +
                          ":Onggi kiosk:/var/lib/onggi:/bin/false\n");
    put("etc/group", "root:x:0:\nonggi:x:" + text(own) + ":\nonggi-keepsakes:x:" + text(keepsakes) +
                         ":\nonggi-site:x:" + text(site) +
                         ":\nonggi-staff-web:x:" + text(getgid()) + ":\n");
  }
  System system() const { return {root()}; }
  SetupOptions options() const { return {.system = system()}; }
  fs::path root() const { return folder_.path(); }
  void put(const std::string& name, const std::string& text) const {
    fs::create_directories((root() / name).parent_path());
    std::ofstream(root() / name) << text;
  }
  void link(const std::string& name, const std::string& to) const {
    fs::create_directories((root() / name).parent_path());
    fs::create_symlink(to, root() / name);
  }
  bool starts(const std::string& unit, const std::string& target = "multi-user") const {
    return fs::is_symlink(root() / ("etc/systemd/system/" + target + ".target.wants/" + unit));
  }
  /// Every file and link with what it holds. Debian 12's systemctl says /lib for /usr/lib.
  std::map<std::string, std::string> all() const {
    std::map<std::string, std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(root()))
      if (entry.is_symlink())
        found[entry.path().string()] =
            (fs::read_symlink(entry.path()).string().starts_with("/lib/") ? "/usr" : "") +
            fs::read_symlink(entry.path()).string();
      else if (entry.is_regular_file())
        found[entry.path().string()] = files::test::content(entry.path());
    return found;
  }

 private:
  files::test::ScratchFolder folder_;
};

inline SetupReport good(const Result<SetupReport>& report) {
  EXPECT_TRUE(report) << (report ? "" : to_text(report.error()));
  return report ? *report : SetupReport{};
}

}  // namespace onggi::setup::test
