#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/kiosk/program/commands/program.h"

namespace onggi::commands::decorate_test {
namespace {

namespace fs = std::filesystem;

const std::string kWords = " --sources 'A book' --simplified 'Nothing'";

/// An exhibit with a shelf of its own, on which a drawn jar and a scan stand.
class Decorating : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_ / "shelf");
    for (const char* id : {"jar", "scan"})
      fs::copy("content/vessels/moon_jar", folder_ / "shelf" / id);
    std::string toml = content(folder_ / "shelf/scan/vessel.toml");
    toml.erase(0, toml.find('\n') + 1);
    std::ofstream(folder_ / "shelf/scan/vessel.toml") << toml;
    std::ofstream(folder_ / "exhibit.toml")
        << "shelf = \"shelf\"\nglazes = \"" << fs::current_path().string()
        << "/content/glazes.toml\"\nscene = \"" << fs::current_path().string()
        << "/config/scenes/first_touch.toml\"\nways = \"" << fs::current_path().string()
        << "/content/ways\"\n";
  }
  /// What it says of a wrong command line, before any window opens.
  std::string said(const std::string& arguments, int exit_code = 2) {
    const Outcome run = onggi("vessel decorate --config '" + (folder_ / "exhibit.toml").string() +
                              "' " + arguments);
    EXPECT_EQ(run.exit_code, exit_code) << arguments << run.err;
    EXPECT_EQ(run.out, "") << arguments;
    return run.err;
  }
  ScratchFolder folder_;
};

TEST_F(Decorating, NamesTheNearestVesselForOneThatIsNotThere) {
  EXPECT_NE(said("jarr" + kWords).find("Did you mean jar?"), std::string::npos);
  EXPECT_NE(said("../shelf/jar" + kWords).find("no such vessel"), std::string::npos);
}

TEST_F(Decorating, AScanKeepsItsOwnColours) {
  EXPECT_NE(said("scan" + kWords).find("has no drawing"), std::string::npos);
}

TEST_F(Decorating, WritesOverNothing) {
  const fs::path own = folder_ / "shelf/jar/decoration.toml", other = folder_ / "other.toml";
  std::ofstream(own) << "mine";
  EXPECT_NE(said("jar" + kWords).find("not overwritten"), std::string::npos);
  EXPECT_EQ(content(own), "mine");
  fs::create_symlink("/nowhere", other);
  EXPECT_NE(said("jar -o '" + other.string() + "'" + kWords).find("not overwritten"),
            std::string::npos);
}

TEST_F(Decorating, LooksBeforeTheWorkWhetherItCanBeKept) {
  EXPECT_NE(said("jar -o /nowhere/at/all.toml" + kWords).find("Create it first"),
            std::string::npos);
  EXPECT_NE(said("jar -o /proc/all.toml" + kWords, 1).find("/proc/all.toml"), std::string::npos);
  EXPECT_NE(said("jar -o /tmp" + kWords).find("It is a folder"), std::string::npos);
}

TEST_F(Decorating, AMissingDrawingOrExhibitIsToldByItsName) {
  fs::remove(folder_ / "shelf/jar/profile.toml");
  EXPECT_NE(said("jar" + kWords).find("profile.toml"), std::string::npos);
  fs::create_directory(folder_ / "shelf/empty");
  EXPECT_NE(said("empty" + kWords).find("vessel.toml"), std::string::npos);
  fs::remove(folder_ / "exhibit.toml");
  const std::string gone = said("jar" + kWords);
  EXPECT_NE(gone.find("exhibit.toml"), std::string::npos);
  EXPECT_EQ(gone.find("no such vessel"), std::string::npos) << gone;
}

TEST_F(Decorating, WantsToKnowWhereTheDecorationIsPublished) {
  EXPECT_NE(said("jar --simplified x").find("--sources"), std::string::npos);
  EXPECT_NE(said("jar --simplified x --sources ' '").find("--sources"), std::string::npos);
}

TEST_F(Decorating, WithoutADesktopItSaysSo) {
  EXPECT_NE(said("jar" + kWords, 1).find("DISPLAY"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder_ / "shelf/jar/decoration.toml")) << "nothing was drawn";
}

}  // namespace
}  // namespace onggi::commands::decorate_test
