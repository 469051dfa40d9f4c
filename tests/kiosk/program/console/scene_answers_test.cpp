#include "kiosk/program/console/scene_answers.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "kiosk/exhibit/tuning/grid_memory.h"
#include "kiosk/exhibit/tuning/machine.h"
#include "tests/kiosk/exhibit/editing/small_site.h"

namespace onggi::console::scene_answers_test {
namespace {

namespace fs = std::filesystem;

class Scenes : public ::testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(site_ / "onggi") << "#!/bin/sh\necho '{\"whole_us\": 12.5}'\n";
    fs::permissions(site_ / "onggi", fs::perms(0755));
  }
  nlohmann::json asked(const web::Answer& answer) {
    EXPECT_EQ(answer.status, 200);
    return nlohmann::json::parse(answer.body);
  }
  nlohmann::json known_prices(const std::string& name) {
    nlohmann::json now;
    for (int n = 0; n < 3000; ++n) {
      now = asked(answers_.prices({}, name));
      if (now["measuring"] == false) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return now;
  }
  nlohmann::json scene(const std::string& name) {
    for (const auto& one : asked(answers_.scenes({})))
      if (one["name"] == name) return one;
    return {};
  }

  editing::test::SmallSite site_;
  Site opened_ = *Site::open(site_.path());
  SceneAnswers answers_{opened_, ScenePrices(site_ / "onggi", site_ / "state/prices")};
};

TEST_F(Scenes, AreToldWithTheirEffectsAndWhoHasThem) {
  site_.by_hand("config/exhibit.toml", "[title]",
                "[vessel_scenes]\nmoon_jar = \"scenes/studio.toml\"\n\n[title]");
  ASSERT_EQ(asked(answers_.scenes({})).size(), 5u);
  const auto touch = scene("first_touch"), built = scene("built"), studio = scene("studio");
  EXPECT_EQ(touch["effects"], nlohmann::json({"moisture", "walls", "friction", "kiln"}));
  EXPECT_EQ(touch["thrown"], true);
  EXPECT_EQ(touch["built"], false);
  EXPECT_EQ(built["built"], true);
  EXPECT_EQ(studio["vessels"], nlohmann::json({"moon_jar"}));
  EXPECT_FALSE(touch["words"].get<std::string>().empty());
  EXPECT_FALSE(touch.contains("tick_us"));
  known_prices("first_touch");
  EXPECT_EQ(scene("first_touch")["tick_us"], 12.5);
}

TEST_F(Scenes, TellTheirPricesAndWhatTheMachineChose) {
  const auto first = asked(answers_.prices({}, "studio"));
  EXPECT_EQ(first["measuring"], true);
  EXPECT_TRUE(first["prices"].is_null());
  EXPECT_FALSE(first.contains("grid"));
  const auto memory =
      tuning::memory_of(opened_.exhibit().keepsake.folder, site_ / "config/scenes/studio.toml",
                        tuning::machine_name());
  ASSERT_TRUE(memory);
  ASSERT_TRUE(tuning::remember(*memory, {300, 270, 0.04, 0.2, 1.5, 9.0, true, true}, "m"));
  const auto now = known_prices("studio");
  EXPECT_EQ(now["prices"]["whole_us"], 12.5);
  EXPECT_NE(now["grid"].get<std::string>().find("300"), std::string::npos);
}

TEST_F(Scenes, ThatHaveNoPriceSayWhy) {
  EXPECT_NE(asked(answers_.prices({}, "paper"))["trouble"], "");
  site_.by_hand("config/scenes/studio.toml", "rows = 600", "rows = 1");
  const auto faulty = asked(answers_.prices({}, "studio"));
  EXPECT_EQ(faulty["measuring"], false);
  EXPECT_NE(faulty["trouble"], "");
  for (const char* none : {"none", "../exhibit", "", "studio.toml"}) {
    EXPECT_EQ(answers_.prices({}, none).status, 404) << none;
    EXPECT_EQ(answers_.measure(none).status, 404) << none;
  }
}

}  // namespace
}  // namespace onggi::console::scene_answers_test
