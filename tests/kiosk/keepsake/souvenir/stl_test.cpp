#include "kiosk/keepsake/souvenir/stl.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <numbers>
#include <regex>
#include <span>
#include <string>

#include "engine/clay/clay_mesh.h"
#include "engine/scene/lump.h"
#include "engine/scene/scene.h"
#include "engine/script/script.h"
#include "kiosk/collection/content/glb.h"
#include "kiosk/keepsake/souvenir/visit_folder.h"
#include "kiosk/wheel/loop/stepped_wheel.h"
#include "tests/kiosk/ground/files/disk.h"
#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::souvenir::stl_test {
namespace {

struct Face {
  std::array<float, 3> normal;
  std::array<std::array<float, 3>, 3> corner;
};

/// A reader of binary STL, independent of the writer.
std::vector<Face> read_stl(const std::vector<std::byte>& bytes) {
  std::uint32_t count = 0;
  if (bytes.size() < 84) return {};
  std::memcpy(&count, bytes.data() + 80, 4);
  EXPECT_EQ(bytes.size(), 84 + 50 * static_cast<std::size_t>(count));
  std::vector<Face> faces(count);
  for (std::size_t i = 0; i < count; ++i) std::memcpy(&faces[i], bytes.data() + 84 + 50 * i, 48);
  return faces;
}

/// Signed volume by the divergence theorem: positive where faces turn outwards.
double volume(const std::vector<Face>& faces) {
  double six = 0;
  for (const Face& f : faces) {
    const auto& [a, b, c] = f.corner;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      six += static_cast<double>(a[k]) * (static_cast<double>(b[i]) * static_cast<double>(c[j]) -
                                          static_cast<double>(b[j]) * static_cast<double>(c[i]));
    }
  }
  return six / 6;
}

/// A mesh without triangles that have no width, as kept pots are.
TriangleMesh with_area(TriangleMesh mesh) {
  std::erase_if(mesh.triangles, [&](const auto& t) {
    const auto& p = mesh.positions;
    return p[t[0]] == p[t[1]] || p[t[1]] == p[t[2]] || p[t[2]] == p[t[0]];
  });
  return mesh;
}

/// A kept pot's model on the disk, in parts of two materials.
struct Kept {
  explicit Kept(const TriangleMesh& mesh, const std::string& title = "cup",
                std::size_t index_bytes = 2) {
    std::vector<content::GlbPart> parts{{0, {}}};
    if (mesh.triangles.size() > 9) parts.push_back({9, {}});
    put(content::write_glb(mesh, title, "", parts, {}, index_bytes));
  }
  explicit Kept(std::span<const std::byte> glb) { put(glb); }
  void put(std::span<const std::byte> glb) {
    std::ofstream(scratch.path() / kPotGlb, std::ios::binary)
        .write(reinterpret_cast<const char*>(glb.data()), static_cast<std::streamsize>(glb.size()));
    file = files::Descriptor(::open((scratch.path() / kPotGlb).c_str(), O_RDONLY));
  }
  /// All of its STL; empty if it has none.
  std::vector<std::byte> stl() const {
    const auto stl = StlOfPot::of(file);
    std::vector<std::byte> bytes(stl ? stl->size() : 0);
    if (stl && !stl->read(file, 0, bytes)) bytes.clear();
    return bytes;
  }
  files::test::ScratchFolder scratch;
  files::Descriptor file;
};

TriangleMesh turned(const Section& section, int sectors) {
  return with_area(revolve(section, sectors));
}

Section cup(double outer, double inner, double height, double floor) {
  return {{{0, 0}, {outer, 0}, {outer, height}, {inner, height}, {inner, floor}, {0, floor}}};
}

TEST(stl, a_cup_holds_the_clay_that_its_drawing_says) {
  const int sectors = 256;
  const auto faces = read_stl(Kept(turned(cup(0.05, 0.045, 0.12, 0.006), sectors)).stl());
  // A turned polygon's cross-section is that of a regular polygon, not of a circle.
  const double n = sectors, polygon = n / 2 * std::sin(2 * std::numbers::pi / n);
  const double mm3 = polygon * (50.0 * 50.0 * 120.0 - 45.0 * 45.0 * 114.0);
  EXPECT_NEAR(volume(faces) / mm3, 1.0, 1e-5);
}

TEST(stl, the_pot_stands_upright_in_millimetres) {
  const auto faces = read_stl(Kept(turned(cup(0.05, 0.045, 0.12, 0.006), 64)).stl());
  std::array<float, 3> low{1e9f, 1e9f, 1e9f}, high{-1e9f, -1e9f, -1e9f};
  for (const Face& f : faces) {
    for (const auto& p : f.corner) {
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], p[k]);
        high[k] = std::max(high[k], p[k]);
      }
    }
  }
  EXPECT_NEAR(low[2], 0, 1e-3);
  EXPECT_NEAR(high[2], 120, 1e-3);
  EXPECT_NEAR(high[0] - low[0], 100, 0.5);
}

TEST(stl, the_surface_is_closed_and_normals_agree_with_the_corners) {
  const auto faces = read_stl(Kept(turned(cup(0.05, 0.045, 0.12, 0.006), 48)).stl());
  ASSERT_FALSE(faces.empty());
  std::map<std::pair<std::array<float, 3>, std::array<float, 3>>, int> edges;
  for (const Face& f : faces) {
    for (std::size_t k = 0; k < 3; ++k) ++edges[{f.corner[k], f.corner[(k + 1) % 3]}];
    double length = 0, along = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      const auto& [a, b, c] = f.corner;
      const double turned = static_cast<double>(b[i] - a[i]) * static_cast<double>(c[j] - a[j]) -
                            static_cast<double>(b[j] - a[j]) * static_cast<double>(c[i] - a[i]);
      length += turned * turned;
      along += turned * static_cast<double>(f.normal[k]);
    }
    EXPECT_NEAR(along / std::sqrt(length), 1.0, 1e-4);
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1u) << "an edge without a neighbour";
  }
}

TEST(stl, the_same_pot_gives_the_same_bytes_with_short_and_long_indices_and_no_minus_zero) {
  const auto mesh = turned(cup(0.05, 0.045, 0.12, 0.006), 32);
  const auto bytes = Kept(mesh, "달항아리").stl();
  EXPECT_EQ(bytes, Kept(mesh, "달항아리", 4).stl());
  ASSERT_EQ(read_stl(bytes).size(), mesh.triangles.size());
  for (const Face& f : read_stl(bytes)) {
    for (const auto& p : f.corner) {
      for (const float v : p) EXPECT_FALSE(v == 0.0f && std::signbit(v));
    }
  }
}

// A download goes on anywhere.
TEST(stl, any_span_of_it_is_what_the_whole_has_there) {
  const Kept kept(turned(cup(0.05, 0.045, 0.12, 0.006), 24));
  const auto whole = kept.stl();
  const auto stl = StlOfPot::of(kept.file);
  ASSERT_TRUE(stl);
  EXPECT_TRUE(rc::check([&](std::uint16_t a, std::uint16_t b) {
    const std::size_t from = a % whole.size(), size = b % (whole.size() - from + 1);
    std::vector<std::byte> span(size);
    RC_ASSERT(stl->read(kept.file, from, span));
    RC_ASSERT(std::ranges::equal(span, std::span(whole).subspan(from, size)));
  }));
  std::vector<std::byte> beyond(2);
  EXPECT_FALSE(stl->read(kept.file, whole.size() - 1, beyond));
}

TEST(stl, the_header_never_looks_like_the_text_form_and_is_always_80_bytes) {
  EXPECT_TRUE(rc::check([](const std::string& title) {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    const auto bytes = Kept(mesh, title).stl();
    RC_ASSERT(bytes.size() == 134u);
    RC_ASSERT(std::memcmp(bytes.data(), "solid", 5) != 0);
  }));
}

// Whoever may write a keepsake's folder must not be able to harm the server.
TEST(stl, a_damaged_model_gives_none_or_one_that_ends_and_never_reads_beyond_it) {
  const auto good =
      content::write_glb(turned(cup(0.05, 0.045, 0.12, 0.006), 12), "cup", "", {{0, {}}}, {}, 2);
  EXPECT_EQ(Kept(std::span(good)).stl().size(),
            84 + 50 * turned(cup(0.05, 0.045, 0.12, 0.006), 12).triangles.size());
  EXPECT_TRUE(Kept(std::span(good).first(good.size() - 40)).stl().empty()) << "cut short";
  EXPECT_TRUE(Kept(std::span(good).first(30)).stl().empty());
  EXPECT_TRUE(Kept(std::span(good).first(0)).stl().empty());
  EXPECT_TRUE(rc::check([&](std::uint16_t at, std::uint8_t value) {
    auto other = good;
    other[at % other.size()] = std::byte{value};
    Kept(std::span(other)).stl();
  }));
  auto index = good;
  // The last index, before its padding.
  for (std::size_t n = index.size() - 4; n < index.size(); ++n) index[n] = std::byte{0xFE};
  EXPECT_TRUE(Kept(std::span(index)).stl().empty()) << "a corner that is not there";
}

/// What ADMesh (Debian: admesh), which shares no line with us, says of a file.
std::map<std::string, double> admesh(const std::filesystem::path& file) {
  const std::string command = "admesh '" + file.string() + "' 2>/dev/null";
  std::map<std::string, double> said;
  FILE* out = popen(command.c_str(), "r");
  char line[256];
  while (out != nullptr && std::fgets(line, sizeof line, out) != nullptr) {
    static const std::regex kFigure("([A-Z][A-Za-z 0-9]*[A-Za-z]) *[:=] *(-?[0-9.]+)");
    const std::string text(line);
    for (auto i = std::sregex_iterator(text.begin(), text.end(), kFigure);
         i != std::sregex_iterator(); ++i)
      said[(*i)[1]] = std::stod((*i)[2]);
  }
  if (out != nullptr) pclose(out);
  return said;
}

TEST(stl, a_thrown_pot_is_one_closed_body_for_another_reader_too_in_mm_and_of_the_clays_volume) {
  if (std::system("command -v admesh >/dev/null") != 0) GTEST_SKIP() << "admesh is not installed";
  SceneDef def;
  def.clay.rows = 120;
  def.clay.sectors = 96;
  Profile target;
  for (int n = 0; n <= 40; ++n)
    target.points.push_back({0.2 * n / 40, 0.055 + 0.02 * std::sin(3.14159 * n / 40),
                             n < 3 ? 0.0 : 0.048 + 0.02 * std::sin(3.14159 * n / 40)});
  def.clay = lump_for(target, def);
  auto scene = Scene::create(def);
  ASSERT_TRUE(scene);
  loop::SteppedWheel wheel_host;
  wheel_host.start(std::make_unique<Scene>(std::move(*scene)));
  wheel_host.play(std::move(*make_script("follow", {def, &target, 1, 2.0})));
  for (int n = 0; n < 600; ++n) wheel_host.advance(20), wheel_host.collect();
  ASSERT_TRUE(wheel_host.refresh_every_row());
  double litres = 0;
  ASSERT_TRUE(wheel_host.with_scene([&](Scene& at) { litres = 1000 * at.clay().volume(); }));
  const ClayView& clay = wheel_host.view().clay;
  ASSERT_GT(clay.mean_outer(clay.rows() / 2), 0.05) << "it was thrown";

  const auto bytes = Kept(mesh_of(clay), "thrown").stl();
  const files::test::ScratchFolder folder;
  const auto file = folder / "thrown.stl";
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
  auto said = admesh(file);
  ASSERT_FALSE(said.empty());
  EXPECT_EQ(said.at("Number of parts"), 1);
  for (const char* mended :
       {"Total disconnected facets", "Degenerate facets", "Edges fixed", "Facets removed",
        "Facets added", "Facets reversed", "Backwards edges", "Normals fixed"}) {
    ASSERT_TRUE(said.count(mended)) << mended;
    EXPECT_EQ(said.at(mended), 0) << mended;
  }
  EXPECT_NEAR(said.at("Volume") / (1e6 * litres), 1.0, 0.002);
  EXPECT_NEAR(said.at("Max Z"), 1000 * clay.rim_height(), 0.5);
  EXPECT_EQ(said.at("Min Z"), 0);
}

}  // namespace
}  // namespace onggi::souvenir::stl_test
