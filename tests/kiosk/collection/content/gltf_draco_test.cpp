#include "kiosk/collection/content/gltf_draco.h"

#ifdef ONGGI_HAS_DRACO
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#endif

#include "tests/kiosk/collection/content/temporary.h"

// What Draco holds is what glTF says it is.

namespace onggi::content::gltf_draco_test {
namespace {

class DracoTest : public Temporary {};

#ifdef ONGGI_HAS_DRACO

/// One triangle whose corners have the colours and places `colors` and `places`, as whole numbers
/// of which Draco is not told that they are shares.
std::vector<unsigned char> triangle(const std::array<std::array<std::uint8_t, 4>, 3>& colors,
                                    const std::array<std::array<std::uint16_t, 2>, 3>& places) {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(1);
  const int position =
      builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const int color = builder.AddAttribute(draco::GeometryAttribute::COLOR, 4, draco::DT_UINT8);
  const int place = builder.AddAttribute(draco::GeometryAttribute::TEX_COORD, 2, draco::DT_UINT16);
  const std::array<std::array<float, 3>, 3> corners{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  const auto set = [&](int attribute, const auto& of) {
    builder.SetAttributeValuesForFace(attribute, draco::FaceIndex(0), of[0].data(), of[1].data(),
                                      of[2].data());
  };
  set(position, corners);
  set(color, colors);
  set(place, places);
  const auto mesh = builder.Finalize();
  draco::Encoder encoder;
  draco::EncoderBuffer buffer;
  if (mesh == nullptr || !encoder.EncodeMeshToBuffer(*mesh, &buffer).ok()) return {};
  return {buffer.data(), buffer.data() + buffer.size()};
}

TEST_F(DracoTest, colours_in_bytes_are_shares_and_places_are_where_the_file_says_so) {
  const auto bytes = triangle({{{0, 51, 255, 255}, {0, 51, 255, 255}, {0, 51, 255, 255}}},
                              {{{0, 13107}, {0, 13107}, {0, 13107}}});
  ASSERT_FALSE(bytes.empty());
  DracoPrimitive primitive;
  primitive.position = 0;
  primitive.color = 1;
  primitive.places = {{0, 2}};
  const auto plain = decode_draco(bytes, primitive, 0, "jar.glb", {});
  ASSERT_TRUE(plain) << to_text(plain.error());
  ASSERT_EQ(plain->colors.size(), 3u);
  for (const auto& color : plain->colors) {
    EXPECT_EQ(color[0], 0.0f);
    EXPECT_FLOAT_EQ(color[1], 0.2f);
    EXPECT_EQ(color[2], 1.0f);
  }
  ASSERT_EQ(plain->places.size(), 3u);
  EXPECT_EQ(plain->places[1][1], 13107.0f) << "a whole number that nobody calls a share";
  primitive.normalized = {0};
  const auto shares = decode_draco(bytes, primitive, 0, "jar.glb", {});
  ASSERT_TRUE(shares) << to_text(shares.error());
  EXPECT_FLOAT_EQ(shares->places[1][1], 0.2f);
}

#endif

TEST_F(DracoTest, a_file_says_of_each_set_of_places_whether_its_whole_numbers_are_shares) {
  const auto opened = open_gltf(
      write("jar.gltf",
            R"({"asset":{"version":"2.0"},"accessors":[{"componentType":5123,"count":3,)"
            R"("type":"VEC2","normalized":true},{"componentType":5123,"count":3,"type":"VEC2"}],)"
            R"("meshes":[{"primitives":[{"attributes":{"TEXCOORD_0":1,"TEXCOORD_2":0},)"
            R"("extensions":{"KHR_draco_mesh_compression":{"bufferView":0,)"
            R"("attributes":{"TEXCOORD_0":0,"TEXCOORD_2":1}}}}]}]})"),
      {});
  ASSERT_TRUE(opened) << to_text(opened.error());
  EXPECT_EQ(opened->draco.at({0, 0}).normalized, std::set<int>{2});
}

}  // namespace
}  // namespace onggi::content::gltf_draco_test
