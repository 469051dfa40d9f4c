#include "kiosk/program/console/scan_inbox.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <span>
#include <thread>

#include "kiosk/ground/web/received_file.h"
#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::console::scan_inbox_test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// An inbox, and a program that says what it was asked and answers as `script` says.
class Inbox : public ::testing::Test {
 protected:
  void SetUp() override { program("echo '{\"done\": true}'"); }
  void program(const std::string& script) const {
    std::ofstream(folder_ / "onggi")
        << "#!/bin/sh\necho \"$*\" >> \"" << (folder_ / "asked").string() << "\"\n"
        << script << '\n';
    fs::permissions(folder_ / "onggi", fs::perms(0755));
  }
  Result<void> take(const std::string& name, bool first = false) {
    auto place = inbox_.place_for_file();
    const auto* into = std::get_if<web::IntoFile>(&place);
    if (into == nullptr) return problem(name, "busy", "");
    auto file = web::ReceivedFile::make(*into);
    EXPECT_TRUE(file);
    (*file)->append(std::as_bytes(std::span("clay", 4)));
    return inbox_.take(**file, name, first);
  }
  nlohmann::json state() { return nlohmann::json::parse(inbox_.json()); }
  nlohmann::json at_rest() {
    nlohmann::json now = state();
    for (int n = 0; n < 3000 && now["doing"] != ""; ++n) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      now = state();
    }
    return now;
  }
  std::string asked() const {
    std::ifstream in(folder_ / "asked");
    std::string last;
    for (std::string line; std::getline(in, line);) last = line;
    return last;
  }

  const files::test::ScratchFolder folder_;
  ScanInbox inbox_{folder_ / "onggi", folder_ / "scans"};
};

TEST_F(Inbox, AScanIsSentReadAndPutOnTheShelfAndItsFilesAreGoneThen) {
  EXPECT_TRUE(state()["found"].is_null());
  EXPECT_FALSE(inbox_.look()) << "there is nothing yet";
  ASSERT_TRUE(take("jar/scan.gltf", true));
  ASSERT_TRUE(take("jar/textures/a.png"));
  EXPECT_EQ(state()["files"], 2);
  EXPECT_EQ(state()["bytes"], 8);
  EXPECT_EQ(state()["name"], "jar/scan.gltf");
  EXPECT_EQ(state()["scan"], 1);
  program(R"(echo '{"done": true, "vessels": [{"file": "/f/a.obj", "node": "", "down_axis": "-z"},
    {"file": "/f/b.obj", "node": "--x", "down_axis": "-y"}]}')");
  ASSERT_TRUE(inbox_.look());
  EXPECT_EQ(at_rest()["found"]["vessels"].size(), 2u);
  EXPECT_THAT(asked(), ::testing::StartsWith("vessel look --json - "));
  EXPECT_FALSE(inbox_.put_on_shelf({.vessel = 2, .id = "jar"}, "/shelf")) << "there are two";
  program("echo '{\"done\": true}'");
  ASSERT_TRUE(inbox_.put_on_shelf(
      {.vessel = 1, .id = "jar", .turned_over = true, .height_mm = 90.5}, "/shelf"));
  EXPECT_EQ(at_rest()["placed"]["done"], true);
  EXPECT_EQ(asked(),
            "vessel import --json - --id=jar --shelf /shelf --node=--x --up=-y "
            "--height=90.500000 /f/b.obj");
  EXPECT_EQ(inbox_.put(), "jar");
  EXPECT_FALSE(inbox_.put()) << "it is told once";
  EXPECT_TRUE(fs::is_empty(folder_ / "scans"));
}

TEST_F(Inbox, ARefusedVesselKeepsTheScanSoThatSomebodyChoosesAgain) {
  ASSERT_TRUE(take("a.obj", true));
  program(R"(echo '{"done": true, "vessels": [{"file": "/f/a.obj"}]}')");
  ASSERT_TRUE(inbox_.look());
  at_rest();
  program(R"(echo '{"done": false, "what": "The folder exists."}'; exit 2)");
  ASSERT_TRUE(inbox_.put_on_shelf({.vessel = 0, .id = "jar"}, "/shelf"));
  EXPECT_EQ(at_rest()["placed"]["what"], "The folder exists.");
  EXPECT_FALSE(inbox_.put());
  EXPECT_TRUE(inbox_.put_on_shelf({.vessel = 0, .id = "jar_2"}, "/shelf"));
  at_rest();
}

TEST_F(Inbox, NoNameLeadsOutOfIt) {
  for (const char* name : {"../out.obj", "/etc/passwd", "a/../../out.obj", "", "a//b", "C:x.obj",
                           "a\\b.obj", "a/", "x\ny.obj", "\xff.obj"})
    EXPECT_FALSE(take(name)) << name;
  EXPECT_FALSE(fs::exists(folder_ / "out.obj"));
  EXPECT_EQ(state()["files"], 0);
  EXPECT_TRUE(take("항아리 (1).obj"));
}

TEST_F(Inbox, OneScanAtATimeAndNothingArrivesWhileItIsWorkedOn) {
  {
    const auto first = inbox_.place_for_file();
    const auto* into = std::get_if<web::IntoFile>(&first);
    ASSERT_NE(into, nullptr);
    EXPECT_EQ(into->most, ScanInbox::kMost);
    EXPECT_FALSE(std::holds_alternative<web::IntoFile>(inbox_.place_for_file()));
  }
  ASSERT_TRUE(take("a.obj", true));
  program("while [ ! -e \"" + (folder_ / "go").string() + "\" ]; do sleep 0.02; done; echo '{}'");
  ASSERT_TRUE(inbox_.look());
  EXPECT_EQ(state()["doing"], "looking");
  EXPECT_FALSE(take("b.obj"));
  EXPECT_FALSE(inbox_.look());
  EXPECT_FALSE(inbox_.forget());
  EXPECT_FALSE(inbox_.put_on_shelf({.vessel = 0, .id = "jar"}, "/shelf"));
  std::ofstream(folder_ / "go") << "now";
  at_rest();
  EXPECT_TRUE(take("b.obj", true));
  EXPECT_EQ(state()["files"], 1) << "another scan begins";
  EXPECT_EQ(inbox_.number(), 2);
  EXPECT_FALSE(fs::exists(folder_ / "scans/scan/a.obj"));
}

TEST_F(Inbox, HasRoomForSoManyFilesAndNoMore) {
  for (std::size_t n = 0; n < ScanInbox::kMostFiles; ++n)
    ASSERT_TRUE(take(std::to_string(n) + ".png", n == 0));
  const auto refused = take("one_more.png");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().remedy, HasSubstr("zip"));
}

TEST_F(Inbox, WhatAKilledProgramLeftIsRemovedAtTheStart) {
  ASSERT_TRUE(take("a.obj", true));
  std::ofstream(folder_ / "scans/onggi-received-x.part") << "half";
  const ScanInbox again(folder_ / "onggi", folder_ / "scans");
  EXPECT_TRUE(fs::is_empty(folder_ / "scans"));
}

}  // namespace
}  // namespace onggi::console::scan_inbox_test
