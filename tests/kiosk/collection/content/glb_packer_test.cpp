#include "kiosk/collection/content/glb_packer.h"

#include <gtest/gtest.h>

#include "kiosk/collection/content/gltf.h"
#include "tests/kiosk/collection/content/temporary.h"
#include "tests/kiosk/collection/content/textured_scan.h"
#include "tests/kiosk/collection/textures/made_pictures.h"

// A glTF in several files becomes one file, and is the same vessel in the same colours.

namespace onggi::content::glb_packer_test {
namespace {

using testing::TexturedScan;
using textures::testing::png_of;
using textures::testing::two_halves;

class PackedGlb : public Temporary {
 protected:
  /// The scan as a .gltf with its buffer beside it; its picture beside it, too, or within.
  std::filesystem::path in_pieces(const TexturedScan& scan, const std::string& buffer_uri) {
    const std::string glb = scan.glb();
    const auto word = [&glb](std::size_t at) {
      std::size_t out = 0;
      for (std::size_t i = 0; i < 4; ++i)
        out |= static_cast<std::size_t>(static_cast<unsigned char>(glb[at + i])) << (8 * i);
      return out;
    };
    std::string json = glb.substr(20, word(12));
    // The second of two buffers, so that both its number and what lies in it move.
    const std::string mark = "\"buffers\":[{", view = "{\"buffer\":0,";
    for (std::size_t at = json.find(view); at != std::string::npos; at = json.find(view, at))
      json.replace(at, view.size(), "{\"buffer\":1,");
    json.insert(
        json.find(mark) + mark.size() - 1,
        "{\"uri\":\"data:application/octet-stream;base64,AAAAAAAAAAAAAAAA\",\"byteLength\":12},");
    json.insert(json.find("},{", json.find(mark)) + 3, "\"uri\":\"" + buffer_uri + "\",");
    write("jar parts.bin", glb.substr(28 + word(12)));
    return write("jar.gltf", json);
  }
  Result<GltfModel> packed(const std::filesystem::path& file) {
    const auto bytes = pack_glb(file, {});
    if (!bytes) return tl::unexpected(bytes.error());
    std::filesystem::create_directories(folder_ / "elsewhere");
    return read_gltf(
        write("elsewhere/jar.glb",
              std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size())));
  }
};

TEST_F(PackedGlb, is_the_same_vessel_in_the_same_colours_without_the_files_beside_it) {
  const std::string picture = png_of(two_halves(16, {20, 40, 200}, {190, 30, 25}));
  TexturedScan beside;
  beside.image = "\"uri\":\"coat.png\"";
  write("coat.png", picture);
  TexturedScan within;
  within.image = "\"uri\":\"data:image/png;base64,iVBORw0KGgo=\"";  // no picture, but bytes
  const TexturedScan own{.picture = picture};
  for (const TexturedScan& scan : {beside, own, within}) {
    const auto file = in_pieces(scan, "jar%20parts.bin");
    const auto whole = read_gltf(file);
    ASSERT_TRUE(whole) << to_text(whole.error());
    const auto model = packed(file);
    ASSERT_TRUE(model) << to_text(model.error());
    EXPECT_EQ(model->mesh.positions, whole->mesh.positions);
    EXPECT_EQ(model->mesh.triangles, whole->mesh.triangles);
    EXPECT_EQ(model->coloring.places, whole->coloring.places);
    ASSERT_EQ(model->coloring.pictures.size(), whole->coloring.pictures.size());
    for (std::size_t i = 0; i < model->coloring.pictures.size(); ++i)
      EXPECT_EQ(*model->coloring.pictures[i].pixels, *whole->coloring.pictures[i].pixels);
    EXPECT_EQ(model->warnings.size(), whole->warnings.size());
  }
}

TEST_F(PackedGlb, has_a_picture_that_is_missing_by_its_name_and_no_buffer_that_is) {
  TexturedScan missing;
  missing.image = "\"uri\":\"not_there.png\"";
  const auto model = packed(in_pieces(missing, "jar%20parts.bin"));
  ASSERT_TRUE(model) << to_text(model.error());
  ASSERT_EQ(model->warnings.size(), 1u);
  EXPECT_NE(model->warnings[0].find("not_there.png"), std::string::npos) << model->warnings[0];
  EXPECT_FALSE(packed(in_pieces(missing, "no.bin")));
  EXPECT_FALSE(packed(in_pieces(missing, "../jar.bin")));
}

}  // namespace
}  // namespace onggi::content::glb_packer_test
