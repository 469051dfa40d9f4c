#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

#include "kiosk/exhibit/rehearsal/screen_tour.h"
#include "tests/kiosk/program/commands/program.h"

namespace onggi::commands::screen_test {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kTwo = {"moon_jar", "tea_bowl"};

/// An exhibit with two vessels, and a folder for pictures.
class Screen : public ::testing::Test {
 protected:
  /// `onggi screen WORDS` of a small picture.
  Outcome screen(const std::string& words) const {
    return onggi("screen --config " + exhibit_ + " --out " + out() + " " + words);
  }
  std::string out() const { return (folder_ / "pictures").string(); }
  std::string picture(const std::string& name) const {
    return content(fs::path(out()) / (name + ".png"));
  }

  const ScratchFolder folder_;
  const std::string exhibit_ =
      write_exhibit(folder_, "first_touch",
                    "ways = \"" + fs::current_path().string() +
                        "/content/ways\"\nlanguages = [\"en\", \"ko\"]\n[title]\nen = \"Clay\"\nko "
                        "= \"흙\"\n[keepsake]\nfolder = "
                        "\"kept\"\n",
                    kTwo);
};

/// Width or height in a PNG.
int pixels(const std::string& png, std::size_t at) {
  int value = 0;
  for (std::size_t n = at; n < at + 4 && n < png.size(); ++n)
    value = 256 * value + static_cast<unsigned char>(png[n]);
  return value;
}

TEST_F(Screen, OfEveryNameIsAPictureOfItsOwn) {
  std::set<std::string> seen;
  for (const std::string_view name : rehearsal::toured_screens()) {
    const std::string screen_name(name);
    const Outcome run = screen("--sizes 480x270 " + screen_name);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const std::string png = picture(screen_name + "_en_480x270");
    EXPECT_EQ(pixels(png, 16), 480) << screen_name;
    EXPECT_EQ(pixels(png, 20), 270) << screen_name;
    // Without what the file says of itself: its pixels.
    EXPECT_TRUE(seen.insert(png.substr(png.find("IDAT"))).second) << screen_name;
  }
  EXPECT_FALSE(fs::exists(folder_ / "kept")) << "the museum's keepsakes are not its place";
}

TEST_F(Screen, IsDrawnWithAChangeThatIsNotMade) {
  const std::string before = content(exhibit_);
  const auto drawn = [this](const std::string& words, const std::string& name) {
    EXPECT_EQ(screen(words + " --sizes 480x270,320x480").exit_code, 0) << words;
    EXPECT_NE(picture(name + "_480x270"), "") << words;
    return picture(name + "_320x480");
  };
  const std::string now = drawn("attract", "attract_en");
  const std::string with = "attract --of " + exhibit_;
  EXPECT_TRUE(drawn("attract", "attract_en") == now) << "the same is drawn as the same";
  EXPECT_FALSE(drawn(with + " title.en 'Pots for all'", "attract_en") == now);
  EXPECT_FALSE(drawn("attract --comfort larger_text", "attract_en") == now);
  drawn(with + " languages ko,en", "attract_ko");
  drawn(with + " --without languages", "attract_en");
  EXPECT_EQ(content(exhibit_), before);
}

TEST_F(Screen, OfAVesselThatVisitorsDoNotSeeYetIsDrawnTheSame) {
  const auto label = [this] {
    const Outcome run = screen("--sizes 480x270 --vessel tea_bowl label");
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const std::string png = picture("label_en_480x270");
    fs::remove_all(out());
    return png;
  };
  EXPECT_NE(label(), "");
  const fs::path file = folder_ / "shelf/tea_bowl/vessel.toml";
  const std::string text = content(file);
  std::ofstream(file) << "unfinished = true\n" << text;
  EXPECT_NE(label(), "") << "one that is unfinished";
}

TEST_F(Screen, ThatCannotBeIsToldWithTheNearestName) {
  const auto told = [this](const std::string& words, const std::string& what) {
    const Outcome run = screen(words);
    EXPECT_EQ(run.exit_code, 2) << words;
    EXPECT_NE(run.err.find(what), std::string::npos) << words << ": " << run.err;
    EXPECT_FALSE(fs::exists(out())) << words;
  };
  told("lable", "Did you mean label?");
  told("label --comfort large_text", "Did you mean larger_text?");
  told("label --vessel moonjar", "Did you mean moon_jar?");
  told("label --language xx", "xx");
  told("label --sizes 12x12", "320x240");
  told("label --sizes ,", "320x240");
  told("label --sizes 1280x720,,640x480", "320x240");
  told("label --sizes 7680x4320", "at most 4096 pixels");
  told("", "No screen is named");
  const std::string other = (folder_ / "other.toml").string();
  std::ofstream(other) << "credit = \"Another museum\"\n";
  told("comfort --sizes 320x240 --of " + other + " credit Mine", "does not use this file");
  told("label title.en Pot", "--of config/exhibit.toml");
  told("label --of " + exhibit_ + " titel.en Pot", "not a key of this file");
  told("label --of " + exhibit_ + " title.en", "has no value");
  told("--asked", "names no screen");
}

}  // namespace
}  // namespace onggi::commands::screen_test
