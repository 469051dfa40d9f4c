#include "kiosk/program/console/saver.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::console::saver_test {
namespace {

namespace fs = std::filesystem;

/// A program that does what `script` says.
class Program {
 public:
  explicit Program(const std::string& script) {
    std::ofstream(path()) << "#!/bin/sh\n" << script << '\n';
    fs::permissions(path(), fs::perms(0755));
  }
  fs::path path() const { return folder_ / "onggi"; }
  fs::path operator/(const char* name) const { return folder_ / name; }

 private:
  const files::test::ScratchFolder folder_;
};

nlohmann::json said_by(Saver& saver) {
  for (int n = 0; n < 3000 && saver.under_way(); ++n)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return nlohmann::json::parse(saver.take().value_or("null"));
}

TEST(SaverTest, GivesWhatTheProgramPrintedOnceAndItsWordsAsTheyAre) {
  const Program program(
      "cat > /dev/null; printf '{\"done\": true, \"got\": \"%s|%s\"}' \"$1\" \"$2\"");
  Saver saver(program.path());
  EXPECT_FALSE(saver.take());
  ASSERT_TRUE(saver.begin({"a; $(b) *", "--x"}));
  const auto said = said_by(saver);
  EXPECT_EQ(said["got"], "a; $(b) *|--x");
  EXPECT_FALSE(saver.take());
}

TEST(SaverTest, OneAtATimeAndWhoeverAsksDoesNotWait) {
  const Program program("while [ ! -e \"$1\" ]; do sleep 0.02; done; echo '{\"done\": true}'");
  Saver saver(program.path());
  const fs::path go = program / "go";
  ASSERT_TRUE(saver.begin({go.string()}));
  EXPECT_TRUE(saver.under_way());
  EXPECT_FALSE(saver.take());
  EXPECT_FALSE(saver.begin({go.string()}));
  std::ofstream(go) << "now";
  EXPECT_EQ(said_by(saver)["done"], true);
  EXPECT_TRUE(saver.begin({go.string()}));
}

TEST(SaverTest, ARefusalIsTheProgramsOwnAndAFailureIsTold) {
  const Program refuses("echo '{\"done\": false, \"what\": \"No.\"}'; exit 2");
  Saver saver(refuses.path());
  ASSERT_TRUE(saver.begin({}));
  EXPECT_EQ(said_by(saver)["what"], "No.");
  for (const char* script : {"echo nonsense", "exit 1", "kill -9 $$", "echo '[1]'"}) {
    const Program fails(script);
    Saver other(fails.path());
    ASSERT_TRUE(other.begin({}));
    const auto said = said_by(other);
    EXPECT_EQ(said["done"], false) << script;
    EXPECT_FALSE(said["what"].get<std::string>().empty()) << script;
    EXPECT_FALSE(said["remedy"].get<std::string>().empty()) << script;
  }
  Saver none("/nowhere/onggi");
  ASSERT_TRUE(none.begin({}));
  EXPECT_EQ(said_by(none)["done"], false);
}

}  // namespace
}  // namespace onggi::console::saver_test
