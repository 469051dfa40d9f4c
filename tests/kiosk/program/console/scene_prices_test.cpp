#include "kiosk/program/console/scene_prices.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::console::scene_prices_test {
namespace {

namespace fs = std::filesystem;

/// A scene's file, and a program that measures it as `script` says and counts how often.
class Prices : public ::testing::Test {
 protected:
  void SetUp() override {
    program("echo '{\"whole_us\": 12.5}'");
    scene("[clay]\n");
  }
  void program(const std::string& script) const {
    std::ofstream(folder_ / "onggi")
        << "#!/bin/sh\necho \"$*\" >> \"" << (folder_ / "asked").string() << "\"\n"
        << script << '\n';
    fs::permissions(folder_ / "onggi", fs::perms(0755));
  }
  void scene(const std::string& text) {
    text_ = text;
    std::ofstream(scene_) << text;
  }
  int asked() const {
    std::ifstream in(folder_ / "asked");
    int lines = 0;
    for (std::string line; std::getline(in, line);) ++lines;
    return lines;
  }
  static void wait_for(const ScenePrices& prices) {
    for (int n = 0; n < 3000 && prices.measuring(); ++n)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }

  const files::test::ScratchFolder folder_;
  fs::path scene_ = folder_ / "studio.toml";
  std::string text_;
};

TEST_F(Prices, AreMeasuredOnceAndThenKnownToEveryProgram) {
  {
    ScenePrices prices(folder_ / "onggi", folder_ / "kept");
    EXPECT_FALSE(prices.of(scene_, text_, false));
    EXPECT_EQ(asked(), 0) << "nobody wants them";
    EXPECT_FALSE(prices.of(scene_, text_, true));
    EXPECT_FALSE(prices.of(scene_, text_, true)) << "one at a time";
    wait_for(prices);
    EXPECT_EQ(prices.of(scene_, text_, true), "{\"whole_us\": 12.5}\n");
  }
  ScenePrices again(folder_ / "onggi", folder_ / "kept");
  EXPECT_TRUE(again.of(scene_, text_, true));
  EXPECT_EQ(asked(), 1);
  again.forget(text_);
  EXPECT_FALSE(again.of(scene_, text_, true));
  wait_for(again);
  EXPECT_EQ(asked(), 2);
}

TEST_F(Prices, OfAnotherTextAreOthers) {
  ScenePrices prices(folder_ / "onggi", folder_ / "kept");
  prices.of(scene_, text_, true);
  scene("[clay]\nrows = 100\n");  // while it is measured: nobody knows which one it read
  wait_for(prices);
  EXPECT_FALSE(prices.of(scene_, text_, false));
  EXPECT_FALSE(prices.of(scene_, "[clay]\n", false));
  EXPECT_FALSE(prices.of(scene_, text_, true));
  wait_for(prices);
  EXPECT_TRUE(prices.of(scene_, text_, false));
}

TEST_F(Prices, ThatCannotBeMeasuredAreToldAndNotTriedForEver) {
  program("echo nonsense");
  ScenePrices prices(folder_ / "onggi", folder_ / "kept");
  prices.of(scene_, text_, true);
  wait_for(prices);
  EXPECT_FALSE(prices.of(scene_, text_, true));
  EXPECT_NE(prices.trouble(text_), "");
  EXPECT_EQ(prices.trouble("another"), "");
  prices.of(scene_, text_, true);
  EXPECT_EQ(asked(), 1);
  prices.forget(text_);
  program("echo '{\"whole_us\": 1}'");
  prices.of(scene_, text_, true);
  wait_for(prices);
  EXPECT_TRUE(prices.of(scene_, text_, true));
}

TEST_F(Prices, AreKeptOfTheNewestScenesAlone) {
  fs::create_directories(folder_ / "kept");
  for (std::size_t n = 0; n < 2 * ScenePrices::kKept; ++n)
    std::ofstream(folder_ / "kept" / (std::to_string(n) + ".json")) << "{}";
  ScenePrices prices(folder_ / "onggi", folder_ / "kept");
  prices.of(scene_, text_, true);
  wait_for(prices);
  EXPECT_TRUE(prices.of(scene_, text_, false));
  const auto files = fs::directory_iterator(folder_ / "kept");
  EXPECT_EQ(std::distance(begin(files), end(files)), static_cast<long>(ScenePrices::kKept));
}

}  // namespace
}  // namespace onggi::console::scene_prices_test
