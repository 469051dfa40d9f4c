#include "kiosk/exhibit/composition/pot_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>

#include "kiosk/collection/content/gltf.h"
#include "kiosk/collection/decoration/unrolled.h"
#include "kiosk/picture/encoding/encode.h"
#include "tests/engine/profile/shapes.h"
#include "tests/kiosk/ground/files/disk.h"

namespace onggi::exhibit::pot_model_test {
namespace {

/// A jar of many colours: a smooth glaze on a rough foot.
std::vector<view::SkinPoint> skin_of(const TriangleMesh& mesh) {
  std::vector<view::SkinPoint> skin;
  for (const auto& p : mesh.positions) {
    const float foot = p[1] < 0.01f ? 0.7f : 0.12f;
    skin.push_back({{0.02f + 2.0f * p[1], 0.3f, 0.05f + std::abs(p[0])}, foot});
  }
  return skin;
}

nlohmann::json json_of(const std::vector<std::byte>& glb) {
  std::uint32_t length = 0;
  std::memcpy(&length, glb.data() + 12, 4);
  return nlohmann::json::parse(std::string(reinterpret_cast<const char*>(glb.data()) + 20, length));
}

Result<content::GltfModel> read_back(const std::vector<std::byte>& glb) {
  const files::test::ScratchFolder scratch;
  const auto file = scratch.path() / "pot.glb";
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(glb.data()), static_cast<std::streamsize>(glb.size()));
  return content::read_gltf(file);
}

TEST(PotModel, IsReadBackInTheColoursThatItWasSeenIn) {
  const TriangleMesh mesh = revolve(section_of(shapes::jar()), 24);
  const auto skin = skin_of(mesh);
  const auto glb = pot_model(mesh, skin, "celadon", "Jar", "CC0");
  EXPECT_EQ(glb, pot_model(mesh, skin, "celadon", "Jar", "CC0"));
  const auto model = read_back(glb);
  ASSERT_TRUE(model) << to_text(model.error());
  EXPECT_EQ(model->mesh.triangles.size(), mesh.triangles.size());
  const auto light = content::baked(model->coloring);
  ASSERT_EQ(light.size(), model->mesh.positions.size());
  std::set<std::array<float, 3>> places;
  for (std::size_t i = 0; i < light.size(); ++i) {
    const auto& p = model->mesh.positions[i];
    const auto own = std::ranges::find_if(mesh.positions, [&](const auto& q) {
      return std::abs(p[0] - q[0]) + std::abs(p[1] - q[1]) + std::abs(p[2] - q[2]) < 1e-6f;
    });
    ASSERT_NE(own, mesh.positions.end());
    places.insert(*own);
    const auto& color = skin[static_cast<std::size_t>(own - mesh.positions.begin())].color;
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(content::display_of(light[i][k]), content::display_of(color[k]), 1) << i;
  }
  EXPECT_EQ(places.size(), std::set(mesh.positions.begin(), mesh.positions.end()).size());
}

TEST(PotModel, HasAMaterialForWhatIsSmoothAndOneForWhatIsRoughAndNeedsNoExtension) {
  const TriangleMesh mesh = revolve(section_of(shapes::jar()), 24);
  const auto json = json_of(pot_model(mesh, skin_of(mesh), "celadon", "Jar", "CC0"));
  EXPECT_FALSE(json.contains("extensionsRequired"));
  EXPECT_FALSE(json.contains("extensionsUsed"));
  const auto& primitives = json["meshes"][0]["primitives"];
  ASSERT_EQ(primitives.size(), json["materials"].size());
  std::size_t corners = 0;
  double before = 0;
  for (const auto& primitive : primitives) {
    EXPECT_EQ(primitive["attributes"], primitives[0]["attributes"]) << "viewers share them";
    corners +=
        json["accessors"][primitive["indices"].get<std::size_t>()]["count"].get<std::size_t>();
    const auto& surface = json["materials"][primitive["material"].get<std::size_t>()];
    const double rough = surface["pbrMetallicRoughness"]["roughnessFactor"];
    EXPECT_GT(rough, before) << "the smoothest first";
    before = rough;
    EXPECT_EQ(surface["pbrMetallicRoughness"]["metallicFactor"], 0.0);
  }
  EXPECT_EQ(corners, 3 * mesh.triangles.size());
  EXPECT_NEAR(json["materials"].front()["pbrMetallicRoughness"]["roughnessFactor"], 0.12, 0.01);
  EXPECT_NEAR(json["materials"].back()["pbrMetallicRoughness"]["roughnessFactor"], 0.7, 0.01);
  EXPECT_EQ(json["materials"].front()["name"], "celadon");
}

TEST(PotModel, AViewerWithoutColoursAtCornersShowsOneOfThePots) {
  const TriangleMesh mesh = revolve(section_of(shapes::bowl()), 16);
  const std::vector<view::SkinPoint> even(mesh.positions.size(), {{0.31f, 0.22f, 0.0f}, 0.5f});
  const auto json = json_of(pot_model(mesh, even, "clay", "Bowl", ""));
  ASSERT_EQ(json["materials"].size(), 1u);
  const auto& factor = json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"];
  EXPECT_NEAR(factor[0], 0.31, 2e-4);
  EXPECT_NEAR(factor[1], 0.22, 2e-4);
  EXPECT_NEAR(factor[2], 0.0, 2e-4);
}

TEST(PotModel, ADecoratedOneIsReadBackWithItsPictureWherePositionsLieInIt) {
  decoration::Skin skin{revolve(section_of(shapes::jar()), 24), {}};
  for (const auto& p : skin.mesh.positions) {
    const float turns = std::atan2(p[2], p[0]) / 6.2831853f;
    skin.places.push_back({turns < 0.0f ? turns + 1.0f : turns, 4.0f * p[1]});
  }
  decoration::close_round(skin);
  // Four quarters round, each darker below.
  constexpr int kSide = 64;
  view::Image picture{kSide, kSide, {}};
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      for (const int value : {60 + 40 * (x / 16), 200 - 2 * y, 90, 255})
        picture.rgba.push_back(static_cast<std::uint8_t>(value));
  for (const auto format : {encoding::Format::png, encoding::Format::jpeg}) {
    const auto file = encoding::encode(picture, format, {});
    ASSERT_TRUE(file) << to_text(file.error());
    const auto glb = pot_model(skin.mesh, "celadon", "Jar", "CC0", {skin.places, *file});
    const auto model = read_back(glb);
    ASSERT_TRUE(model) << to_text(model.error());
    EXPECT_TRUE(model->warnings.empty());
    const auto light = content::baked(model->coloring);
    ASSERT_EQ(light.size(), model->mesh.positions.size());
    int looked = 0;
    for (std::size_t i = 0; i < light.size(); ++i) {
      const auto& p = model->mesh.positions[i];
      const float turns = std::atan2(p[2], p[0]) / 6.2831853f;
      const float x = 4.0f * (turns < 0.0f ? turns + 1.0f : turns);
      if (x - std::floor(x) < 0.1f || x - std::floor(x) > 0.9f) continue;  // an edge of it
      ++looked;
      EXPECT_NEAR(content::display_of(light[i][0]), 60 + 40 * static_cast<int>(x), 6);
      // The jar's rim lies beyond the picture's last row, which goes on there.
      EXPECT_NEAR(content::display_of(light[i][1]), std::max(200 - 2 * 64 * 4 * p[1], 74.0f), 6);
    }
    EXPECT_GT(looked, 300);
    const auto json = json_of(glb);
    ASSERT_EQ(json["materials"].size(), 1u);
    EXPECT_EQ(json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"], 0);
    EXPECT_FALSE(json["materials"][0].contains("normalTexture"));
    EXPECT_FALSE(json["meshes"][0]["primitives"][0]["attributes"].contains("COLOR_0"));
  }
}

/// FNV-1a, 64 bits.
std::uint64_t hash_of(const std::vector<std::byte>& bytes) {
  std::uint64_t hash = 14695981039346656037u;
  for (const std::byte one : bytes)
    hash = (hash ^ std::to_integer<std::uint64_t>(one)) * 1099511628211u;
  return hash;
}

TEST(PotModel, AFileWithoutPicturesOfRoughnessAndNormalsHasTheBytesThatItHadBeforeThereWereAny) {
  // Of write_glb() at 69869196.
  const TriangleMesh mesh = revolve(section_of(shapes::jar()), 24);
  std::vector<std::array<float, 3>> colors;
  for (const auto& p : mesh.positions) colors.push_back({0.5f, p[1], 0.25f});
  const std::vector<content::GlbPart> parts{{0, {}}, {30, {"celadon", {1, 1, 1}, 0.2f}}};
  EXPECT_EQ(hash_of(content::write_glb(mesh, "Jar", "CC0", parts, colors, 2)), 0x410b325f144a6cecu);
  EXPECT_EQ(hash_of(content::write_glb(mesh, "Jar", "CC0", content::GlbMaterial{}, colors)),
            0x8c781e9ceaf6731eu);
  content::GlbPicture picture;
  picture.places.assign(mesh.positions.size(), {0.5f, 0.25f});
  picture.file.assign(5, std::byte{0xFF});
  EXPECT_EQ(hash_of(content::write_glb(mesh, "Jar", "CC0", content::GlbMaterial{}, picture)),
            0x8d2a175ff62bcc7au);
}

TEST(PotModel, ADecoratedOnesPicturesOfRoughnessAndNormalsAreItsMaterialsAndLieWholeInTheFile) {
  decoration::Skin skin{revolve(section_of(shapes::jar()), 24), {}};
  for (const auto& p : skin.mesh.positions) {
    const float turns = std::atan2(p[2], p[0]) / 6.2831853f;
    skin.places.push_back({turns < 0.0f ? turns + 1.0f : turns, 4.0f * p[1]});
  }
  const auto picture = [](std::uint8_t grey) {
    return *encoding::encode({16, 8, std::vector<std::uint8_t>(16 * 8 * 4, grey)},
                             encoding::Format::jpeg, {});
  };
  const std::array files{picture(200), picture(90), picture(128)};
  const auto glb =
      pot_model(skin.mesh, "celadon", "Jar", "CC0", {skin.places, files[0], files[1], files[2]});
  const auto json = json_of(glb);
  EXPECT_FALSE(json.contains("extensionsUsed"));
  const auto& material = json["materials"][0];
  const auto& coat = material["pbrMetallicRoughness"];
  EXPECT_EQ(coat["metallicFactor"], 0.0);
  EXPECT_EQ(coat["roughnessFactor"], 1.0) << "the picture says it alone";
  const std::array indices{coat["baseColorTexture"]["index"].get<std::size_t>(),
                           coat["metallicRoughnessTexture"]["index"].get<std::size_t>(),
                           material["normalTexture"]["index"].get<std::size_t>()};
  std::uint32_t length = 0;
  std::memcpy(&length, glb.data() + 12, 4);
  for (std::size_t n = 0; n < 3; ++n) {
    const auto source = json["textures"][indices[n]]["source"].get<std::size_t>();
    const auto& view = json["bufferViews"][json["images"][source]["bufferView"].get<std::size_t>()];
    const auto from = 28 + length + view["byteOffset"].get<std::size_t>();
    ASSERT_EQ(view["byteLength"], files[n].size());
    EXPECT_TRUE(std::equal(files[n].begin(), files[n].end(),
                           glb.begin() + static_cast<std::ptrdiff_t>(from)))
        << n;
  }
  const auto model = read_back(glb);
  ASSERT_TRUE(model) << to_text(model.error());
  EXPECT_TRUE(model->warnings.empty());
  // Tangents go round the pot, to the right in the pictures, square to the normals.
  const auto& attributes = json["meshes"][0]["primitives"][0]["attributes"];
  const auto& tangents = json["accessors"][attributes["TANGENT"].get<std::size_t>()];
  EXPECT_EQ(tangents["type"], "VEC4");
  ASSERT_EQ(tangents["count"], skin.mesh.positions.size());
  const auto& view = json["bufferViews"][tangents["bufferView"].get<std::size_t>()];
  const auto from = 28 + length + view["byteOffset"].get<std::size_t>();
  EXPECT_EQ(from % 4, 0u);
  for (std::size_t n = 0; n < skin.mesh.positions.size(); ++n) {
    std::array<float, 4> t{};
    std::memcpy(t.data(), glb.data() + from + 16 * n, 16);
    const auto& p = skin.mesh.positions[n];
    const auto& normal = skin.mesh.normals[n];
    EXPECT_NEAR(t[0] * normal[0] + t[1] * normal[1] + t[2] * normal[2], 0.0, 1e-5);
    EXPECT_NEAR(std::hypot(t[0], t[1], t[2]), 1.0, 1e-5);
    EXPECT_EQ(t[3], 1.0f);
    const float far = std::hypot(p[0], p[2]);
    if (far > 0.01f) {
      EXPECT_GT((p[0] * t[2] - p[2] * t[0]) / far, 0.99f) << n;
    }
  }
}

}  // namespace
}  // namespace onggi::exhibit::pot_model_test
