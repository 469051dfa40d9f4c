#include "kiosk/collection/content/gltf_coloring.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include <algorithm>

#include "kiosk/collection/content/gltf.h"
#include "kiosk/collection/content/pack_writer.h"
#include "kiosk/collection/content/vessel.h"
#include "tests/kiosk/collection/content/temporary.h"
#include "tests/kiosk/collection/content/textured_scan.h"
#include "tests/kiosk/collection/textures/made_pictures.h"

// A scan's own colours: pictures on its surface, colours at its corners, of its materials. Whatever
// is wrong with them, the vessel stays whole.

namespace onggi::content::gltf_coloring_test {
namespace {

using testing::TexturedScan;
using textures::testing::jpeg_of;
using textures::testing::png_head;
using textures::testing::png_of;
using textures::testing::two_halves;
using textures::testing::webp_of;

constexpr std::array<std::uint8_t, 3> kUpper{20, 40, 200}, kLower{190, 30, 25};

class Colors : public Temporary {
 protected:
  static textures::TexturePixels halves() { return two_halves(64, kUpper, kLower); }
  static std::string sample(const std::string& name) {
    return files::test::content("tests/kiosk/collection/textures/samples/" + name);
  }
  Vessel read(const TexturedScan& scan, const settings::ReaderLimits& limits = {}) {
    LoadOptions options;
    options.limits = limits;
    const auto vessel = load_vessel(write("jar.glb", scan.glb()), options);
    EXPECT_TRUE(vessel) << to_text(vessel.error());
    return vessel ? *vessel : Vessel{};
  }
  /// The display colour of the surface at `height` of the jar, nearest pixel.
  static std::array<int, 3> seen(const Vessel& vessel, double height) {
    std::size_t nearest = 0;
    const auto apart = [&](std::size_t i) {
      return std::abs(static_cast<double>(vessel.mesh.positions[i][1]) - height);
    };
    for (std::size_t i = 0; i < vessel.mesh.positions.size(); ++i)
      if (apart(i) < apart(nearest)) nearest = i;
    const Coloring& c = vessel.coloring;
    if (c.empty()) return {-1, -1, -1};
    std::array<int, 3> out{};
    for (std::size_t k = 0; k < 3; ++k) {
      double light = static_cast<double>(light_of(c.colors[nearest][k]));
      if (!c.picture.empty() && c.picture[nearest] > 0) {
        const auto& p = *c.pictures[c.picture[nearest] - 1u].pixels;
        const auto x = static_cast<std::size_t>(std::clamp(
            static_cast<int>(c.places[nearest][0] * static_cast<float>(p.width)), 0, p.width - 1));
        const auto y = static_cast<std::size_t>(
            std::clamp(static_cast<int>(c.places[nearest][1] * static_cast<float>(p.height)), 0,
                       p.height - 1));
        light *= static_cast<double>(
            light_of(p.rgb[3 * (y * static_cast<std::size_t>(p.width) + x) + k]));
      }
      out[k] = display_of(static_cast<float>(light));
    }
    return out;
  }
  static void expect_near(std::array<int, 3> is, std::array<std::uint8_t, 3> meant, int apart,
                          const std::string& what) {
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(is[k], meant[k], apart) << what;
  }
  static int notes_of_colors(const Vessel& vessel) {
    int count = 0;
    for (const std::string& warning : vessel.extracted.warnings)
      if (warning.find("colour") != std::string::npos) ++count;
    return count;
  }
  static std::string note_of(const Vessel& vessel) {
    for (const std::string& warning : vessel.extracted.warnings)
      if (warning.find("colour") != std::string::npos) return warning;
    return "";
  }
};

TEST_F(Colors, a_blue_shoulder_over_a_red_foot_is_read_from_each_kind_of_picture) {
  TexturedScan png{.picture = png_of(halves())};
  TexturedScan jpeg{.picture = jpeg_of(halves()), .mime = "image/jpeg"};
  TexturedScan webp{.picture = webp_of(halves()),
                    .mime = "image/webp",
                    .texture = "\"extensions\":{\"EXT_texture_webp\":{\"source\":0}}",
                    .required = "EXT_texture_webp"};
  TexturedScan ktx2{.picture = sample("halves.ktx2"),
                    .mime = "image/ktx2",
                    .texture = "\"extensions\":{\"KHR_texture_basisu\":{\"source\":0}}",
                    .required = "KHR_texture_basisu"};
  for (const TexturedScan& scan : {png, jpeg, webp, ktx2}) {
    const Vessel vessel = read(scan);
    ASSERT_FALSE(vessel.coloring.empty()) << scan.mime;
    expect_near(seen(vessel, 0.25), kUpper, 6, scan.mime);
    expect_near(seen(vessel, 0.05), kLower, 6, scan.mime);
    EXPECT_EQ(notes_of_colors(vessel), 0) << note_of(vessel);
    EXPECT_EQ(vessel.coloring.places.size(), vessel.mesh.positions.size());
  }
}

TEST_F(Colors, v_goes_down_from_the_first_row) {
  TexturedScan scan{.picture = png_of(halves())};
  scan.turned_over = true;  // what it shows is then the other way round
  const Vessel vessel = read(scan);
  expect_near(seen(vessel, 0.25), kLower, 0, "above");
  expect_near(seen(vessel, 0.05), kUpper, 0, "below");
}

TEST_F(Colors, the_extension_that_moves_a_picture_moves_it) {
  TexturedScan scan{.picture = png_of(halves())};
  scan.use = ",\"extensions\":{\"KHR_texture_transform\":{\"offset\":[0,1],\"scale\":[1,-1]}}";
  const Vessel vessel = read(scan);
  expect_near(seen(vessel, 0.25), kLower, 0, "above");
  // A quarter turn: what was across is down.
  scan.use = ",\"extensions\":{\"KHR_texture_transform\":{\"rotation\":1.5707963267948966}}";
  const Vessel turned = read(scan);
  const auto straight = read(TexturedScan{.picture = png_of(halves())});
  for (const std::size_t i : {10u, 400u, 2000u}) {
    EXPECT_NEAR(turned.coloring.places[i][0], straight.coloring.places[i][1], 1e-6f);
    EXPECT_NEAR(turned.coloring.places[i][1], -straight.coloring.places[i][0], 1e-6f);
  }
}

TEST_F(Colors, the_materials_colour_lies_over_its_picture_as_light) {
  TexturedScan scan{.picture = png_of(two_halves(16, {255, 255, 255}, {128, 128, 128}))};
  scan.factor = "[1,0.5,0,1]";
  const Vessel vessel = read(scan);
  expect_near(seen(vessel, 0.25), {255, 188, 0}, 1, "half of the light");
  expect_near(seen(vessel, 0.05), {128, 92, 0}, 2, "half of it again");
}

TEST_F(Colors, colours_at_the_corners_are_light_and_not_display_values) {
  TexturedScan scan;
  for (const auto& p : scan.mesh().positions)
    scan.colors.push_back(p[1] > 0.15f ? std::array<std::uint8_t, 4>{0, 0, 128, 255}
                                       : std::array<std::uint8_t, 4>{255, 0, 0, 255});
  const Vessel vessel = read(scan);
  expect_near(seen(vessel, 0.25), {0, 0, 188}, 1, "half of the light is 188 of 255");
  expect_near(seen(vessel, 0.05), {255, 0, 0}, 0, "all of it");
  EXPECT_TRUE(vessel.coloring.pictures.empty());
}

TEST_F(Colors, a_material_of_one_colour_needs_no_more_than_that) {
  TexturedScan scan;
  scan.factor = "[0.2,0.3,0.4,1]";
  const Vessel vessel = read(scan);
  EXPECT_TRUE(vessel.coloring.empty());
  EXPECT_EQ(vessel.color, (std::array<float, 3>{0.2f, 0.3f, 0.4f}));
}

TEST_F(Colors, a_picture_that_cannot_be_read_is_told_once_and_the_vessel_stays_whole_in_clay) {
  const TexturedScan good{.picture = png_of(halves())};
  const auto whole = read(good);
  TexturedScan cut{.picture = png_of(halves()).substr(0, 3000)};
  TexturedScan other{.picture = "GIF89a, which no scan has"};
  TexturedScan missing;
  missing.image = "\"uri\":\"not_there.png\"";
  TexturedScan outside;
  outside.image = "\"uri\":\"../../../etc/hostname\"";
  TexturedScan nowhere{.picture = png_of(halves())};
  nowhere.texture = "\"source\":7";
  TexturedScan far{.picture = png_of(halves())};
  far.use = ",\"texCoord\":3";
  for (const auto& [scan, why] :
       {std::pair{cut, "damaged"}, std::pair{other, "not a PNG"},
        std::pair{missing, "not_there.png"}, std::pair{outside, "outside its own folder"},
        std::pair{nowhere, "picture"}, std::pair{far, "TEXCOORD_3"}}) {
    const Vessel vessel = read(scan);
    EXPECT_EQ(notes_of_colors(vessel), 1) << why;
    EXPECT_NE(note_of(vessel).find(why), std::string::npos) << note_of(vessel);
    EXPECT_TRUE(vessel.coloring.empty()) << why;
    EXPECT_EQ(vessel.color, kClayColor) << why;
    EXPECT_EQ(vessel.mesh.positions, whole.mesh.positions) << why;
  }
}

TEST_F(Colors, a_picture_bomb_is_refused_by_its_size_and_costs_nothing) {
  TexturedScan scan{.picture = png_head(30000, 30000)};
  const Vessel vessel = read(scan);
  EXPECT_NE(note_of(vessel).find("30000 x 30000 pixels"), std::string::npos) << note_of(vessel);
  // What the exhibit allows is what counts.
  settings::ReaderLimits limits;
  limits.texture_px = 32;
  scan.picture = png_of(halves());
  EXPECT_THAT(
      note_of(read(scan, limits)),
      ::testing::AllOf(::testing::HasSubstr("64 x 64 pixels"),
                       ::testing::HasSubstr("the limit for its longest side is 32"),
                       ::testing::HasSubstr("or raise texture_px in the exhibit's [reader]")));
  limits.texture_px = 0;
  const Vessel unread = read(scan, limits);
  EXPECT_TRUE(unread.coloring.empty());
  EXPECT_EQ(notes_of_colors(unread), 0) << note_of(unread);
}

TEST_F(Colors, too_few_at_the_corners_are_told_and_the_picture_is_shown_without_them) {
  TexturedScan scan{.picture = png_of(halves())};
  scan.colors.assign(scan.mesh().positions.size() - 1, {255, 255, 255, 255});
  const Vessel vessel = read(scan);
  expect_near(seen(vessel, 0.25), kUpper, 0, "the picture");
  EXPECT_NE(note_of(vessel).find("COLOR_0: it has"), std::string::npos) << note_of(vessel);
  EXPECT_NE(note_of(vessel).find("shown without"), std::string::npos) << note_of(vessel);
  EXPECT_EQ(note_of(vessel).find("clay"), std::string::npos) << note_of(vessel);
}

TEST_F(Colors, that_draco_holds_and_that_cannot_be_read_are_told) {
  const GltfDocument document;
  GltfReader reader(document, {});
  GltfColors colors(document, {});
  DecodedPrimitive draco;
  draco.colors_fault = true;
  colors.add({}, &draco, 1, reader);
  std::vector<std::string> notes;
  EXPECT_TRUE(colors.finish(reader, notes).empty());
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("COLOR_0"), std::string::npos) << notes[0];
}

TEST_F(Colors, where_a_picture_has_no_place_its_part_is_clay_though_its_corners_are_tinted) {
  TexturedScan scan{.picture = png_of(halves())};
  scan.use = ",\"texCoord\":3";
  scan.colors.assign(scan.mesh().positions.size(), {255, 0, 0, 255});
  const Vessel vessel = read(scan);
  EXPECT_TRUE(vessel.coloring.empty());
  EXPECT_NE(note_of(vessel).find("as plain clay"), std::string::npos) << note_of(vessel);
}

TEST_F(Colors, pictures_laid_on_in_more_ways_than_can_be_shown_are_told_once) {
  using Wrap = Coloring::Wrap;
  const std::string png = png_of(two_halves(2, kUpper, kLower));
  GltfDocument document;
  for (int i = 0; i < 29; ++i) {
    document.pictures.push_back(
        {"coat", -1, {reinterpret_cast<const unsigned char*>(png.data()), png.size()}, ""});
    for (const Wrap across : {Wrap::repeat, Wrap::clamp, Wrap::mirror})
      for (const Wrap down : {Wrap::repeat, Wrap::clamp, Wrap::mirror})
        document.materials.push_back({.textured = true,
                                      .picture = i,
                                      .coordinates = 0,
                                      .placed = {1, 0, 0, 0, 1, 0},
                                      .across = across,
                                      .down = down});
  }
  GltfReader reader(document, {});
  GltfColors colors(document, {});
  DecodedPrimitive draco;
  draco.places = {{0, 0}};
  tinygltf::Primitive primitive;
  for (primitive.material = 0; primitive.material < 29 * 9; ++primitive.material)
    colors.add(primitive, &draco, 1, reader);
  std::vector<std::string> notes;
  const Coloring made = colors.finish(reader, notes);
  EXPECT_EQ(made.pictures.size(), 255u);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("255"), std::string::npos) << notes[0];
}

TEST_F(Colors, none_of_a_scans_picture_files_is_read_where_none_is_wanted_and_64_where_all_are) {
  std::string images, textures, materials;
  for (int i = 0; i < 66; ++i) {
    const std::string comma = i == 0 ? "" : ",", n = std::to_string(i);
    write(n + ".png", "any bytes");
    images += comma + "{\"uri\":\"" + n + ".png\"}";
    textures += comma + "{\"source\":" + n + "}";
    materials += comma + "{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":" + n + "}}}";
  }
  const auto file =
      write("jar.gltf", "{\"asset\":{\"version\":\"2.0\"},\"images\":[" + images +
                            "],\"textures\":[" + textures + "],\"materials\":[" + materials + "]}");
  const auto all = open_gltf(file, {});
  ASSERT_TRUE(all) << to_text(all.error());
  EXPECT_EQ(all->beside.size(), 64u);
  EXPECT_EQ(all->pictures[63].fault, "");
  EXPECT_NE(all->pictures[64].fault.find("64"), std::string::npos) << all->pictures[64].fault;
  settings::ReaderLimits limits;
  limits.texture_px = 0;
  const auto none = open_gltf(file, limits);
  ASSERT_TRUE(none) << to_text(none.error());
  EXPECT_EQ(none->materials.size(), 66u);
  EXPECT_TRUE(none->beside.empty());
}

TEST_F(Colors, a_picture_within_the_file_that_is_larger_than_the_most_is_refused_and_not_cut) {
  settings::ReaderLimits limits;
  limits.file_mb = 1;
  // What is read beside it leaves it too little room.
  write("large.png", std::string((1u << 20) - 3, 'x'));
  const auto opened = open_gltf(
      write("jar.gltf",
            R"({"asset":{"version":"2.0"},"images":[{"uri":"large.png"},)"
            R"({"uri":"data:image/png;base64,AAAAAA=="},{"uri":"data:image/png;base64,AAAA"}],)"
            R"("textures":[{"source":0},{"source":1},{"source":2}],"materials":[)"
            R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}},)"
            R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":1}}},)"
            R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":2}}}]})"),
      limits);
  ASSERT_TRUE(opened) << to_text(opened.error());
  EXPECT_EQ(opened->pictures[0].fault, "");
  EXPECT_THAT(opened->pictures[1].fault,
              ::testing::AllOf(::testing::HasSubstr("the limit for them together is 1 MiB"),
                               ::testing::HasSubstr("or raise file_mb in the exhibit's [reader]")));
  EXPECT_TRUE(opened->pictures[1].bytes.empty());
  EXPECT_EQ(opened->pictures[2].bytes.size(), 3u) << "what just fits";
}

TEST_F(Colors, what_a_curator_says_goes_before_what_the_scan_shows) {
  write("pack/vessel.glb", TexturedScan{.picture = png_of(halves())}.glb());
  const std::string toml = "true_height_mm = 300\ncredit = \"c\"\nlicence = \"CC0-1.0\"\n";
  write("pack/vessel.toml", toml);
  const auto own = load_vessel(folder_ / "pack");
  ASSERT_TRUE(own) << to_text(own.error());
  EXPECT_FALSE(own->coloring.empty());
  // What import writes for it does not paint over it.
  EXPECT_NE(pack_toml(*own).find("\n# color = "), std::string::npos) << pack_toml(*own);
  write("pack/vessel.toml", toml + "color = [0.5, 0.5, 0.5]\n");
  const auto painted = load_vessel(folder_ / "pack");
  ASSERT_TRUE(painted) << to_text(painted.error());
  EXPECT_TRUE(painted->coloring.empty());
  EXPECT_NE(pack_toml(*painted).find("\ncolor = "), std::string::npos);
}

}  // namespace
}  // namespace onggi::content::gltf_coloring_test
