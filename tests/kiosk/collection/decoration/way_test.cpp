#include "kiosk/collection/decoration/way.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::decoration::way_test {
namespace {

const std::vector<std::string> kLanguages{"en", "ko", "es", "fr", "de", "ja", "zh", "ar"};

WayRead read(const std::string& text, const std::vector<std::string>& languages = {"en"}) {
  const files::test::ScratchFolder folder;
  const std::string file = folder / "trial.toml";
  std::ofstream(file) << text;
  return read_way(file, languages);
}

constexpr const char* kHead =
    "sources = \"a book\"\nsimplified = \"nothing\"\nname = { en = \"Way\" }\n"
    "about = { en = \"Do it.\" }\n"
    "[pigment.white]\ncolor = \"#FFFFFF\"\nraw = \"#000000\"\nhides_um = 50\nname.en = \"White\"\n"
    "[pigment.red]\ncolor = \"#FF0000\"\nname.en = \"Red\"\n"
    "[[motif.leaf.line]]\npoints = [[0, -0.5], [0, 0.5]]\n[motif.leaf.name]\nen = \"Leaf\"\n";

std::string tool(const std::string& keys) {
  return "[[tool]]\n" + keys +
         "name = { en = \"Tool\" }\nhow = { en = \"So.\" }\ndid = { en = \"done\" }\n";
}

TEST(Way, HasItsToolsWithTheirLaws) {
  const WayRead found = read(
      kHead +
      tool("id = \"band\"\nlaw = \"brush\"\nhand = \"ring\"\nwith = [\"red\", \"white\"]\n"
           "width_mm = 5\nthickness_um = 90\n") +
      tool("id = \"leaf\"\nlaw = \"cut\"\nhand = \"figure\"\nmotifs = [\"leaf\"]\n"
           "section = \"flat\"\ndepth_mm = 0.6\nsize_mm = 25\nrepeats = 5\nneeds = \"band\"\n") +
      tool("id = \"glaze\"\nlaw = \"dip\"\nhand = \"all\"\n"));
  ASSERT_TRUE(found.problems.empty()) << to_text(found.problems[0]);
  const Way& way = found.way;
  EXPECT_EQ(way.id, "trial");
  ASSERT_EQ(way.tools.size(), 3u);
  const auto& brush = std::get<surface::BrushDef>(way.tools[0].law);
  EXPECT_EQ(way.tools[0].pigments, (std::vector<int>{1, 0}));
  EXPECT_EQ(brush.pigment, 1);
  EXPECT_DOUBLE_EQ(brush.width, 0.005);
  EXPECT_DOUBLE_EQ(brush.thickness, 9e-5);
  const auto& cut = std::get<surface::CutDef>(way.tools[1].law);
  EXPECT_EQ(cut.section, surface::CutDef::flat);
  EXPECT_DOUBLE_EQ(cut.depth, 6e-4);
  EXPECT_EQ(way.tools[1].needs, 0);
  EXPECT_EQ(way.tools[1].repeats, 5);
  EXPECT_EQ(std::get<surface::DipDef>(way.tools[2].law).coat, surface::DipDef::kGlaze);
  EXPECT_EQ(way.palette.pigments[0].raw[0], 0.0f);
  EXPECT_EQ(way.palette.pigments[1].raw, way.palette.pigments[1].fired);
}

TEST(Way, AToolMayNameTheStateThatItsClayMustBeIn) {
  const WayRead found =
      read(kHead + tool("id = \"cut\"\nlaw = \"cut\"\nhand = \"line\"\nstate = \"leather\"\n") +
           tool("id = \"glaze\"\nlaw = \"dip\"\nhand = \"all\"\nstate = \"fired\"\n") +
           tool("id = \"finger\"\nlaw = \"wipe\"\nhand = \"line\"\n"));
  ASSERT_TRUE(found.problems.empty()) << to_text(found.problems[0]);
  EXPECT_EQ(found.way.tools[0].state, WayTool::leather);
  EXPECT_EQ(found.way.tools[1].state, WayTool::fired);
  EXPECT_FALSE(found.way.tools[2].state);
}

TEST(Way, InAnExhibitATextNeedsEnglishWhichStandsInForALanguageThatLacksIt) {
  std::string text = kHead + tool("id = \"a\"\nlaw = \"scrape\"\nhand = \"ring\"\n");
  ASSERT_TRUE(read(text, {}).problems.empty());
  text.replace(text.find("how = { en"), 10, "how = { fr");
  const WayRead found = read(text, {});
  ASSERT_EQ(found.problems.size(), 1u);
  EXPECT_EQ(found.problems[0].what, "There is no how in English.");
}

TEST(Way, EachFaultHasItsLineAndARemedy) {
  const auto fault = [](const std::string& more) {
    const WayRead found = read(kHead + more);
    EXPECT_EQ(found.problems.size(), 1u) << more;
    if (found.problems.empty()) return std::string();
    EXPECT_NE(found.problems[0].where.find("trial.toml:"), std::string::npos);
    EXPECT_FALSE(found.problems[0].remedy.empty());
    return found.problems[0].what;
  };
  const std::string good = tool("id = \"a\"\nlaw = \"scrape\"\nhand = \"ring\"\n");
  EXPECT_EQ(fault(good + tool("id = \"b\"\nlaw = \"brush\"\nhand = \"ring\"\nwith = [\"blue\"]\n")),
            "there is no pigment \"blue\".");
  EXPECT_EQ(fault(good + tool("id = \"b\"\nlaw = \"smoke\"\nhand = \"ring\"\n")),
            "a tool of this law cannot be led by \"ring\".");
  EXPECT_EQ(fault(good + tool("id = \"b\"\nlaw = \"weave\"\nhand = \"ring\"\n")),
            "There is no law \"weave\".");
  EXPECT_EQ(fault(good + tool("id = \"b\"\nlaw = \"wipe\"\nhand = \"line\"\nneeds = \"dip\"\n")),
            "no tool before this one is called \"dip\".");
  EXPECT_EQ(fault(good + tool("id = \"a\"\nlaw = \"wipe\"\nhand = \"line\"\n")),
            "there are two tools \"a\".");
  EXPECT_EQ(fault(good + tool("id = \"b\"\nlaw = \"cut\"\nhand = \"line\"\nrepeats = 7\n")),
            "repeats is not 5, 8, 10 or 12.");
  EXPECT_EQ(fault(good + tool("id = \"b\"\nlaw = \"cut\"\nhand = \"line\"\nstate = \"wet\"\n")),
            "There is no state \"wet\".");
  EXPECT_EQ(fault(""), "the way has no tool.");
  EXPECT_EQ(fault(good + tool("id = \"b\"\nlaw = \"cut\"\nhand = \"figure\"\nmotifs = []\n")),
            "the tool names no motif.");
  EXPECT_EQ(fault(good + tool("id = \"b\"\nlaw = \"brush\"\nhand = \"line\"\nwith = []\n")),
            "the tool names no pigment.");
  EXPECT_EQ(fault(good + tool("id = \"b\"\nhand = \"line\"\nwidth_mm = 3\n")),
            "tool[1].law is missing.");
  EXPECT_EQ(fault(good + tool("id = \"b\"\nlaw = \"stamp\"\nhand = \"figure\"\n"
                              "motifs = [\"leaf\"]\nsize_mm = 8\n")),
            "the figure \"leaf\" has no area, so a stamp of it presses nothing.");
  EXPECT_EQ(fault(good + tool("id = \"b\"\nlaw = \"coil\"\nhand = \"line\"\n")),
            "a tool of this law cannot be led by \"line\".");
  EXPECT_EQ(fault(good + "[[motif.thin.fill]]\npoints = [[0, 0], [0.2, 0.2], [0.4, 0.4]]\n"
                         "[motif.thin.name]\nen = \"Thin\"\n"),
            "the area has no width: its points lie on one line.");
  EXPECT_EQ(fault(good + "[[motif.dot.line]]\npoints = [[0.1, 0], [0.1, 0]]\n"
                         "[motif.dot.name]\nen = \"Dot\"\n"),
            "the line has no length: its points lie on one place.");
  EXPECT_EQ(fault(good + "[[motif.far.line]]\npoints = [[0, 0], [0, 1.2]]\n"
                         "[motif.far.name]\nen = \"Far\"\n"),
            "the figure \"far\" has a point more than 0.5 above or below its middle.");
  EXPECT_EQ(fault(good + "[[motif.far.line]]\npoints = [[0, 0], [1.2, 0]]\n"
                         "[motif.far.name]\nen = \"Far\"\n"),
            "the figure \"far\" has a point more than 1 beside its middle.");
  EXPECT_EQ(fault(good + tool("id = \"b\"\nlaw = \"brush\"\nhand = \"ring\"\n"
                              "with = [\"red\", \"white\", \"red\"]\n")),
            "\"red\" is named twice.");
  EXPECT_EQ(fault(good + tool("id = \"b\"\nlaw = \"cut\"\nhand = \"figure\"\n"
                              "motifs = [\"leaf\", \"leaf\"]\n")),
            "\"leaf\" is named twice.");
  EXPECT_EQ(fault(good + tool("id = \"b\"\nlaw = \"cut\"\nhand = \"ring\"\nrepeats = 8\n")),
            "repeats has no use here: only a line or a figure comes back.");
  for (const char* teeth : {"", "teeth = 1\n"})
    EXPECT_EQ(fault(good + tool("id = \"b\"\nlaw = \"cut\"\nhand = \"line\"\n" +
                                std::string(teeth) + "spacing_mm = 2\n")),
              "spacing_mm has no use here: the tool has one tooth.");
  EXPECT_EQ(fault(good + tool("id = \"b\"\nlaw = \"cut\"\nhand = \"line\"\nteeth = 12\n"
                              "spacing_mm = 2\n")),
            "tool[1].teeth is 12, but the largest allowed value is 9.");
  EXPECT_EQ(fault(good + "[[motif.dot.line]]\npoints = [[0], [0, 1]]\n"
                         "[motif.dot.name]\nen = \"Dot\"\n"),
            "motif.dot.line[0].points[0] is a list of 1, but must be a point.");
}

// Of 500 points, and a tool 40 mm wide: one touch took half a minute.
TEST(Way, AFigureThatWouldHoldUpTheScreenIsNamed) {
  std::string points;
  for (int n = 0; n < 400; ++n)
    points += (n == 0 ? "[" : ", [") + std::to_string(n % 2 == 0 ? -0.4 : 0.4) + ", " +
              std::to_string(-0.5 + n / 400.0) + ", \"corner\"]";
  const std::string scribble =
      "[[motif.scribble.line]]\npoints = [" + points + "]\n[motif.scribble.name]\nen = \"S\"\n";
  const auto with = [&](const std::string& keys) {
    return read(kHead + scribble +
                tool("id = \"a\"\nlaw = \"brush\"\nhand = \"figure\"\nwith = [\"red\"]\n"
                     "motifs = [\"scribble\"]\n" +
                     keys));
  };
  const WayRead found = with("size_mm = 100\nwidth_mm = 40\n");
  ASSERT_EQ(found.problems.size(), 1u);
  EXPECT_NE(found.problems[0].what.find("\"scribble\" are so long"), std::string::npos);
  EXPECT_TRUE(with("size_mm = 10\nwidth_mm = 2\n").problems.empty());
}

TEST(Way, OneMistakeInAToolIsOneMessageWhateverHangsOnIt) {
  const auto fault = [](const std::string& text) {
    const WayRead found = read(text);
    EXPECT_EQ(found.problems.size(), 1u) << text;
    return found.problems.empty() ? Problem{} : found.problems[0];
  };
  const std::string weave = tool("id = \"a\"\nlaw = \"weave\"\nhand = \"ring\"\n");
  EXPECT_EQ(fault(kHead + weave).what, "There is no law \"weave\".") << "its only tool";
  EXPECT_NE(fault(kHead + weave).where.find("trial.toml:19:"), std::string::npos)
      << fault(kHead + weave).where;
  const std::string needs = tool("id = \"b\"\nlaw = \"wipe\"\nhand = \"line\"\nneeds = \"a\"\n");
  EXPECT_EQ(fault(kHead + weave + needs).what, "There is no law \"weave\".");
  const std::string more = tool("id = \"b\"\nlaw = \"wipe\"\nhand = \"line\"\nmore = true\n");
  EXPECT_EQ(fault(kHead + weave + more).what, "There is no law \"weave\".");
  EXPECT_EQ(fault(kHead + tool("id = \"A B\"\nlaw = \"wipe\"\nhand = \"line\"\n") +
                  tool("id = \"b\"\nlaw = \"wipe\"\nhand = \"line\"\nneeds = \"A B\"\n"))
                .what,
            "\"A B\" is not a valid id.");
  // An area that cannot be read is no stamp without an area.
  EXPECT_EQ(fault(std::string(kHead) +
                  "[[motif.dot.fill]]\npoints = [[0, 0], [0.2, 0.2]]\n"
                  "[motif.dot.name]\nen = \"Dot\"\n" +
                  tool("id = \"b\"\nlaw = \"stamp\"\nhand = \"figure\"\n"
                       "motifs = [\"dot\"]\nsize_mm = 8\n"))
                .what,
            "it has 2 points, but needs 3 to 500.");
}

TEST(Way, APointIsSaidInTheOrderThatAFigureHas) {
  const WayRead found = read(kHead + tool("id = \"a\"\nlaw = \"scrape\"\nhand = \"ring\"\n") +
                             "[[motif.dot.line]]\npoints = [[0], [0, 1]]\n"
                             "[motif.dot.name]\nen = \"Dot\"\n");
  ASSERT_EQ(found.problems.size(), 1u);
  EXPECT_NE(found.problems[0].remedy.find("each [x, y], or [x, y, \"corner\"]"), std::string::npos)
      << found.problems[0].remedy;
}

TEST(Way, SaysFromWhereItIsKnown) {
  for (const char* key : {"sources", "simplified"}) {
    std::string text = kHead + tool("id = \"a\"\nlaw = \"scrape\"\nhand = \"ring\"\n");
    const auto from = text.find('"', text.find(key)) + 1;
    text.replace(from, text.find('"', from) - from, " ");
    const WayRead found = read(text);
    ASSERT_EQ(found.problems.size(), 1u);
    EXPECT_EQ(found.problems[0].what, std::string(key) + " is empty.");
    EXPECT_FALSE(found.problems[0].remedy.empty());
  }
}

TEST(Way, HasTheToolsBehindMore) {
  const std::string area =
      "[[motif.dot.fill]]\npoints = [[-0.4, -0.4], [0.4, -0.4], [0, 0.4]]\n[motif.dot.name]\n"
      "en = \"Dot\"\n";
  const WayRead found =
      read(kHead + area +
           tool("id = \"line\"\nlaw = \"brush\"\nhand = \"line\"\nwith = [\"red\"]\n"
                "load_mm = 250\n") +
           tool("id = \"comb\"\nlaw = \"cut\"\nhand = \"line\"\nteeth = 5\nspacing_mm = 2.5\n"
                "more = true\n") +
           tool("id = \"stamp\"\nlaw = \"stamp\"\nhand = \"figure\"\nmotifs = [\"dot\"]\n"
                "size_mm = 9\ndepth_mm = 0.7\nmore = true\n") +
           tool("id = \"wax\"\nlaw = \"resist\"\nhand = \"line\"\nwidth_mm = 9\nmore = true\n") +
           tool("id = \"chain\"\nlaw = \"coil\"\nhand = \"ring\"\nwidth_mm = 5\nheight_mm = 1.5\n"
                "marks = 48\nmore = true\n"));
  ASSERT_TRUE(found.problems.empty()) << to_text(found.problems[0]);
  const auto& tools = found.way.tools;
  ASSERT_EQ(tools.size(), 5u);
  EXPECT_FALSE(tools[0].more);
  EXPECT_DOUBLE_EQ(std::get<surface::BrushDef>(tools[0].law).reach, 0.25);
  EXPECT_TRUE(tools[1].more);
  EXPECT_EQ(std::get<surface::CutDef>(tools[1].law).teeth, 5);
  EXPECT_DOUBLE_EQ(std::get<surface::CutDef>(tools[1].law).spacing, 0.0025);
  EXPECT_DOUBLE_EQ(std::get<surface::StampDef>(tools[2].law).depth, 7e-4);
  EXPECT_DOUBLE_EQ(std::get<surface::ResistDef>(tools[3].law).width, 0.009);
  EXPECT_EQ(std::get<surface::CoilDef>(tools[4].law).marks, 48);
  EXPECT_DOUBLE_EQ(std::get<surface::CoilDef>(tools[4].law).height, 0.0015);
}

TEST(Way, HasSixToolsAtOnceAndAsManyMore) {
  const auto with = [](int shown, int more) {
    std::string text = kHead;
    for (int n = 0; n < shown + more; ++n)
      text += tool("id = \"t" + std::to_string(n) + "\"\nlaw = \"scrape\"\nhand = \"ring\"\n" +
                   (n < shown ? "" : "more = true\n"));
    const WayRead found = read(text);
    return found.problems.empty() ? std::string() : found.problems[0].what;
  };
  EXPECT_EQ(with(6, 6), "");
  EXPECT_EQ(with(7, 0), "there are more than 6 tools.");
  EXPECT_EQ(with(1, 7), "there are more than 6 tools with more = true.");
  EXPECT_EQ(with(0, 1), "the first tool has more = true, but the screen begins with it.");
}

TEST(Way, ATextThatALanguageLacksIsNamed) {
  const WayRead found =
      read(kHead + tool("id = \"a\"\nlaw = \"scrape\"\nhand = \"ring\"\n"), {"en", "de"});
  EXPECT_EQ(found.problems.size(), 8u);
  EXPECT_NE(found.problems[0].what.find("\"de\""), std::string::npos);
}

// Repeats of less than five are a visitor's free strokes, which others must not see.
TEST(Way, ThatComesWithOnggiIsGoodInEveryLanguageAndNothingInItStandsAlone) {
  int ways = 0;
  for (const auto& file : std::filesystem::directory_iterator("content/ways")) {
    const WayRead found = read_way(file.path(), kLanguages);
    EXPECT_TRUE(found.problems.empty()) << to_text(found.problems[0]);
    for (const WayTool& tool : found.way.tools) EXPECT_GE(tool.repeats, 5) << tool.id;
    ++ways;
  }
  EXPECT_GE(ways, 11);
  for (const int repeats : kRepeats) EXPECT_GE(repeats, 5);
}

}  // namespace
}  // namespace onggi::decoration::way_test
