#include "kiosk/collection/content/gltf.h"

#include <sys/stat.h>

#include <chrono>
#include <cmath>
#include <cstring>

#include "kiosk/collection/content/glb.h"
#include "tests/engine/profile/shapes.h"
#include "tests/kiosk/collection/content/temporary.h"

namespace onggi::content::gltf_test {
namespace {

const std::filesystem::path kVessels = "../shared/vessels";
const std::filesystem::path kMalformed = "../shared/malformed/gltf";

/// A glTF of one triangle; `buffer` is "uri" of 36 bytes of positions, `more` further members.
std::string triangle(const std::string& buffer, const std::string& more = "",
                     const std::string& accessor = "\"count\":3") {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
         R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
         R"("accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3",)" +
         accessor + R"(}],"bufferViews":[{"buffer":0,"byteLength":36}],)" +
         R"("buffers":[{"byteLength":36,"uri":")" + buffer + "\"}]" + more + "}";
}

/// (0,0,0), (1,0,0), (0,1,0)
std::string positions() {
  std::string out(36, '\0');
  const float one = 1.0f;
  std::memcpy(out.data() + 12, &one, 4);
  std::memcpy(out.data() + 28, &one, 4);
  return out;
}

class GltfTest : public Temporary {
 protected:
  std::string fault(const std::filesystem::path& file) {
    const auto read = read_gltf(file);
    return read ? "" : to_text(read.error());
  }
  void expect_fault(const std::string& text, const std::string& words) {
    const std::string said = fault(write("pack/a.gltf", text));
    EXPECT_NE(said.find(words), std::string::npos) << "said: " << said;
    EXPECT_NE(said.find("a.gltf"), std::string::npos) << "said: " << said;
  }
};

TEST_F(GltfTest, what_is_written_is_read_again_to_the_bit) {
  const TriangleMesh mesh = revolve(section_of(shapes::jar()), 40);
  const auto glb = write_glb(mesh, "Jar", "CC0, of nobody");
  const auto file =
      write("jar.glb", std::string(reinterpret_cast<const char*>(glb.data()), glb.size()));
  const auto model = read_gltf(file);
  ASSERT_TRUE(model) << to_text(model.error());
  EXPECT_EQ(model->mesh.positions, mesh.positions);
  EXPECT_EQ(model->mesh.triangles, mesh.triangles);
  EXPECT_EQ(model->credit.copyright, "CC0, of nobody");
  EXPECT_EQ(model->credit.licence, "CC0-1.0");
  EXPECT_TRUE(model->colored);
  EXPECT_NEAR(model->base_color[0], 0.342f, 1e-6);
}

TEST_F(GltfTest, a_buffer_beside_the_file_is_found_and_one_elsewhere_is_refused) {
  write("pack/a.bin", positions());
  write("secret.bin", positions());
  EXPECT_EQ(fault(write("pack/a.gltf", triangle("a.bin"))), "");
  EXPECT_EQ(fault(write("pack/a.gltf", triangle("./a%2ebin"))), "");
  expect_fault(triangle("../secret.bin"), "outside its own folder");
  expect_fault(triangle("%2e%2e/secret.bin"), "outside its own folder");
  expect_fault(triangle((folder_ / "secret.bin").string()), "outside its own folder");
  expect_fault(triangle("http://museum/a.bin"), "outside its own folder");
  expect_fault(triangle("none.bin"), "missing");
  expect_fault(triangle("."), "outside its own folder");
  std::filesystem::create_symlink(folder_ / "secret.bin", folder_ / "pack/link.bin");
  expect_fault(triangle("link.bin"), "symbolic link");
  std::filesystem::create_directory_symlink(folder_, folder_ / "pack/up");
  expect_fault(triangle("up/secret.bin"), "symbolic link");
  ASSERT_EQ(::mkfifo((folder_ / "pack/pipe.bin").c_str(), 0600), 0);
  expect_fault(triangle("pipe.bin"), "not a regular file");
  std::filesystem::create_directory(folder_ / "pack/sub");
  expect_fault(triangle("sub"), "not a regular file");
  ASSERT_EQ(::mkfifo((folder_ / "pipe.glb").c_str(), 0600), 0);
  EXPECT_NE(fault(folder_ / "pipe.glb").find("not a regular file"), std::string::npos);
  EXPECT_NE(fault(folder_).find("not a regular file"), std::string::npos);
}

TEST_F(GltfTest, json_nested_deep_or_claims_without_data_are_refused) {
  write("pack/a.bin", positions());
  const std::string deep = std::string(50000, '[') + std::string(50000, ']');
  expect_fault(triangle("a.bin", ",\"extras\":" + deep), "nested");
  expect_fault(triangle("a.bin", "", "\"count\":1000000"), "do not fit");
  expect_fault(triangle("a.bin", "", "\"count\":18446744073709551615"), "claims");
  expect_fault(triangle("a.bin", "", "\"count\":3,\"byteOffset\":18446744073709551612"),
               "do not fit");
  expect_fault(triangle("a.bin", "",
                        "\"count\":3,\"sparse\":{\"count\":1,\"indices\":{\"bufferView\":7,"
                        "\"componentType\":5121},\"values\":{\"bufferView\":8}}"),
               "no such buffer view");
  std::string nan = positions();
  nan[3] = nan[2] = '\x7f', nan[2] = '\xc0';
  write("pack/nan.bin", nan);
  expect_fault(triangle("nan.bin"), "not a finite number");
  write("pack/short.bin", positions().substr(0, 20));
  expect_fault(triangle("short.bin"), "should have 36 bytes, but it has 20");
}

TEST_F(GltfTest, a_required_extension_that_is_not_known_is_refused_by_name) {
  write("pack/a.bin", positions());
  expect_fault(triangle("a.bin", ",\"extensionsRequired\":[\"ACME_clay\"]"), "ACME_clay");
  EXPECT_EQ(fault(write("pack/a.gltf",
                        triangle("a.bin", ",\"extensionsRequired\":[\"EXT_texture_webp\"]"))),
            "");
}

TEST_F(GltfTest, nodes_move_and_mirror_and_never_loop) {
  write("pack/a.bin", positions());
  const auto with_nodes = [&](const std::string& nodes) {
    std::string text = triangle("a.bin");
    text.replace(text.find(R"([{"mesh":0}])"), 12, nodes);
    return read_gltf(write("pack/a.gltf", text));
  };
  const auto moved =
      with_nodes(R"([{"children":[1],"translation":[10,0,0]},{"mesh":0,"scale":[2,2,-2]}])");
  ASSERT_TRUE(moved) << to_text(moved.error());
  EXPECT_FLOAT_EQ(moved->mesh.positions[1][0], 12.0f);
  // The mirror turned the triangle over; its corners and its normal agree with each other.
  const auto& t = moved->mesh.triangles[0];
  const Vec3 face = cross(shapes::at(moved->mesh, t[1]) - shapes::at(moved->mesh, t[0]),
                          shapes::at(moved->mesh, t[2]) - shapes::at(moved->mesh, t[0]));
  EXPECT_LT(face.z * 1.0, 0.0);
  EXPECT_LT(moved->mesh.normals[0][2], 0.0f);
  const auto turned = with_nodes(R"([{"mesh":0,"rotation":[0,0,0.70710678,0.70710678]}])");
  ASSERT_TRUE(turned);
  EXPECT_NEAR(turned->mesh.positions[1][1], 1.0f, 1e-6);
  EXPECT_FALSE(with_nodes(R"([{"children":[1]},{"mesh":0,"children":[0]}])"));
  EXPECT_FALSE(with_nodes(R"([{"children":[9]}])"));
  EXPECT_FALSE(with_nodes(R"([{"mesh":4}])"));
}

/// `bytes` in base64, RFC 4648.
std::string base64(const std::string& bytes) {
  const char* const letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (int k = 3; k >= 0; --k) out += letters[three >> (6 * k) & 63u];
  }
  return out;
}

TEST_F(GltfTest, data_within_the_file_is_decoded_in_its_place_and_refused_by_its_length) {
  const std::string head = "data:application/octet-stream;base64,";
  const auto same = read_gltf(write("pack/a.gltf", triangle(head + base64(positions()))));
  ASSERT_TRUE(same) << to_text(same.error());
  EXPECT_EQ(same->mesh.positions[1][0], 1.0f);
  EXPECT_EQ(same->mesh.positions[2][1], 1.0f);
  expect_fault(triangle(head + base64(positions().substr(0, 30))), "should have 36 bytes");
  expect_fault(triangle(head + "AAAA*" + base64(positions())), "cannot be decoded");
  expect_fault(triangle("data:,abc"), "cannot be decoded");
  expect_fault(triangle("data:#7"), "cannot be decoded");
  std::string claims = triangle(head + base64(positions()));
  claims.replace(claims.find("\"byteLength\":36,\"uri\""), 15, "\"byteLength\":99999999999");
  expect_fault(claims, "MiB together, but the limit is 512 MiB.");

  // A long one is no JSON: it counts with the file, and what of it no buffer wants is not decoded.
  settings::ReaderLimits tight;
  tight.json_mb = 1;
  const std::string longer = head + base64(positions()) + std::string(3 << 20, 'A');
  const auto file = write("pack/a.gltf", triangle(longer));
  const auto read = read_gltf(file, tight);
  ASSERT_TRUE(read) << to_text(read.error());
  EXPECT_EQ(read->mesh.positions, same->mesh.positions);
  const auto words =
      write("pack/b.gltf", triangle("a.bin", ",\"x\":\"" + std::string(2 << 20, 'A') + "\""));
  const auto refused = read_gltf(words, tight);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().what.find("the limit is 1"), std::string::npos);
}

TEST_F(GltfTest, what_a_parser_reads_past_is_named) {
  write("pack/a.bin", positions());
  const auto with = [&](const std::string& what, const std::string& by) {
    std::string text = triangle("a.bin");
    text.replace(text.find(what), what.size(), by);
    return text;
  };
  const std::string node = R"("nodes":[{"mesh":0}])";
  expect_fault(with(node, R"("nodes":[{"mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0]}])"),
               "node 0: its matrix has 15 numbers, but it needs 16");
  expect_fault(with(node, R"("nodes":[{"mesh":0,"translation":[1,2]}])"), "needs 3");
  expect_fault(with(node, R"("nodes":[{"mesh":0,"rotation":[0,0,"0",1]}])"), "has 3 numbers");
  expect_fault(with(R"("count":3)", R"("count":3,"sparse":{"count":-1,"indices":{"bufferView":0,)"
                                    R"("componentType":5125},"values":{"bufferView":0}})"),
               "accessor 0: its sparse part has -1 elements");

  const auto warning = [&](const std::string& text) {
    const auto model = read_gltf(write("pack/a.gltf", text));
    EXPECT_TRUE(model) << to_text(model.error());
    return !model || model->warnings.size() != 1 ? "" : model->warnings[0];
  };
  EXPECT_NE(warning(with(R"("scene":0)", R"("scene":55)")).find("scene 55 but has only 1"),
            std::string::npos);
  EXPECT_NE(warning(with(R"("scene":0)", R"("scene":-1)")).find("scene -1"), std::string::npos);
  const std::string primitive = R"({"attributes":{"POSITION":0}}])";
  const std::string morphed = R"({"attributes":{"POSITION":0},"targets":[{"POSITION":0}]}])";
  EXPECT_NE(warning(with(primitive, morphed + R"(,"weights":[0.5])")).find("Morph weights"),
            std::string::npos);
  EXPECT_EQ(warning(with(primitive, morphed + R"(,"weights":[0])")), "");
  EXPECT_EQ(warning(triangle("a.bin")), "");
}

TEST_F(GltfTest, what_is_wrong_with_all_accessors_is_said_once) {
  write("pack/a.bin", positions());
  for (const std::string bounds : {R"("min":[5,5,5],"max":[6,6,6])", R"("min":[0],"max":[1])"}) {
    const std::string accessor =
        R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":3,)" + bounds + "}";
    std::string accessors = accessor, primitives = R"({"attributes":{"POSITION":0}})";
    for (int i = 1; i < 200; ++i) {
      accessors += "," + accessor;
      primitives += R"(,{"attributes":{"POSITION":)" + std::to_string(i) + "}}";
    }
    std::string text = triangle("a.bin", "", bounds + R"(,"count":3)");
    text.replace(text.find(R"({"attributes":{"POSITION":0}})"), 29, primitives);
    const auto from = text.find(R"("accessors":[)") + 13, to = text.find("],\"bufferViews\"");
    text.replace(from, to - from, accessors);
    const auto model = read_gltf(write("pack/a.gltf", text));
    ASSERT_TRUE(model) << to_text(model.error());
    ASSERT_EQ(model->warnings.size(), 1u);
    EXPECT_NE(model->warnings[0].find("accessor 0 and 199 more"), std::string::npos)
        << model->warnings[0];
  }
}

TEST_F(GltfTest, the_same_vase_quantised_and_compressed_has_the_same_shape) {
  const auto quantised = kVessels / "polyhaven_ceramic_vase_01_quant.glb";
  const auto compressed = kVessels / "polyhaven_ceramic_vase_01_meshopt.glb";
  if (!std::filesystem::exists(compressed)) GTEST_SKIP() << "there is no " << compressed;
  const auto a = read_gltf(quantised), b = read_gltf(compressed);
  ASSERT_TRUE(a) << to_text(a.error());
  ASSERT_TRUE(b) << to_text(b.error());
  EXPECT_EQ(a->mesh.triangles.size(), 9784u);
  EXPECT_EQ(b->mesh.triangles.size(), 9784u);
  EXPECT_NEAR(shapes::volume(a->mesh), shapes::volume(b->mesh), 0.002 * shapes::volume(a->mesh));
  EXPECT_GT(shapes::volume(a->mesh), 0.0);
}

TEST_F(GltfTest, every_real_vessel_is_read_or_refused_for_a_reason) {
  if (!std::filesystem::exists(kVessels)) GTEST_SKIP() << "there is no " << kVessels;
  int read = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kVessels)) {
    const auto ending = entry.path().extension();
    if (ending != ".glb" && ending != ".gltf") continue;
    const auto model = read_gltf(entry.path());
    EXPECT_TRUE(model) << to_text(model.error());
    ++read;
  }
  EXPECT_GE(read, 20);
}

TEST_F(GltfTest, no_malformed_file_crashes_or_hangs) {
  if (!std::filesystem::exists(kMalformed)) GTEST_SKIP() << "there is no " << kMalformed;
  int models = 0, problems = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kMalformed)) {
    if (!entry.is_regular_file()) continue;
    const auto begin = std::chrono::steady_clock::now();
    const auto model = read_gltf(entry.path());
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5)) << entry.path();
    if (model) {
      ++models;
      for (const auto& t : model->mesh.triangles)
        for (const std::uint32_t i : t) ASSERT_LT(i, model->mesh.positions.size()) << entry.path();
    } else {
      ++problems;
      EXPECT_FALSE(model.error().what.empty());
      EXPECT_FALSE(model.error().remedy.empty());
    }
  }
  EXPECT_GT(problems, 300);
  RecordProperty("models", models);
  RecordProperty("problems", problems);
}

}  // namespace
}  // namespace onggi::content::gltf_test
