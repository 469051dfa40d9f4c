#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "kiosk/keepsake/store/visit_store.h"
#include "tests/kiosk/program/commands/program.h"

namespace onggi::commands::stats_test {
namespace {

using Json = nlohmann::json;

store::VisitRecord visit(const std::string& day, const std::string& vessel) {
  store::VisitRecord v;
  v.day = day;
  v.hour = 11;
  v.vessel = vessel;
  v.language = "en";
  v.way = "touch";
  v.reached = v.left = "throw";
  v.ended = "idle";
  v.active_s = 120.0;
  v.pots = 1;
  return v;
}

/// Ten visitors on one day of May, six on the next; three of them threw a cup.
std::string written(const ScratchFolder& folder) {
  const std::string file = (folder / "onggi.sqlite").string();
  std::vector<Problem> remarks;
  auto opened = store::VisitStore::open(file, "then", remarks);
  EXPECT_TRUE(opened);
  std::vector<store::VisitRecord> visits;
  for (int n = 0; n < 16; ++n)
    visits.push_back(visit(n < 10 ? "2026-05-01" : "2026-05-02", n % 6 == 5 ? "cup" : "moon_jar"));
  visits.resize(15);
  visits.push_back(visit("2026-05-02", "cup"));
  EXPECT_TRUE(opened->add(visits));
  return file;
}

TEST(Stats, ACuratorGetsWordsTablesAndAPictureAndNothingOfThree) {
  const ScratchFolder folder;
  const std::string store = " --store " + written(folder);
  const Outcome words = onggi("stats" + store);
  ASSERT_EQ(words.exit_code, 0) << words.err;
  EXPECT_NE(words.out.find("16 people played, half of them for more than 2.0 minutes."),
            std::string::npos)
      << words.out;
  EXPECT_EQ(words.out.find("cup"), std::string::npos) << "three are too few to tell";

  const std::string csv = (folder / "may.csv").string(), plot = (folder / "may.png").string();
  const Outcome day =
      onggi("stats --to 2026-05-01 --json - --csv " + csv + " --plot " + plot + store);
  ASSERT_EQ(day.exit_code, 0) << day.err;
  const Json json = Json::parse(day.out);
  EXPECT_EQ(json.at("visits"), 10);
  EXPECT_EQ(json.at("tables").at("day").at(0).at("visits"), 10);
  EXPECT_TRUE(json.at("tables").at("vessel").at(0).at("visits").is_null());
  EXPECT_NE(content(csv).find("day,2026-05-01,10,0,20.0,"), std::string::npos) << content(csv);
  EXPECT_EQ(content(plot).substr(1, 3), "PNG");
  EXPECT_EQ(onggi("stats --csv -" + store).out.substr(0, 10), "table,name");
}

TEST(Stats, OfFourVisitorsThePictureSaysThatTheyAreFewAndOfNoneThatThereAreNone) {
  const ScratchFolder folder;
  const std::string file = (folder / "onggi.sqlite").string();
  {
    std::vector<Problem> remarks;
    auto opened = store::VisitStore::open(file, "then", remarks);
    ASSERT_TRUE(opened);
    ASSERT_TRUE(opened->add(std::vector(4, visit("2026-05-01", "cup"))));
  }
  const auto told = [&](const std::string& days, const std::string& why) {
    const std::string plot = (folder / (why.substr(0, 3) + ".svg")).string();
    const Outcome run = onggi("stats" + days + " --plot " + plot + " --store " + file);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_NE(run.out.find(why), std::string::npos) << run.out;
    return content(plot);
  };
  EXPECT_NE(told("", "fewer than 5 people played"), told(" --from 2031-01-01", "nobody played"));
}

TEST(Stats, AStoreThatIsNewerThanTheProgramIsRefusedInOneError) {
  const ScratchFolder folder;
  const std::string file = written(folder);
  {
    store::Database newer = store::Database::open(file, store::Database::Mode::own);
    ASSERT_TRUE(newer.run("PRAGMA user_version=99"));
  }
  const Outcome run = onggi("stats --store " + file);
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_NE(run.err.find("A newer onggi made it (version 99"), std::string::npos) << run.err;
}

TEST(Stats, NoStoreNoDayAndAStoreThatWouldBeWrittenOverAreRefused) {
  const ScratchFolder folder;
  const std::string file = written(folder);
  const auto refused = [](const std::string& arguments, const std::string& why) {
    const Outcome run = onggi("stats " + arguments);
    EXPECT_EQ(run.exit_code, 2) << arguments;
    EXPECT_NE(run.err.find(why), std::string::npos) << run.err;
    EXPECT_EQ(run.out, "") << arguments;
  };
  refused("--store " + (folder / "none").string(), "no store of visits");
  refused("--from 2026-02-30 --store " + file, "not a valid date");
  refused("--from 2026-5-3 --store " + file, "not a valid date");
  refused("--from 2026-05-02 --to 2026-05-01 --store " + file, "before the first");
  const std::string before = content(file);
  refused("--json " + file + " --force --store " + file, file);
  EXPECT_EQ(content(file), before);
}

}  // namespace
}  // namespace onggi::commands::stats_test
