#include "kiosk/picture/render/skin_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "kiosk/collection/content/glaze.h"
#include "tests/kiosk/picture/render/studio_fixture.h"

// What a pot is taken home with against what the kiln shows. Light falls out of it: of three
// pictures of one pot (the glaze, a white one, a black one, all as smooth) light and shine are the
// same, so (glaze - black) / (white - black) at a pixel is the glaze's colour there, as a share of
// the white's.

namespace onggi::render::testing::skin_reader_test {
namespace {

using Color = std::array<double, 3>;

constexpr double kPotHeight = 0.18;
constexpr float kWhite = 0.3f;        // of the light comes back from the body
constexpr double kUnderGlass = 0.86;  // and of that through clear glass
const ClayDef kPotGrid = grid_of(360, 180, kPotHeight, 0.012);

double belly(double t) { return 0.045 + 0.02 * std::sin(3.0 * t); }
ClayView grooved_pot() { return thrown_clay(kPotGrid, belly, 0.006, 0.00025); }

double light(std::uint8_t display) {
  const double s = display / 255.0;
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

view::Frame in_the_kiln(const content::GlazeLook& look) {
  view::Frame frame = frame_with_pot(1100, 1100, kPotHeight, 0.066);
  frame.pot->wheel = false;
  frame.pot->finish = view::Finish::fired;
  frame.pot->glazing.look = look;
  return frame;
}

/// Looked at from so high that all of the lip is seen.
view::Frame into_the_mouth(const content::GlazeLook& look) {
  view::Frame frame = in_the_kiln(look);
  frame.width = frame.height = frame.pot->camera.width = frame.pot->camera.height = 800;
  frame.pot->camera.target = {0, kPotHeight, 0};
  frame.pot->camera.centre_x = frame.pot->camera.centre_y = 400;
  frame.pot->camera.distance = 0.4;
  frame.pot->camera.elevation = 1.15;
  return frame;
}

content::GlazeLook clear_over(float body) {
  content::GlazeLook look;
  look.body = {body, body, body};
  look.glass = {1, 1, 1};
  look.slip_cover = look.brushed = look.pooling = look.band_width = look.gloss = 0;
  return look;
}

class SkinReading : public StudioTest {
 protected:
  /// A short arc of the outer wall in front, or of the lip, at one height.
  struct Arc {
    Color read{}, shown{};  ///< Means of its colours, as read off and as the kiln shows them.
    int count = 0;
  };
  /// By ring of the mesh, and by arc.
  using Arcs = std::map<std::pair<int, int>, Arc>;
  /// From where the pot is seen, and the light there.
  struct Sight {
    view::Frame (*of)(const content::GlazeLook&);
    view::Image white = renderer().draw_offscreen(of(clear_over(kWhite)));
    view::Image black = renderer().draw_offscreen(of(clear_over(0.0f)));
  };
  /// `look` is matt.
  static Arcs arcs_of(const content::GlazeLook& look, const ClayMesh& mesh, ClayFace face,
                      const Sight& sight) {
    Renderer& r = renderer();
    const view::Image glazed = r.draw_offscreen(sight.of(look));
    const auto wide = static_cast<std::size_t>(glazed.width);
    const view::Glazing glazing{look, 1.0};
    const auto skin = r.read_skin(mesh, glazing);
    EXPECT_EQ(skin.size(), mesh.mesh.positions.size());
    const view::Camera camera = sight.of(look).pot->camera;
    const Vec3 eye = camera.eye();
    const auto first = std::find(mesh.faces.begin(), mesh.faces.end(), face) - mesh.faces.begin();
    const auto last = std::find(mesh.faces.rbegin(), mesh.faces.rend(), face);
    const auto rings = (mesh.faces.rend() - last - first) / 180;
    Arcs arcs;
    for (std::size_t i = 0; i < skin.size(); ++i) {
      if (mesh.faces[i] != face) continue;
      const auto& p = mesh.mesh.positions[i];
      const auto& n = mesh.mesh.normals[i];
      const Vec3 at{p[0], p[1], p[2]}, out{n[0], n[1], n[2]};
      const auto ring = static_cast<int>((static_cast<std::ptrdiff_t>(i) - first) / 180);
      // What is seen aslant is less than a pixel wide, and faces end in edges.
      const bool edge =
          face == ClayFace::rim ? ring < 2 || ring > rings - 3 : at.y < 0.008 || at.y > 0.172;
      if (edge || dot(out, eye - at) < 0.7 * length(eye - at)) continue;
      const auto [x, y] = *camera.project(at);
      const std::size_t pixel = static_cast<std::size_t>(y) * wide + static_cast<std::size_t>(x);
      Arc& arc = arcs[{ring, static_cast<int>(i % 180) / 10}];
      ++arc.count;
      for (std::size_t k = 0; k < 3; ++k) {
        const double dark = light(sight.black.rgba[4 * pixel + k]);
        const double lit = light(sight.white.rgba[4 * pixel + k]) - dark;
        arc.shown[k] += kUnderGlass * static_cast<double>(kWhite) *
                        (light(glazed.rgba[4 * pixel + k]) - dark) / std::max(lit, 1e-3);
        arc.read[k] += static_cast<double>(skin[i].color[k]);
      }
    }
    std::erase_if(arcs, [](const auto& one) { return one.second.count < 5; });
    for (auto& [where, arc] : arcs)
      for (std::size_t k = 0; k < 3; ++k) {
        arc.read[k] /= arc.count;
        arc.shown[k] /= arc.count;
      }
    return arcs;
  }
  /// Of color `k`: how far apart they are, how much it changes from place to place in what was read
  /// for what is shown, and whether both change together; how light it is shown, and by which share
  /// of that both change.
  struct Alike {
    double apart = 0, change = 0, together = 0, shown = 0;
    double shown_changes = 0, read_changes = 0;
  };
  static Alike alike(const Arcs& arcs, std::size_t k) {
    Alike out;
    double read = 0, both = 0, read2 = 0, shown2 = 0;
    const auto n = static_cast<double>(arcs.size());
    for (const auto& [where, arc] : arcs) {
      out.apart += std::abs(arc.read[k] - arc.shown[k]) / n;
      read += arc.read[k] / n;
      out.shown += arc.shown[k] / n;
    }
    for (const auto& [where, arc] : arcs) {
      const double a = arc.read[k] - read, b = arc.shown[k] - out.shown;
      both += a * b;
      read2 += a * a;
      shown2 += b * b;
    }
    out.change = std::sqrt(read2 / shown2);
    out.together = both / std::sqrt(read2 * shown2);
    out.shown_changes = std::sqrt(shown2 / n) / out.shown;
    out.read_changes = std::sqrt(read2 / n) / out.shown;
    return out;
  }
};

TEST_F(SkinReading, EveryGlazeIsReadOffAsTheKilnShowsItPlaceForPlace) {
  const ClayView clay = grooved_pot();
  renderer().show_clay(clay);
  const ClayMesh mesh = faced_mesh_of(clay);
  const auto glazes = content::read_glazes("content/glazes.toml").glazes;
  ASSERT_FALSE(glazes.empty());
  const Sight sight{in_the_kiln};
  constexpr double kEven = 0.01;
  int patterned = 0;
  for (const content::Glaze& glaze : glazes) {
    content::GlazeLook look = glaze.look;
    look.gloss = 0;
    const Arcs arcs = arcs_of(look, mesh, ClayFace::outer, sight);
    ASSERT_GT(arcs.size(), 500u) << glaze.id;
    for (std::size_t k = 0; k < 3; ++k) {
      const Alike is = alike(arcs, k);
      RecordProperty(glaze.id + std::to_string(k), std::to_string(is.apart / is.shown));
      EXPECT_LT(is.apart, 0.05 * is.shown + 0.002) << glaze.id << ' ' << k;
      if (is.read_changes < kEven) {
        // White porcelain is white everywhere; what changes is what dividing by little light
        // leaves.
        EXPECT_LT(is.shown_changes, 4 * kEven) << glaze.id << ' ' << k;
        continue;
      }
      ++patterned;
      EXPECT_GT(is.together, 0.9) << glaze.id << ' ' << k;
      EXPECT_NEAR(is.change, 1.0, 0.25) << glaze.id << ' ' << k;
    }
  }
  EXPECT_GT(patterned, 12) << "most glazes have a pattern";
}

TEST_F(SkinReading, SoIsTheLipOnWhichItBreaks) {
  const ClayView clay = grooved_pot();
  renderer().show_clay(clay);
  const ClayMesh mesh = faced_mesh_of(clay);
  const Sight sight{into_the_mouth};
  for (const content::Glaze& glaze : content::read_glazes("content/glazes.toml").glazes) {
    if (glaze.id != "celadon" && glaze.id != "tenmoku") continue;  // Those that change most there.
    content::GlazeLook look = glaze.look;
    look.gloss = 0;
    const Arcs arcs = arcs_of(look, mesh, ClayFace::rim, sight);
    ASSERT_GT(arcs.size(), 100u) << glaze.id;
    for (const std::size_t k : {1u, 2u}) {
      const Alike is = alike(arcs, k);
      RecordProperty(glaze.id + std::to_string(k), std::to_string(is.apart / is.shown) + ' ' +
                                                       std::to_string(is.together) + ' ' +
                                                       std::to_string(is.change));
      EXPECT_LT(is.apart, 0.08 * is.shown) << glaze.id << ' ' << k;
      EXPECT_GT(is.together, 0.9) << glaze.id << ' ' << k;
      EXPECT_NEAR(is.change, 1.0, 0.25) << glaze.id << ' ' << k;
    }
  }
}

TEST_F(SkinReading, TheGlassIsThinOnTheLipsCrownAndNowhereElse) {
  // Upright, so that the lip is as wide as its wall.
  const ClayView clay = thrown_clay(
      kPotGrid, [](double) { return 0.05; }, 0.006, 0.0);
  renderer().show_clay(clay);
  const ClayMesh mesh = faced_mesh_of(clay);
  content::GlazeLook look;
  look.body = {1, 1, 1};
  look.glass = {0.2f, 0.4f, 0.8f};
  look.slip_cover = look.pooling = 0;
  const auto skin = renderer().read_skin(mesh, view::Glazing{look, 1.0});
  // Of two colours the thicker glass takes more apart, whatever the body is (Beer-Lambert).
  std::map<std::pair<ClayFace, int>, std::pair<double, int>> rings;
  std::map<ClayFace, std::size_t> first;
  for (std::size_t i = 0; i < skin.size(); ++i) {
    const ClayFace face = mesh.faces[i];
    first.try_emplace(face, i);
    auto& [sum, count] = rings[{face, static_cast<int>((i - first[face]) / 180)}];
    sum += std::log(static_cast<double>(skin[i].color[2] / skin[i].color[0]));
    ++count;
  }
  const auto thick = [&](ClayFace face, int ring) {
    const auto& [sum, count] = rings.at({face, ring});
    return sum / count;
  };
  const double wall = thick(ClayFace::outer, 100);
  EXPECT_NEAR(thick(ClayFace::inner, 100), wall, 0.05 * wall);
  EXPECT_NEAR(thick(ClayFace::floor, 0), wall, 0.1 * wall);
  const int crown = 6, last = 12;  // rings of the lip, which run from face to face
  EXPECT_LT(thick(ClayFace::rim, crown), 0.3 * wall) << "it breaks pale";
  for (const int shoulder : {0, last}) {
    const double half_way = thick(ClayFace::rim, (shoulder + crown) / 2);
    EXPECT_GT(thick(ClayFace::rim, shoulder), half_way + 0.15 * wall);
    EXPECT_GT(half_way, thick(ClayFace::rim, crown) + 0.15 * wall);
  }
}

TEST_F(SkinReading, InsideItRunsToTheFloorMoreThanOutsideAndTheFloorIsInside) {
  const ClayView clay = thrown_clay(
      kPotGrid, [](double) { return 0.05; }, 0.006, 0.0);
  renderer().show_clay(clay);
  const ClayMesh mesh = faced_mesh_of(clay);
  content::GlazeLook look;
  look.body = {1, 1, 1};
  look.glass = {0.2f, 0.4f, 0.8f};
  look.slip_cover = 0;
  look.pooling = 0.75f;
  const auto skin = renderer().read_skin(mesh, view::Glazing{look, 1.0});
  std::map<ClayFace, std::pair<double, int>> low;  // thickness, as above
  for (std::size_t i = 0; i < skin.size(); ++i) {
    if (mesh.mesh.positions[i][1] < 0.011f || mesh.mesh.positions[i][1] > 0.03f) continue;
    auto& [sum, count] = low[mesh.faces[i]];
    sum += std::log(static_cast<double>(skin[i].color[2] / skin[i].color[0]));
    ++count;
  }
  const auto thick = [&](ClayFace face) { return low.at(face).first / low.at(face).second; };
  EXPECT_GT(thick(ClayFace::inner), 1.15 * thick(ClayFace::outer));
  EXPECT_GT(thick(ClayFace::floor), 1.15 * thick(ClayFace::outer));
}

TEST_F(SkinReading, TheFootIsBareClayAndAGlossierGlazeIsSmoother) {
  const ClayView clay = grooved_pot();
  renderer().show_clay(clay);
  const ClayMesh mesh = faced_mesh_of(clay);
  std::array<double, 2> wall{};
  for (const bool glossy : {false, true}) {
    content::GlazeLook look;
    look.gloss = glossy ? 0.9f : 0.2f;
    const auto skin = renderer().read_skin(mesh, view::Glazing{look, 1.0});
    int walls = 0, feet = 0;
    for (std::size_t i = 0; i < skin.size(); ++i) {
      const float y = mesh.mesh.positions[i][1];
      if (mesh.faces[i] == ClayFace::foot) {
        ++feet;
        EXPECT_NEAR(skin[i].roughness, 0.7, 0.01);
        for (std::size_t k = 0; k < 3; ++k)
          EXPECT_NEAR(skin[i].color[k], look.body[k], 0.16 * look.body[k])
              << "the glaze was wiped off";
      } else if (mesh.faces[i] == ClayFace::outer && y > 0.05f && y < 0.13f) {
        ++walls;
        wall[glossy] += static_cast<double>(skin[i].roughness);
      }
    }
    ASSERT_GT(feet, 0);
    ASSERT_GT(walls, 1000);
    wall[glossy] /= walls;
  }
  EXPECT_LT(wall[1], 0.2);
  EXPECT_GT(wall[0], 0.45);
}

TEST_F(SkinReading, InsideItPoolsInTheGroovesToo) {
  const ClayView clay = grooved_pot();
  renderer().show_clay(clay);
  const ClayMesh mesh = faced_mesh_of(clay);
  // From a groove to the ridge beside it: how far green goes up and down.
  std::array<double, 2> ripple{};
  for (const bool pools : {false, true}) {
    content::GlazeLook look;
    look.pooling = pools ? 0.75f : 0.0f;
    const auto skin = renderer().read_skin(mesh, view::Glazing{look, 1.0});
    int inside = 0;
    for (std::size_t i = 0; i + 5 * 180 < skin.size(); ++i) {
      const float y = mesh.mesh.positions[i][1];
      const auto green = static_cast<double>(skin[i].color[1]);
      if (mesh.faces[i] != ClayFace::inner || y < 0.08f || y > 0.12f) continue;
      ++inside;
      ripple[pools] += std::abs(green - static_cast<double>(skin[i + 5 * 180].color[1]));
    }
    ASSERT_GT(inside, 1000);
    ripple[pools] /= inside;
  }
  EXPECT_GT(ripple[1], 2.0 * ripple[0]);
}

TEST_F(SkinReading, APotThatWasNotFiredIsDryClay) {
  const ClayView clay = grooved_pot();
  renderer().show_clay(clay);
  const auto skin = renderer().read_skin(faced_mesh_of(clay), std::nullopt);
  Color mean{};
  for (const view::SkinPoint& point : skin) {
    EXPECT_NEAR(point.roughness, 0.78, 0.01);
    for (std::size_t k = 0; k < 3; ++k)
      mean[k] += static_cast<double>(point.color[k]) / static_cast<double>(skin.size());
  }
  const Color look_md{0.405, 0.240, 0.137};  // "dry clay #B08968"
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(mean[k] / look_md[k], 1.0, 0.05) << k;
}

TEST_F(SkinReading, AfterAReadingEveryPictureIsAsItWasBefore) {
  const ClayView clay = grooved_pot();
  renderer().show_clay(clay);
  const view::Frame frame = in_the_kiln(content::GlazeLook{});
  const view::Image before = renderer().draw_offscreen(frame);
  (void)renderer().read_skin(faced_mesh_of(clay), view::Glazing{});
  EXPECT_EQ(renderer().draw_offscreen(frame).rgba, before.rgba);
}

}  // namespace
}  // namespace onggi::render::testing::skin_reader_test
