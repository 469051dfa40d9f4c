#include "kiosk/collection/content/glaze.h"

#include <gmock/gmock.h>

#include "tests/kiosk/collection/content/temporary.h"

namespace onggi::content::glaze_test {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class GlazeTest : public Temporary {
 protected:
  GlazesRead read(const std::string& text) {
    return read_glazes(write("glazes.toml", text), {"en", "ko"});
  }
  static std::string glaze(const std::string& id, const std::string& more = "") {
    return "[[glaze]]\nid = \"" + id + "\"\nname = { en = \"Ash\", ko = \"재\" }\n" +
           "body = \"#804020\"\nglass = \"#FFFFFF\"\n" + more;
  }
};

TEST(Glazes, TheExhibitsOwnAreWithoutFaultAndAtLeastThree) {
  const GlazesRead r = read_glazes("content/glazes.toml", {"en", "ko"});
  EXPECT_THAT(r.problems, IsEmpty()) << to_text(r.problems.front());
  EXPECT_GE(r.glazes.size(), 3u);
  for (const Glaze& glaze : r.glazes) EXPECT_FALSE(glaze.about_in("ko").empty()) << glaze.id;
  EXPECT_EQ(r.glazes.front().id, "celadon");
}

TEST(Glazes, ACeladonIsGreenTenmokuNearlyBlackAndPorcelainNearlyWhite) {
  const auto all = read_glazes("content/glazes.toml", {"en"}).glazes;
  const auto of = [&](const std::string& id) {
    for (const Glaze& glaze : all)
      if (glaze.id == id) return swatch(glaze.look);
    ADD_FAILURE() << id;
    return LinearColor{};
  };
  EXPECT_GT(of("celadon")[1], of("celadon")[0]);
  for (const float channel : of("tenmoku")) EXPECT_LT(channel, 0.06f);
  for (const float channel : of("white_porcelain")) EXPECT_GT(channel, 0.7f);
  EXPECT_GT(of("onggi")[0], 2 * of("onggi")[2]) << "brown";
}

// A visitor's pot is called by its glaze alone. What is painted on it, a visitor paints.
TEST(Glazes, NoneOfOursPaintsAnything) {
  const GlazesRead ours = read_glazes("content/glazes.toml", {"en"});
  ASSERT_FALSE(ours.glazes.empty());
  for (const Glaze& glaze : ours.glazes) EXPECT_EQ(glaze.look.band_width, 0.0f) << glaze.id;
}

TEST_F(GlazeTest, ACuratorAddsOneByWritingIt) {
  const GlazesRead r = read(glaze("ash", "gloss = 0.3\nband = \"#2F4B7C\"\nband_height = 0.5\n"));
  EXPECT_THAT(r.problems, IsEmpty()) << to_text(r.problems.front());
  ASSERT_THAT(r.glazes, SizeIs(1));
  const GlazeLook& look = r.glazes[0].look;
  EXPECT_EQ(r.glazes[0].name_in("ko"), "재");
  EXPECT_EQ(r.glazes[0].name_in("fr"), "Ash") << "a language without a name shows the English one";
  EXPECT_EQ(look.glass, (LinearColor{1, 1, 1}));
  EXPECT_NEAR(look.body[0], 0.2159, 1e-3);  // 128/255 as light
  EXPECT_EQ(look.gloss, 0.3f);
  EXPECT_EQ(look.slip_cover, 0.0f) << "no slip is written";
  EXPECT_EQ(look.band_height, 0.5f);
  EXPECT_GT(look.band_width, 0.0f);
}

TEST_F(GlazeTest, ASlipInOneIsToldWithItsPlaceAndTheOthersStand) {
  const GlazesRead r =
      read(glaze("ash") + "[[glaze]]\nid = \"Tea Dust\"\nname = { en = \"Tea dust\" }\n" +
           "body = \"brown\"\nglass = \"#12345\"\nglos = 0.5\npooling = 3\n" + glaze("rust"));
  EXPECT_THAT(r.glazes, SizeIs(2));
  ASSERT_THAT(r.problems, SizeIs(6));
  EXPECT_THAT(r.problems[0].where, EndsWith("glazes.toml:7:6"));
  EXPECT_THAT(r.problems[0].what, HasSubstr("\"Tea Dust\" is not a valid id"));
  EXPECT_THAT(r.problems[1].what, HasSubstr("no name in the language \"ko\""));
  EXPECT_THAT(r.problems[2].what, HasSubstr("\"brown\" is not a valid colour"));
  EXPECT_THAT(r.problems[3].what, HasSubstr("\"#12345\" is not a valid colour"));
  EXPECT_THAT(r.problems[4].remedy, HasSubstr("Did you mean gloss"));
  EXPECT_THAT(r.problems[5].what, HasSubstr("pooling is 3"));
  for (const Problem& p : r.problems) EXPECT_FALSE(p.remedy.empty());
}

TEST_F(GlazeTest, ANumberThatIsNoGoodKeepsItsDefaultAndTheGlazeItsPlace) {
  const GlazesRead r = read(glaze("ash", "gloss = 7\n"));
  EXPECT_THAT(r.problems, SizeIs(1));
  ASSERT_THAT(r.glazes, SizeIs(1));
  EXPECT_EQ(r.glazes[0].look.gloss, GlazeLook{}.gloss);
}

TEST_F(GlazeTest, TwoOfOneIdAndMoreThanAScreenHoldsAreTold) {
  EXPECT_THAT(read(glaze("ash") + glaze("ash")).problems.at(0).what, HasSubstr("two glazes"));
  std::string many;
  for (int i = 0; i < 9; ++i) many += glaze("ash_" + std::to_string(i));
  const GlazesRead r = read(many);
  EXPECT_THAT(r.glazes, SizeIs(kMostGlazes));
  EXPECT_THAT(r.problems, SizeIs(1));
}

TEST_F(GlazeTest, WhatIsNoFileOfGlazesSaysSo) {
  EXPECT_THAT(read("").problems.at(0).what, HasSubstr("no glaze"));
  EXPECT_THAT(read("glaze = 3\n").problems, SizeIs(1));
  EXPECT_THAT(read("[[glaze]\n").problems, SizeIs(1));
  EXPECT_THAT(read_glazes(folder_ / "absent.toml").problems, SizeIs(1));
  const GlazesRead r = read("[[glaze]]\n");
  EXPECT_THAT(r.glazes, IsEmpty());
  EXPECT_THAT(r.problems, SizeIs(5));  // id, two names, body, glass
}

}  // namespace
}  // namespace onggi::content::glaze_test
