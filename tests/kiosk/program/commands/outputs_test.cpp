#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/kiosk/program/commands/program.h"

namespace onggi::commands::outputs_test {
namespace {

namespace fs = std::filesystem;

const std::string kJar = "content/vessels/moon_jar/";

TEST(Outputs, TheScanThatIsInspectedIsNeverWrittenOver) {
  const ScratchFolder folder;
  const std::string scan = (folder / "scan.glb").string();
  fs::copy(kJar + "vessel.glb", scan);
  const std::string before = content(scan);
  for (const std::string option : {"--json ", "--plot "})
    for (const std::string more : {"", " --force"}) {
      const Outcome run = onggi("vessel inspect " + scan + " " + option + scan + more);
      EXPECT_EQ(run.exit_code, 2) << option << more;
      EXPECT_EQ(run.out, "");
      EXPECT_EQ(content(scan), before) << option << more;
    }
  const std::string other = (folder / "other.glb").string();
  fs::copy(scan, other);
  EXPECT_EQ(onggi("vessel inspect " + scan + " --json " + other).exit_code, 2);
  EXPECT_EQ(content(other), before);
  EXPECT_EQ(onggi("vessel inspect " + scan + " --json " + other + " --force").exit_code, 0);
  EXPECT_EQ(content(other).substr(0, 1), "{");
}

TEST(Outputs, ADrawingIsNotReplacedByWhatIsMadeOfIt) {
  const ScratchFolder folder;
  const std::string drawing = (folder / "profile.toml").string();
  fs::copy(kJar + "profile.toml", drawing);
  const std::string before = content(drawing);
  EXPECT_EQ(onggi("vessel make " + drawing + " -o " + drawing + " --force").exit_code, 2);
  EXPECT_EQ(content(drawing), before);
}

TEST(Outputs, ADashIsStandardOutputForReportsPicturesAndVessels) {
  const ScratchFolder folder;
  const auto begins = [](const std::string& arguments) {
    const Outcome run = onggi(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return run.out;
  };
  const std::string glb = begins("vessel make " + kJar + "profile.toml -o -");
  EXPECT_EQ(glb, content(kJar + "vessel.glb"));
  const std::string png = begins("vessel inspect " + kJar + " --plot -");
  EXPECT_EQ(png.substr(1, 3), "PNG");
  EXPECT_EQ(png.substr(png.size() - 8, 4), "IEND");
  EXPECT_TRUE(nlohmann::json::accept(begins("vessel inspect " + kJar + " --json -")));
  EXPECT_EQ(onggi("vessel inspect " + kJar + " --json - --plot -").exit_code, 2);
  EXPECT_FALSE(fs::exists("-"));
}

TEST(Outputs, AFullDeviceIsNoSuccessAndStaysADevice) {
  const Outcome full = onggi("score " + kJar + " " + kJar + " --json /dev/full");
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST(Outputs, AFolderThatIsNotThereIsToldBeforeTheWorkAndNotMade) {
  const ScratchFolder folder;
  const std::string no = (folder / "no").string();
  for (const std::string& command : std::initializer_list<std::string>{
           "lab effects --json ", "lab accuracy --csv ", "lab loop --plot ",
           "lab stability --json ", "lab timing --plot ", "lab witness --json ", "devices --json ",
           "vessel make " + kJar + "profile.toml -o ", "score " + kJar + " " + kJar + " --json "}) {
    const Outcome run = onggi(command + no + "/such/file");
    EXPECT_EQ(run.exit_code, 2) << command;
    EXPECT_NE(run.err.find("mkdir -p"), std::string::npos) << run.err;
    EXPECT_FALSE(fs::exists(no)) << command;
  }
}

}  // namespace
}  // namespace onggi::commands::outputs_test
