#include "kiosk/program/console/vessel_titles.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::console::vessel_titles_test {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;

class VesselTitlesTest : public ::testing::Test {
 protected:
  VesselTitlesTest() {
    fs::create_directories(site_ / "config");
    fs::create_directories(site_ / "content/vessels/jar");
    std::ofstream(site_ / "config/exhibit.toml") << "languages = [\"en\"]\n";
    write("Moon jar");
    auto found = Site::open(site_);
    EXPECT_TRUE(found);
    open_ = std::move(*found);
  }
  void write(const std::string& title) const {
    std::ofstream(site_ / "content/vessels/jar/vessel.toml")
        << "[label.en]\ntitle = \"" << title << "\"\n[label.ko]\ntitle = \"달항아리\"\n";
  }

  files::test::ScratchFolder scratch_;
  fs::path site_ = scratch_ / "site";
  std::optional<Site> open_;
};

TEST_F(VesselTitlesTest, AreThoseOfTheLabelInEachLanguage) {
  VesselTitles titles(*open_);
  EXPECT_THAT(titles.of("jar"), ElementsAre(Pair("en", "Moon jar"), Pair("ko", "달항아리")));
  EXPECT_EQ(titles.json_of("jar").text(-1), R"({"en":"Moon jar","ko":"달항아리"})");
  // A vessel that has gone, and names that lead out of the shelf.
  for (const char* other : {"", "gone", "..", ".", "../vessels/jar", "jar/../jar"})
    EXPECT_THAT(titles.of(other), IsEmpty()) << other;
}

TEST_F(VesselTitlesTest, FindAVesselByAWordInAnyLanguageAndCase) {
  VesselTitles titles(*open_);
  for (const char* words : {"moon", "JAR", "항아리", "달항아리"})
    EXPECT_TRUE(titles.has("jar", words)) << words;
  for (const char* words : {"bowl", "달 항아리"}) EXPECT_FALSE(titles.has("jar", words)) << words;
  EXPECT_FALSE(titles.has("gone", "moon"));
}

TEST_F(VesselTitlesTest, FollowTheLabelWhenItIsChanged) {
  VesselTitles titles(*open_);
  ASSERT_EQ(titles.of("jar").at("en"), "Moon jar");
  write("Round jar");
  const fs::path file = site_ / "content/vessels/jar/vessel.toml";
  fs::last_write_time(file, fs::last_write_time(file) + std::chrono::seconds(2));
  EXPECT_EQ(titles.of("jar").at("en"), "Round jar");
}

}  // namespace
}  // namespace onggi::console::vessel_titles_test
