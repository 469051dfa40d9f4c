#include "kiosk/collection/content/true_size.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>

#include "kiosk/collection/content/glb.h"
#include "kiosk/collection/content/vessel.h"
#include "tests/engine/profile/shapes.h"
#include "tests/kiosk/collection/content/temporary.h"

namespace onggi::content::true_size_test {
namespace {

namespace fs = std::filesystem;

TrueSize of(double height, double widest, const ToldSize& told = {}) {
  const auto size = true_size({height, widest}, told, "scan");
  EXPECT_TRUE(size) << to_text(size.error());
  return size ? *size : TrueSize{};
}

TEST(TrueSize, a_plate_in_metres_stays_a_plate) {
  const TrueSize plate = of(0.019, 0.228);
  EXPECT_EQ(plate.from, SizeFrom::file);
  EXPECT_EQ(plate.unit, 1.0);
  EXPECT_TRUE(plate.doubt.empty());
}

TEST(TrueSize, a_unit_is_guessed_by_all_dimensions_and_says_why) {
  const TrueSize plate = of(19, 228);
  EXPECT_EQ(plate.from, SizeFrom::guess);
  EXPECT_EQ(plate.unit, 0.001);
  for (const char* words :
       {"guess", "cannot be metres", "millimetres", "228 mm", "true_diameter_mm"})
    EXPECT_NE(plate.doubt.find(words), std::string::npos) << plate.doubt;
  EXPECT_EQ(of(21.3, 14.7).unit, 0.01);
  EXPECT_EQ(of(49.2, 32.4).unit, 0.01);
  EXPECT_EQ(of(191, 235).unit, 0.001);
  EXPECT_EQ(of(5, 60).unit, 0.01);
}

TEST(TrueSize, what_is_a_vessel_in_no_unit_is_shown_at_a_middling_size_by_its_larger_side) {
  for (const auto& [height, widest] :
       std::initializer_list<std::pair<double, double>>{{3.89, 2.47}, {1e-6, 3e-6}, {4e5, 6e5}}) {
    const TrueSize size = of(height, widest);
    EXPECT_EQ(size.from, SizeFrom::unknown);
    EXPECT_NEAR(std::max(height, widest) * size.unit, 0.3, 1e-12);
    EXPECT_NE(size.doubt.find("not known"), std::string::npos);
  }
}

TEST(TrueSize, what_is_told_settles_it_the_height_first) {
  ToldSize told;
  told.unit = 0.01;
  EXPECT_EQ(of(21, 14, told).from, SizeFrom::units);
  told.diameter = 0.28;
  EXPECT_EQ(of(21, 14, told).from, SizeFrom::diameter);
  EXPECT_DOUBLE_EQ(of(21, 14, told).unit, 0.02);
  told.height = 0.42;
  EXPECT_EQ(of(21, 14, told).from, SizeFrom::height);
  EXPECT_TRUE(of(21, 14, told).doubt.empty());
}

TEST(TrueSize, a_format_without_a_unit_is_always_a_guess) {
  ToldSize told;
  told.format_unit = 0.0;
  const TrueSize size = of(0.2, 0.15, told);
  EXPECT_EQ(size.from, SizeFrom::guess);
  EXPECT_EQ(size.unit, 1.0);
}

TEST(TrueSize, what_no_wheel_ever_held_is_refused) {
  const auto refused = [](double height, double widest, const ToldSize& told = {}) {
    const auto size = true_size({height, widest}, told, "scan");
    return size ? std::string("(taken)") : to_text(size.error());
  };
  for (const std::string& words : {refused(0.3, 599000), refused(1, 1e-5)})
    EXPECT_NE(words.find("for a wheel"), std::string::npos) << words;
  ToldSize tall;
  tall.height = 4.0;
  EXPECT_NE(refused(0.2, 0.2, tall).find("4e+03 mm tall"), std::string::npos);
  ToldSize wrong;
  wrong.unit = 0.001;
  EXPECT_NE(refused(0.2, 0.2, wrong).find("units in vessel.toml"), std::string::npos);
}

class SizedFiles : public Temporary {};

TEST_F(SizedFiles, the_diameter_of_a_pack_scales_it_as_the_height_does) {
  fs::create_directories(folder_ / "jar");
  const auto glb = write_glb(revolve(section_of(scaled(shapes::jar(), 100.0)), 64), "jar", "CC0");
  std::ofstream(folder_ / "jar/vessel.glb", std::ios::binary)
      .write(reinterpret_cast<const char*>(glb.data()), static_cast<std::streamsize>(glb.size()));
  write(
      "jar/vessel.toml",
      "true_diameter_mm = 260\ncredit = \"x\"\nlicence = \"CC0-1.0\"\n[label.en]\ntitle = \"J\"\n");
  const auto vessel = load_vessel(folder_ / "jar");
  ASSERT_TRUE(vessel) << to_text(vessel.error());
  EXPECT_EQ(vessel->size_from, SizeFrom::diameter);
  EXPECT_NEAR(2.0 * vessel->extracted.profile.max_radius(), 0.26, 1e-9);
  EXPECT_NEAR(vessel->true_height, vessel->extracted.profile.height(), 1e-12);
  EXPECT_TRUE(vessel->extracted.warnings.empty()) << vessel->extracted.warnings[0];
}

}  // namespace
}  // namespace onggi::content::true_size_test
