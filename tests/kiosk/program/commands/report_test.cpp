#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "kiosk/keepsake/store/visit_store.h"
#include "kiosk/program/commands/support_bundle.h"
#include "tests/kiosk/program/commands/program.h"

namespace onggi::commands::report_test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kVisitor = "something that a visitor left";

void put(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

std::string everything_in(const fs::path& folder) {
  std::string all;
  for (const auto& file : fs::recursive_directory_iterator(folder))
    all +=
        file.path().string() + '\n' + (file.is_regular_file() ? content(file.path()) : "") + '\n';
  return all;
}

TEST(Report, AMuseumFarAwaySendsAllOfItsKioskAndNothingOfItsVisitors) {
  const ScratchFolder folder;
  const std::string site = (folder / "site").string();
  put(folder / "site/config/exhibit.toml", "shelf = \"" + fs::current_path().string() +
                                               "/content/vessels/moon_jar\"\ncredit = \"Museum of "
                                               "Jars\"\nwarm_after = 3\n");
  put(folder / "site/config/scenes/first_touch.toml", "# the museum's own scene\n");
  for (const char* left : {"postcard.png", "pot.glb", "replay.bin", "note.toml"})
    put(folder / ("site/keepsakes/2026-05-04_141503_moon_jar/" + std::string(left)), kVisitor);
  // Even where a museum keeps them below its configuration.
  put(folder / "site/config/kept/2026-05-04_141503_moon_jar/note.toml", kVisitor);
  put(folder / "state/runs", "running 2\n");
  put(folder / "onggi.prom", "onggi_safe_mode 0\n");
  put(folder / "bin/journalctl",
      "#!/bin/sh\n"
      "echo '2026-05-04T14:15:04+0200 kiosk onggi[7]: Drawing with a card.'\n"
      "echo '2026-05-04T14:15:09+0200 kiosk onggi[7]: Kept "
      "/srv/onggi/keepsakes/2026-05-04_141503_moon_jar'\n"
      "echo '2026-05-04T14:16:09+0200 kiosk onggi[7]: "
      "/srv/onggi/keepsakes/2026-05-04_141503_moon_jar/pot.stl: The disk is full.'\n");
  fs::permissions(folder / "bin/journalctl", fs::perms::owner_all);
  {
    // One visit alone: too few to be told.
    store::VisitRecord visit;
    visit.vessel = "the only visitor's vessel";
    visit.day = "2026-05-04";
    visit.active_s = 300;
    std::vector<Problem> remarks;
    auto store = store::VisitStore::open(folder / "site/keepsakes/onggi.sqlite", "", remarks);
    ASSERT_TRUE(store) << to_text(store.error());
    ASSERT_TRUE(store->add(std::span(&visit, 1)));
  }
  const std::string to = (folder / "report.tar.gz").string();
  const Outcome made =
      onggi("report -o " + to + " --config " + site + "/config/exhibit.toml --state " +
                (folder / "state").string() + " --health " + (folder / "onggi.prom").string(),
            "PATH=" + (folder / "bin").string() + ":$PATH");
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_THAT(made.out, HasSubstr("check.txt"));
  fs::create_directories(folder / "out");
  ASSERT_EQ(std::system(("tar -xzf " + to + " -C " + (folder / "out").string()).c_str()), 0);
  const fs::path in = folder / "out/onggi-report";
  EXPECT_THAT(content(in / "machine.txt"), HasSubstr("onggi 0."));
  EXPECT_THAT(content(in / "config/exhibit.toml"), HasSubstr("Museum of Jars"));
  EXPECT_THAT(content(in / "config/scenes/first_touch.toml"), HasSubstr("own scene"));
  EXPECT_THAT(content(in / "check.txt"), HasSubstr("warm_after is not a key"));
  EXPECT_THAT(content(in / "health.txt"), HasSubstr("onggi_safe_mode 0"));
  EXPECT_THAT(content(in / "crashes.txt"), HasSubstr("running 2"));
  EXPECT_THAT(content(in / "log.txt"), HasSubstr("Drawing with a card."));
  EXPECT_THAT(content(in / "log.txt"), HasSubstr("keepsakes/KEEPSAKE/pot.stl: The disk is full."));
  EXPECT_THAT(content(in / "disk.txt"), HasSubstr("folders of keepsakes: 1"));
  EXPECT_GT(content(in / "stats.txt").size(), 20u);
  const std::string all = everything_in(folder / "out");
  for (const char* visitors : {kVisitor, "141503", "14:15:09", "the only visitor's vessel"})
    EXPECT_THAT(all, Not(HasSubstr(visitors)));
}

TEST(Report, NamesOfKeepsakesGiveWayWhereverTheyStand) {
  EXPECT_EQ(
      without_visitors("a 2026-05-04_141503_moon_jar/x b 2026-05-04_141503.\n2026-05-04 ok\n"),
      "a KEEPSAKE/x b KEEPSAKE.\n2026-05-04 ok\n");
  EXPECT_EQ(without_visitors("Kept /a/2026-05-04_141503_x\nKept busy\n"), "Kept busy\n");
}

TEST(Report, AFileThatCannotBeWrittenIsOneClearError) {
  const Outcome made = onggi("report -o /nowhere/report.tar.gz");
  EXPECT_NE(made.exit_code, 0);
  EXPECT_THAT(made.err, HasSubstr("/nowhere"));
}

}  // namespace
}  // namespace onggi::commands::report_test
