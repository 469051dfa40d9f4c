#include <algorithm>
#include <cstring>
#include <iterator>
#include <random>

#include "kiosk/collection/content/glb.h"
#include "kiosk/collection/content/gltf.h"
#include "tests/engine/profile/shapes.h"
#include "tests/kiosk/collection/content/temporary.h"

// A file that was damaged on the way: a model or a Problem, and nothing else.

namespace onggi::content::damaged_files_test {
namespace {

namespace fs = std::filesystem;

class DamagedFiles : public Temporary {
 protected:
  /// Reads `whole` with some bytes changed, or cut off, `times` over.
  void damage(const std::string& whole, int times, unsigned seed) {
    std::mt19937 random(seed);
    const auto below = [&](std::size_t n) {
      return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
    };
    std::uint32_t json = 0;
    std::memcpy(&json, whole.data() + 12, 4);
    for (int i = 0; i < times; ++i) {
      std::string text = whole;
      // Header and JSON are small beside the data, and deserve half of the harm.
      const std::size_t reach =
          i % 2 == 0 ? std::min<std::size_t>(20 + json, text.size()) : text.size();
      for (std::size_t k = 1 + below(4); k > 0; --k) {
        char& at = text[below(reach)];
        at = i % 3 == 0 ? static_cast<char>('0' + below(10)) : static_cast<char>(below(256));
      }
      if (i % 7 == 0) text.resize(below(text.size()));
      const auto model = read_gltf(write("damaged.glb", text));
      if (!model) {
        EXPECT_FALSE(model.error().remedy.empty());
        continue;
      }
      for (const auto& t : model->mesh.triangles)
        for (const std::uint32_t corner : t) ASSERT_LT(corner, model->mesh.positions.size());
    }
  }
};

TEST_F(DamagedFiles, a_plain_file) {
  const auto glb = write_glb(revolve(section_of(resampled(shapes::bowl(), 12)), 12), "Bowl", "");
  damage(std::string(reinterpret_cast<const char*>(glb.data()), glb.size()), 500, 1);
}

TEST_F(DamagedFiles, a_file_compressed_with_meshopt) {
  const fs::path file = "../shared/vessels/polyhaven_ceramic_vase_01_meshopt.glb";
  if (!fs::exists(file)) GTEST_SKIP() << "there is no " << file;
  damage(files::test::content(file), 400, 2);
}

TEST_F(DamagedFiles, a_file_compressed_with_draco) {
  const fs::path file = "../shared/vessels/sketchfab_ewer_dmitriy_draco.glb";
  if (!fs::exists(file)) GTEST_SKIP() << "there is no " << file;
  damage(files::test::content(file), 60, 3);
}

}  // namespace
}  // namespace onggi::content::damaged_files_test
