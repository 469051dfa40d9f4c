#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/kiosk/program/commands/program.h"

namespace onggi::commands::keepsake_test {
namespace {

namespace fs = std::filesystem;

class AtTheDesk : public ::testing::Test {
 protected:
  AtTheDesk() {
    keep("2026-05-04_141503_moon_jar", "quiet-blue-heron");
    keep("2026-05-04_151500_tea_bowl", "brave-red-heron");
    keep("2026-05-04_161500_olla", "");
  }
  void keep(const std::string& visit, const std::string& name) {
    const fs::path in = folder_ / "keepsakes" / visit;
    fs::create_directories(in);
    for (const char* file : {"postcard.jpg", "print.jpg", "visit.onggi"})
      std::ofstream(in / file) << visit << file;
    if (!name.empty()) std::ofstream(in / "name.txt") << name << '\n';
  }
  Outcome desk(const std::string& words, const std::string& first = "true") {
    return onggi("keepsake " + words + " --config config/exhibit.toml --keepsakes '" +
                     (folder_ / "keepsakes").string() + "'",
                 first);
  }
  bool there(const std::string& visit) { return fs::exists(folder_ / "keepsakes" / visit); }
  ScratchFolder folder_;
};

TEST_F(AtTheDesk, AKeepsakeIsFoundByItsNameInAnyLanguageAndByItsTime) {
  for (const char* typed : {"'quiet blue heron'", "'stiller blauer Reiher'", "'héron bleu'",
                            "2026-05-04_1415", "'2026-05-04 14:15'"}) {
    const Outcome found = desk("find " + std::string(typed));
    EXPECT_EQ(found.exit_code, 0) << found.err;
    EXPECT_EQ(found.out, "2026-05-04 14:15:03  quiet blue heron  moon_jar\n") << typed;
  }
  EXPECT_EQ(desk("find heron").out,
            "2026-05-04 15:15:00  brave red heron  tea_bowl\n"
            "2026-05-04 14:15:03  quiet blue heron  moon_jar\n");
  EXPECT_EQ(desk("find --language de 'brave red'").out,
            "2026-05-04 15:15:00  mutiger roter Reiher  tea_bowl\n");
  EXPECT_NE(desk("find").out.find("(no name)  olla"), std::string::npos);
  const Outcome none = desk("find lighthouse");
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_NE(none.err.find("No keepsake here has this name"), std::string::npos);
}

TEST_F(AtTheDesk, ACopyHoldsWhatTheVisitorTakesHome) {
  const fs::path stick = folder_ / "stick";
  EXPECT_EQ(desk("copy 'quiet blue heron' '" + stick.string() + "'").exit_code, 2)
      << "no stick is plugged in";
  fs::create_directories(stick);
  const Outcome copied = desk("copy 'quiet blue heron' '" + stick.string() + "'");
  ASSERT_EQ(copied.exit_code, 0) << copied.err;
  EXPECT_EQ(content(stick / "quiet-blue-heron/postcard.jpg"),
            "2026-05-04_141503_moon_jarpostcard.jpg");
  EXPECT_FALSE(fs::exists(stick / "quiet-blue-heron/print.jpg")) << "its code may delete";
  EXPECT_FALSE(fs::exists(stick / "quiet-blue-heron/visit.onggi"));
}

// A note of the desk's own keeps a visit from being tidied away. It must not hide it.
TEST_F(AtTheDesk, AKeepsakeWithANoteInItIsFoundAndNoneIsCopiedAmongTheOthers) {
  const fs::path kept = folder_ / "keepsakes";
  std::ofstream(kept / "2026-05-04_141503_moon_jar/note.txt") << "fetch on Friday";
  EXPECT_EQ(desk("find 'quiet blue heron'").exit_code, 0);
  for (const fs::path& to : {kept, kept / "2026-05-04_141503_moon_jar"}) {
    const Outcome copied = desk("copy 'quiet blue heron' '" + to.string() + "'");
    EXPECT_EQ(copied.exit_code, 2);
    EXPECT_NE(copied.err.find("lies among the keepsakes"), std::string::npos) << copied.err;
  }
  EXPECT_FALSE(fs::exists(kept / "quiet-blue-heron"));
}

TEST_F(AtTheDesk, APostcardIsPrintedByLpUnderItsName) {
  const fs::path bin = folder_ / "bin";
  fs::create_directories(bin);
  std::ofstream(bin / "lp") << "#!/bin/sh\nprintf '%s|' \"$@\"\n";
  fs::permissions(bin / "lp", fs::perms::owner_all);
  const std::string with_lp = "export PATH='" + bin.string() + "':$PATH";
  const Outcome printed = desk("print 'brave red heron' --printer hall", with_lp);
  ASSERT_EQ(printed.exit_code, 0) << printed.err;
  EXPECT_EQ(printed.out, "-t|brave red heron|-o|print-scaling=fit|-d|hall|--|" +
                             (folder_ / "keepsakes").string() +
                             "/2026-05-04_151500_tea_bowl/print.jpg|");
  std::ofstream(bin / "lp") << "#!/bin/sh\nexit 1\n";
  EXPECT_EQ(desk("print 'brave red heron'", with_lp).exit_code, 1);
  const Outcome without =
      desk("print 'brave red heron'", "export PATH='" + bin.string() + "/none'");
  EXPECT_EQ(without.exit_code, 1);
  EXPECT_NE(without.err.find("no printing system"), std::string::npos) << without.err;
}

TEST_F(AtTheDesk, OnlyTheOneThatIsNamedIsDeleted) {
  const Outcome both = desk("delete heron");
  EXPECT_EQ(both.exit_code, 2);
  EXPECT_NE(both.err.find("2 keepsakes have this in their name"), std::string::npos) << both.err;
  EXPECT_TRUE(there("2026-05-04_141503_moon_jar"));
  for (const char* part : {"q", "quiet", "'blue heron'", "2026-05-04_1415", "'2026-05-04 14:15'",
                           "'stiller blauer Reihe'"}) {
    const Outcome refused = desk("delete " + std::string(part));
    EXPECT_EQ(refused.exit_code, 2) << part;
    EXPECT_NE(refused.err.find("not a whole name"), std::string::npos) << refused.err;
  }
  EXPECT_TRUE(there("2026-05-04_141503_moon_jar"));
  EXPECT_EQ(desk("delete 'Quiet blue heron'").exit_code, 0);
  EXPECT_FALSE(there("2026-05-04_141503_moon_jar"));
  EXPECT_TRUE(there("2026-05-04_151500_tea_bowl"));
  EXPECT_EQ(desk("delete 'quiet blue heron'").exit_code, 2);
  EXPECT_EQ(desk("delete '2026-05-04 16:15:00'").exit_code, 0);
  EXPECT_FALSE(there("2026-05-04_161500_olla"));
}

}  // namespace
}  // namespace onggi::commands::keepsake_test
