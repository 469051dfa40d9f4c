#include "kiosk/collection/settings/keepsake_place.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/kiosk/collection/settings/all_problems.h"
#include "tests/kiosk/ground/files/disk.h"

namespace onggi::settings::keepsake_place_test {
namespace {

namespace fs = std::filesystem;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// A museum's folder: exhibit/exhibit.toml, config/exhibit.toml, content/vessels.
class KeepsakePlace : public ::testing::Test {
 protected:
  KeepsakePlace() {
    for (const char* folder :
         {"exhibit/scenes", "config/scenes", "content/vessels", "content/languages"})
      fs::create_directories(museum_.path() / folder);
    for (const char* file :
         {"exhibit/scenes/first_touch.toml", "config/scenes/first_touch.toml",
          "content/glazes.toml", "content/languages/en.toml", "content/languages/ko.toml"})
      std::ofstream(museum_.path() / file) << "";
  }
  ExhibitRead read(const std::string& text) const {
    const fs::path file = museum_.path() / "exhibit/exhibit.toml";
    std::ofstream(file) << text;
    return read_exhibit(file, museum_.path() / "content/languages");
  }
  files::test::ScratchFolder museum_;
};

TEST_F(KeepsakePlace, keepsakes_never_lie_in_the_content_nor_the_shelf_among_the_keepsakes) {
  fs::create_directory_symlink(museum_.path() / "content/vessels", museum_.path() / "pots");
  for (const char* folder :
       {"../content/vessels", "../content/vessels/kept", "../pots", "../content/vessels/",
        "../content/languages/kept", "..", "../content"}) {
    const ExhibitRead r = read(std::string("[keepsake]\nfolder = \"") + folder + "\"\n");
    ASSERT_THAT(r.problems, SizeIs(1)) << folder << all(r.problems);
    EXPECT_THAT(r.problems[0].where, EndsWith("exhibit.toml:2:10")) << folder;
    EXPECT_THAT(r.problems[0].what, HasSubstr("keepsakes")) << folder;
  }
  for (const char* folder : {"../keepsakes", "../content_kept", "/var/lib/onggi/keepsakes"})
    EXPECT_THAT(read(std::string("[keepsake]\nfolder = \"") + folder + "\"\n").problems, IsEmpty())
        << folder;
}

TEST_F(KeepsakePlace, nor_in_a_site_that_is_copied_as_the_last_good_one) {
  const fs::path file = museum_.path() / "config/exhibit.toml";
  for (const char* folder : {"kept", "../content/kept"}) {
    std::ofstream(file) << "[keepsake]\nfolder = \"" << folder << "\"\n";
    const ExhibitRead r = read_exhibit(file, museum_.path() / "content/languages");
    ASSERT_THAT(r.problems, SizeIs(1)) << folder << all(r.problems);
    EXPECT_THAT(r.problems[0].what, HasSubstr("The keepsakes would lie in")) << folder;
  }
}

TEST_F(KeepsakePlace, nor_where_no_folder_can_be) {
  fs::create_directory_symlink("round", museum_.path() / "round");
  for (const auto& [folder, why] : {std::pair{std::string("exhibit.toml/kept"), "is a file, so"},
                                    {"../round/kept", "leads back to itself"},
                                    {"/proc/kept", "/proc is the system's own"},
                                    {"/dev", "/dev is the system's own"},
                                    {"../" + std::string(256, 'k'), "a name of 256 bytes"}}) {
    const ExhibitRead r = read("[keepsake]\nfolder = \"" + folder + "\"\n");
    ASSERT_THAT(r.problems, SizeIs(1)) << folder << all(r.problems);
    EXPECT_THAT(r.problems[0].what, HasSubstr(why));
  }
  std::string deep = "..";
  for (int i = 0; i < 20; ++i) deep += "/" + std::string(200, 'd');
  EXPECT_THAT(all(read("[keepsake]\nfolder = \"" + deep + "\"\n").problems),
              HasSubstr("path is too long"));
}

}  // namespace
}  // namespace onggi::settings::keepsake_place_test
