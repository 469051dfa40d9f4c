#include <algorithm>
#include <cmath>
#include <filesystem>

#include "engine/scene/scene.h"
#include "kiosk/collection/content/gltf.h"
#include "kiosk/collection/content/vessel.h"
#include "kiosk/picture/view/palette.h"
#include "tests/kiosk/picture/render/studio_fixture.h"

// Pictures for people to look at ($ONGGI_GALLERY names the folder), with the few things about them
// that a program can tell.

namespace onggi::render::testing::gallery_test {
namespace {

using Gallery = StudioTest;

double vase(double t) {
  return 0.034 + 0.030 * std::sin(3.5 * t + 0.1) * (1.0 - 0.35 * t) + 0.004 * t;
}
double tea_bowl(double t) { return 0.028 + 0.062 * std::sqrt(t); }
double moon_jar(double t) { return 0.056 + 0.004 * std::sin(3.1 * t); }

const ClayDef kVase = grid_of(400, 360, 0.20, 0.010);

TEST_F(Gallery, AVaseDryAndWetAndFiredAndOpened) {
  Renderer& r = renderer();
  r.show_clay(thrown_clay(kVase, vase, 0.006, 0.00022));
  view::Frame frame = frame_with_pot(kWidth, kHeight, 0.20, 0.066);
  frame.pot->wheel_angle = frame.pot->clay_angle = 1.2;
  r.draw(frame);
  keep_for_looking(r.read_pixels(), "vase_dry");
  frame.pot->wetness = 0.9;
  frame.pot->hands[0].present = true;
  frame.pot->hands[0].at = {0.070, 0.09, 0.018};
  frame.pot->hands[0].radius = 0.008;
  r.draw(frame);
  keep_for_looking(r.read_pixels(), "vase_wet");
  frame.pot->wetness = 0.3;
  frame.pot->hands[0].present = false;
  frame.pot->cut_away = 1.0;
  r.draw(frame);
  keep_for_looking(r.read_pixels(), "vase_open");
  frame.pot->cut_away = 0;
  frame.pot->finish = view::Finish::fired;
  r.draw(frame);
  keep_for_looking(r.read_pixels(), "vase_fired");

  view::Frame card = frame_with_pot(1500, 2100, 0.20, 0.066);
  card.pot->wheel = false;
  card.pot->finish = view::Finish::fired;
  keep_for_looking(r.draw_offscreen(card), "postcard");
}

TEST_F(Gallery, EveryGlazeOfTheExhibitOnAVase) {
  const content::GlazesRead read = content::read_glazes("content/glazes.toml", {"en", "ko"});
  ASSERT_TRUE(read.problems.empty()) << to_text(read.problems.front());
  ASSERT_GE(read.glazes.size(), 3u);
  Renderer& r = renderer();
  r.show_clay(thrown_clay(kVase, vase, 0.006, 0.00022));
  view::Frame frame = frame_with_pot(kWidth, kHeight, 0.20, 0.066);
  frame.pot->wheel = false;
  frame.pot->wheel_angle = frame.pot->clay_angle = 1.2;
  frame.pot->size = 0.875;
  frame.pot->finish = view::Finish::fired;
  for (const content::Glaze& glaze : read.glazes) {
    frame.pot->glazing.look = glaze.look;
    r.draw(frame);
    keep_for_looking(r.read_pixels(), "glaze_" + glaze.id);
  }
  frame.pot->glazing.coat = 0.0;
  r.draw(frame);
  keep_for_looking(r.read_pixels(), "glaze_none");
  frame.pot->finish = view::Finish::firing;
  frame.pot->glazing = {};
  for (const double done : {0.0, 0.3, 0.5, 0.8}) {
    frame.pot->firing = {std::nullopt, done, std::sin(3.14159 * (0.15 + 0.85 * done))};
    r.draw(frame);
    keep_for_looking(r.read_pixels(), "firing_" + std::to_string(static_cast<int>(100 * done)));
  }
}

TEST_F(Gallery, ABowlAndADeepJar) {
  Renderer& r = renderer();
  const ClayDef shape = grid_of(300, 360, 0.08, 0.008);
  r.show_clay(thrown_clay(shape, tea_bowl, 0.005, 0.0002));
  view::Frame frame = frame_with_pot(kWidth, kHeight, 0.08, 0.09);
  r.draw(frame);
  keep_for_looking(r.read_pixels(), "bowl_dry");
  frame.pot->finish = view::Finish::fired;
  frame.pot->camera.elevation = 0.5;
  r.draw(frame);
  keep_for_looking(r.read_pixels(), "bowl_fired");

  const ClayDef deep = grid_of(400, 360, 0.20, 0.010);
  r.show_clay(thrown_clay(deep, moon_jar, 0.007, 0.00015));
  frame = frame_with_pot(kWidth, kHeight, 0.20, 0.06);
  frame.pot->camera.elevation = 0.6;
  frame.pot->wetness = 0.6;
  r.draw(frame);
  keep_for_looking(r.read_pixels(), "jar");
}

// Real clay: a lump opened by a fingertip, and a wall whose rim was pressed down and flared.
TEST_F(Gallery, ALumpIsOpenedAndARimIsPressedAndFlared) {
  Renderer& r = renderer();
  const auto show = [&](const SceneDef& def, auto hand_at, int ticks, const std::string& name) {
    Scene scene = std::move(*Scene::create(def));
    Hands hands;
    hands.wheel_speed = 18.0;
    for (int n = 0; n < ticks; ++n) {
      hands.hand[0].active = n > 1000;
      hands.hand[0].position = hand_at(n * 0.001 - 1.0);
      scene.step(hands, 0.001);
    }
    const Clay& clay = scene.clay();
    ClayView seen;
    seen.take(clay);
    r.show_clay(seen);
    view::Frame frame = frame_with_pot(kWidth, kHeight, clay.rim_height(), 0.06);
    frame.pot->wetness = 0.4;
    frame.pot->camera.elevation = 0.45;
    r.draw(frame);
    keep_for_looking(r.read_pixels(), name);
    frame.pot->cut_away = 1.0;
    frame.pot->camera.elevation = 0.25;
    frame.pot->hands[0] = scene.hand(0);
    r.draw(frame);
    keep_for_looking(r.read_pixels(), name + "_open");
  };
  SceneDef solid;
  solid.clay.height = solid.clay.floor_thickness = 0.08;
  show(
      solid,
      [](double t) {
        return Vec3{t < 3 ? 0.0 : 0.006 * (t - 3), t < 3 ? 0.09 - 0.02 * t : 0.03, 0};
      },
      6000, "lump_opened");
  SceneDef wall;
  wall.clay.height = 0.10;
  wall.clay.inner_radius = 0.049;
  show(
      wall,
      [](double t) {
        return Vec3{0.047 + 0.003 * t, 0.109 - 0.002 * t, 0};
      },
      4000, "rim_flared");
}

view::Text label(float x, float y, float w, float h, const char* text, float px,
                 view::Face face = view::Face::sans, const char* language = "en",
                 view::Color color = view::kInk) {
  view::Text t;
  t.box = {x, y, w, h};
  t.text = text;
  t.style = {.face = face, .px = px, .language = language};
  t.color = color;
  return t;
}

TEST_F(Gallery, APageOfTextInFourScripts) {
  Renderer& r = renderer();
  view::Frame page;
  page.width = kWidth;
  page.height = kHeight;
  const float px = 26, w = 520;
  page.items = {
      label(60, 50, w, 90, "Moon jar", 61, view::Face::serif),
      label(60, 140, w, 200,
            "Two bowls thrown on the wheel, joined at the rim and fired as one. Height 30.5 cm; "
            "mouth 14.2 cm.",
            px),
      label(60, 340, w, 90, "\xEB\x8B\xAC\xED\x95\xAD\xEC\x95\x84\xEB\xA6\xAC", 61,
            view::Face::serif, "ko"),
      label(60, 430, w, 200,
            "\xEB\xAC\xBC\xEB\xA0\x88\xEB\xA1\x9C \xEB\xB9\x9A\xEC\x9D\x80 \xEB\x91\x90 "
            "\xEA\xB0\x9C\xEC\x9D\x98 \xEC\x82\xAC\xEB\xB0\x9C\xEC\x9D\x84 "
            "\xED\x95\x98\xEB\x82\x98\xEB\xA1\x9C "
            "\xEC\x9D\xB4\xEC\x96\xB4 "
            "\xEA\xB5\xAC\xEC\x9B\xA0\xEC\x8A\xB5\xEB\x8B\x88\xEB\x8B\xA4. 30.5 cm",
            px, view::Face::sans, "ko"),
      label(680, 50, w, 120, "\xD8\xAC\xD8\xB1\xD8\xA9 \xD8\xA7\xD9\x84\xD9\x82\xD9\x85\xD8\xB1",
            61, view::Face::serif, "ar"),
      label(680, 150, w, 120,
            "\xD8\xA7\xD8\xB1\xD9\x81\xD8\xB9 \xD8\xA7\xD9\x84\xD8\xAC\xD8\xAF\xD8\xA7\xD8\xB1 "
            "\xD8\xA8\xD8\xA8\xD8\xB7\xD8\xA1 2.5 mm",
            px, view::Face::sans, "ar"),
      label(680, 240, w, 90, "\xE6\x9C\x88\xE5\xA3\xBA  \xD7\x9B\xD7\x93", 61, view::Face::serif,
            "ja"),
      label(680, 560, w, 60, "1111 mm\n2468 mm", 20, view::Face::sans, "en", view::kFaintInk)};
  view::Box button{{680, 350, 260, 84}, 42, view::kCobalt, 0, {}};
  page.items.emplace_back(button);
  view::Text words = label(680, 374, 260, 40, "Begin", px, view::Face::sans, "en", view::kPlaster);
  words.style.align = view::Align::centre;
  words.style.bold = true;
  page.items.emplace_back(words);
  page.items.emplace_back(view::Box{{970, 350, 230, 84}, 12, {1, 1, 1, 0.4f}, 2, view::kCobalt});
  view::Line line;
  for (int i = 0; i <= 120; ++i) {
    const float x = static_cast<float>(i) * 4.0f;
    line.points.emplace_back(690 + x, 500 + 24 * std::sin(x * 0.03f));
    const float t = static_cast<float>(i) / 120;
    line.colors.push_back(
        {0.54f * t + 0.18f * (1 - t), 0.23f * t + 0.29f * (1 - t), 0.13f * t + 0.49f * (1 - t), 1});
  }
  line.width = 3;
  page.items.emplace_back(line);
  const std::uint64_t before = r.status().text_overflows;
  r.draw(page);
  keep_for_looking(r.read_pixels(), "text");
  EXPECT_EQ(r.status().text_overflows, before) << r.status().last_overflow;
}

TEST_F(Gallery, TheShelfOfTheExhibit) {
  if (!std::filesystem::is_directory("content/vessels"))
    GTEST_SKIP() << "content/vessels is absent";
  Renderer& r = renderer();
  view::Frame page;
  page.width = kWidth;
  page.height = kHeight;
  std::vector<std::filesystem::path> folders;
  for (const auto& entry : std::filesystem::directory_iterator("content/vessels")) {
    folders.push_back(entry.path());
  }
  std::sort(folders.begin(), folders.end());
  std::vector<view::PictureId> pictures;
  for (const auto& folder : folders) {
    const auto model = content::read_gltf(folder / "vessel.glb");
    if (!model) continue;
    pictures.push_back(r.draw_picture(
        *r.prepare_picture(model->mesh, {0.62f, 0.44f, 0.31f}, model->coloring, 400, 420)));
    const auto k = static_cast<float>(pictures.size() - 1);
    const float x = 30 + 205 * std::fmod(k, 6.0f), y = 30 + 340 * std::floor(k / 6.0f);
    page.items.emplace_back(view::Picture{{x, y, 200, 210}, pictures.back(), 1});
    page.items.emplace_back(label(x, y + 220, 200, 80, folder.filename().c_str(), 20));
  }
  r.draw(page);
  keep_for_looking(r.read_pixels(), "shelf");
  for (const view::PictureId id : pictures) r.drop_picture(id);
}

TEST_F(Gallery, VesselsThatNobodyHereMade) {
  if (!std::filesystem::is_directory("../shared/vessels")) GTEST_SKIP() << "../shared is absent";
  Renderer& r = renderer();
  view::Frame page;
  page.width = kWidth;
  page.height = kHeight;
  int k = 0;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator("../shared/vessels")) {
    const std::string ending = entry.path().extension().string();
    if (ending == ".glb" || ending == ".gltf") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    const auto vessels = content::load_vessels(file);
    if (!vessels) continue;
    for (const content::Vessel& vessel : *vessels) {
      const auto id =
          r.draw_picture(*r.prepare_picture(vessel.mesh, vessel.color, vessel.coloring, 480, 600));
      const float x = 10 + 126 * static_cast<float>(k % 8),
                  y = 10 + 235 * static_cast<float>(k / 8);
      page.items.emplace_back(view::Picture{{x, y, 120, 150}, id, 1});
      ++k;
    }
  }
  r.draw(page);
  keep_for_looking(r.read_pixels(), "shelf_shared");
}

}  // namespace
}  // namespace onggi::render::testing::gallery_test
