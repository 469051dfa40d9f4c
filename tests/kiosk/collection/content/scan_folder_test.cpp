#include "kiosk/collection/content/scan_folder.h"

#include <gmock/gmock.h>

#include "tests/kiosk/collection/content/temporary.h"

namespace onggi::content::scan_folder_test {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string manifest_of(const std::string& scan) {
  return R"({"type":"Manifest","items":[{"type":"Scene","items":[{"items":[{"type":"Annotation","body":{"id":")" +
         scan + R"(","type":"Model","format":"model/gltf-binary"}}]}]}]})";
}

class ScanFolder : public Temporary {
 protected:
  std::vector<fs::path> offered() const { return scans_in(folder_).offered(); }
};

TEST_F(ScanFolder, AMeshOfAnyKindIsFoundAtAnyDepthAndWhatBelongsToItIsNot) {
  EXPECT_THAT(offered(), IsEmpty());
  write("jar/model/scene.gltf", "{}");
  write("jar/model/scene.bin", "x");
  write("jar/textures/colour.png", "x");
  write("jar/scene.mtl", "x");
  write("readme.txt", "x");
  EXPECT_THAT(offered(), ElementsAre("jar/model/scene.gltf"));
  for (const char* more : {"a.GLB", "b.obj", "c.ply", "d.STL"}) write(more, "x");
  EXPECT_THAT(offered(), ElementsAre("a.GLB", "b.obj", "c.ply", "d.STL", "jar/model/scene.gltf"));
}

TEST_F(ScanFolder, ADocumentGoesBeforeTheMeshesThatItNames) {
  write("jar/jar-150k.glb", "glTF");
  write("jar/jar-25k.glb", "glTF");
  write("jar/other.json", R"({"type":"annotation"})");
  write("jar/manifest.json", manifest_of("jar-150k.glb"));
  EXPECT_THAT(offered(), ElementsAre("jar/manifest.json"));
  EXPECT_THAT(scans_in(folder_).meshes, ElementsAre("jar/jar-150k.glb", "jar/jar-25k.glb"));
}

TEST_F(ScanFolder, ADocumentWhoseScanIsNotThereIsSaidAndTheMeshesAreOffered) {
  write("jar.glb", "glTF");
  write("manifest.json", manifest_of("finer.glb"));
  const FolderScans found = scans_in(folder_);
  EXPECT_THAT(found.offered(), ElementsAre("jar.glb"));
  ASSERT_EQ(found.unusable.size(), 1u);
  EXPECT_THAT(to_text(found.unusable[0]), HasSubstr("finer.glb"));
}

TEST_F(ScanFolder, LinksAreNotFollowed) {
  write("elsewhere/jar.glb", "glTF");
  fs::create_directories(folder_ / "scan");
  fs::create_symlink(folder_ / "elsewhere/jar.glb", folder_ / "scan/link.glb");
  fs::create_directory_symlink(folder_ / "elsewhere", folder_ / "scan/folder");
  EXPECT_THAT(scans_in(folder_ / "scan").offered(), IsEmpty());
  EXPECT_THAT(scans_in(folder_ / "none").offered(), IsEmpty());
}

TEST_F(ScanFolder, ItLooksSixteenFoldersDeep) {
  fs::path deep;
  for (int n = 0; n < 16; ++n) deep /= "f";
  write((deep / "in.glb").string(), "x");
  write((deep / "f/beyond.glb").string(), "x");
  EXPECT_THAT(offered(), ElementsAre(deep / "in.glb"));
}

}  // namespace
}  // namespace onggi::content::scan_folder_test
