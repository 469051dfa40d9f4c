#include "kiosk/collection/decoration/write_decoration.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "kiosk/collection/content/model.h"
#include "kiosk/collection/decoration/decorate.h"
#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::decoration::write_decoration_test {
namespace {

DecorationRead read_back(const std::string& text) {
  const files::test::ScratchFolder folder;
  const std::string file = folder / "decoration.toml";
  std::ofstream(file) << text;
  return check_decoration(file);
}

/// A jar of 300 mm.
std::uint64_t hash_of(const Decoration& decoration) {
  const Profile jar{
      {{0.0, 0.080, 0.0}, {0.010, 0.085, 0.076}, {0.150, 0.120, 0.112}, {0.300, 0.070, 0.064}}};
  const auto surface = decorated(jar, decoration, "jar");
  EXPECT_TRUE(surface) << (surface ? "" : to_text(surface.error()));
  return surface ? surface->hash() : 0;
}

TEST(WriteDecoration, EveryVesselsFileIsReadBackToTheBit) {
  int files = 0;
  for (const auto& folder : std::filesystem::directory_iterator("content/vessels")) {
    const auto file = folder.path() / "decoration.toml";
    if (!std::filesystem::exists(file)) continue;
    ++files;
    const auto first = read_decoration(file);
    ASSERT_TRUE(first) << to_text(first.error());
    const std::string text = to_toml(*first);
    const DecorationRead second = read_back(text);
    ASSERT_TRUE(second.problems.empty()) << to_text(second.problems.front());
    EXPECT_EQ(to_toml(second.decoration), text) << file;
    const auto drawing = content::read_drawing(folder.path() / "profile.toml");
    ASSERT_TRUE(drawing) << to_text(drawing.error());
    const auto before = content::decorated(*drawing, *first, "vessel"),
               after = content::decorated(*drawing, second.decoration, "vessel");
    ASSERT_TRUE(before && after) << file;
    EXPECT_EQ(after->hash(), before->hash()) << file;
    EXPECT_EQ(second.decoration.body, first->body);
    EXPECT_EQ(second.decoration.sources, first->sources);
  }
  EXPECT_GE(files, 10);
}

TEST(WriteDecoration, NumbersAreWrittenAsPeopleWriteThem) {
  Decoration coated;
  coated.sources = "A book", coated.simplified = "Nothing";
  coated.pigments = {{"white", {1.0f, 1.0f, 1.0f}, kept_length(8e-5, 1e-6)}};
  Step coat;
  coat.kind = Step::coat;
  coat.from = kept_share(2e-5), coat.thickness = kept_length(2e-4, 1e-6);
  coated.steps = {coat};
  const std::string text = to_toml(coated);
  for (const char* line : {"hides_um = 80\n", "thickness_um = 200\n", "from = 0.00002\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
}

TEST(WriteDecoration, EveryKindOfStepKeepsWhatItHas) {
  Decoration all;
  all.sources = "line\n\"quote\" \\ \x01", all.simplified = "한국어";
  all.pigments = {{"blue two", {0.0f, 0.0f, 1.0f}, kept_length(2e-5, 1e-6)}};
  for (std::size_t kind = 0; kind < kKindNames.size(); ++kind) {
    Step step;
    step.kind = static_cast<Step::Kind>(kind);
    step.inside = kind % 2 == 1, step.from = 0.125, step.to = 0.5, step.at = kept_share(1.0 / 3);
    step.fill = 0.67, step.load = 0.15, step.depth = 0.004, step.height = 0.003, step.marks = 40;
    step.section = surface::CutDef::flat, step.teeth = 3, step.seed = 5, step.turn = 0.75;
    step.width = kept_length(0.01 / 3, 1e-3), step.thickness = kept_length(1e-4, 1e-6);
    step.says = "Done.";
    if (step.kind == Step::paint || step.kind == Step::stamp || step.kind == Step::scrape) {
      step.motif = motif_of("dot", {{{{-0.4, -0.4}, {0.4, -0.4, true}, {0.0, 0.4}}}, {}});
      step.repeat = 5;
    }
    all.steps.push_back(step);
  }
  Step over = all.steps[Step::burnish];
  over.zone = true;
  all.steps.push_back(over);
  const DecorationRead read = read_back(to_toml(all));
  ASSERT_TRUE(read.problems.empty()) << to_text(read.problems.front()) << to_toml(all);
  EXPECT_EQ(to_toml(read.decoration), to_toml(all));
  EXPECT_EQ(read.decoration.sources, all.sources);
  EXPECT_EQ(hash_of(read.decoration), hash_of(all));
  const auto& steps = read.decoration.steps;
  EXPECT_EQ(steps[Step::paint].load, 0.15);
  EXPECT_EQ(steps[Step::cut].section, surface::CutDef::flat);
  EXPECT_EQ(steps[Step::cut].teeth, 3);
  EXPECT_EQ(steps[Step::coil].marks, 40);
  EXPECT_EQ(steps[Step::coil].width, all.steps[Step::coil].width);
  EXPECT_EQ(steps[Step::smoke].seed, 5);
  EXPECT_FALSE(steps[Step::burnish].zone);
  EXPECT_TRUE(steps.back().zone);
  EXPECT_EQ(steps[Step::stamp].motif.drawn, all.steps[Step::stamp].motif.drawn);
}

TEST(WriteDecoration, AMotifThatComesAgainIsWrittenOnceAndOneOfTheSameNameGetsAnother) {
  const Motif dot = motif_of("dot", {{}, {{{0.0, 0.0, true}, {0.5, 0.0, true}}}});
  const Motif other = motif_of("dot", {{}, {{{0.0, 0.0}, {0.0, 0.5}}}});
  Decoration twice;
  twice.sources = twice.simplified = "nothing";
  for (const Motif& motif : {dot, dot, other}) {
    Step step;
    step.kind = Step::cut, step.motif = motif;
    twice.steps.push_back(step);
  }
  const std::string text = to_toml(twice);
  const auto times = [&](const std::string& what) {
    int n = 0;
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
    return n;
  };
  EXPECT_EQ(times("[[motif.dot.line]]"), 1);
  EXPECT_EQ(times("[[motif.dot_2.line]]"), 1);
  EXPECT_EQ(times("motif = \"dot\""), 2);
}

}  // namespace
}  // namespace onggi::decoration::write_decoration_test
