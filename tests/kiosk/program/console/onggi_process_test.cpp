#include "kiosk/program/console/onggi_process.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::console::onggi_process_test {
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

nlohmann::json said_by(OnggiProcess& process) {
  for (int n = 0; n < 3000 && process.under_way(); ++n)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return nlohmann::json::parse(process.take().value_or("null"));
}

TEST(OnggiProcessTest, GivesWhatTheProgramPrintedOnceAndItsWordsAsTheyAre) {
  const Program program(
      "cat > /dev/null; printf '{\"done\": true, \"got\": \"%s|%s\"}' \"$1\" \"$2\"");
  OnggiProcess process(program.path());
  EXPECT_FALSE(process.take());
  ASSERT_TRUE(process.begin({"a; $(b) *", "--x"}));
  const auto said = said_by(process);
  EXPECT_EQ(said["got"], "a; $(b) *|--x");
  EXPECT_FALSE(process.take());
}

TEST(OnggiProcessTest, OneAtATimeAndWhoeverAsksDoesNotWait) {
  const Program program("while [ ! -e \"$1\" ]; do sleep 0.02; done; echo '{\"done\": true}'");
  OnggiProcess process(program.path());
  const fs::path go = program / "go";
  ASSERT_TRUE(process.begin({go.string()}));
  EXPECT_TRUE(process.under_way());
  EXPECT_FALSE(process.take());
  EXPECT_FALSE(process.begin({go.string()}));
  std::ofstream(go) << "now";
  EXPECT_EQ(said_by(process)["done"], true);
  EXPECT_TRUE(process.begin({go.string()}));
}

TEST(OnggiProcessTest, ARefusalIsTheProgramsOwnAndAFailureIsTold) {
  const Program refuses("echo '{\"done\": false, \"what\": \"No.\"}'; exit 2");
  OnggiProcess process(refuses.path());
  ASSERT_TRUE(process.begin({}));
  EXPECT_EQ(said_by(process)["what"], "No.");
  for (const char* script : {"echo nonsense", "exit 1", "kill -9 $$", "echo '[1]'"}) {
    const Program fails(script);
    OnggiProcess other(fails.path());
    ASSERT_TRUE(other.begin({}));
    const auto said = said_by(other);
    EXPECT_EQ(said["done"], false) << script;
    EXPECT_FALSE(said["what"].get<std::string>().empty()) << script;
    EXPECT_FALSE(said["remedy"].get<std::string>().empty()) << script;
  }
  OnggiProcess none("/nowhere/onggi");
  ASSERT_TRUE(none.begin({}));
  EXPECT_EQ(said_by(none)["done"], false);
}

}  // namespace
}  // namespace onggi::console::onggi_process_test
