#include "tests/kiosk/picture/render/studio_fixture.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <vector>

namespace onggi::render::testing {
namespace {

// Two drivers round apart: hardly a pixel, and none of them over an area that is seen
// (kiosk/docs/render.md).
constexpr double kMeanApart = 0.002;  // of 255
constexpr int kSeenApart = 8;         // of 255
constexpr double kShareSeenApart = 2e-5;

// An X server of our own on a number it finds free itself; ends with this process.
class OwnDisplay {
 public:
  OwnDisplay() {
    if (getenv("DISPLAY") != nullptr) return;
    int ends[2];
    if (pipe(ends) != 0) return;
    server_ = fork();
    if (server_ == 0) {
      prctl(PR_SET_PDEATHSIG, SIGTERM);
      close(ends[0]);
      const int quiet = open("/dev/null", O_WRONLY);
      dup2(quiet, 1);
      dup2(quiet, 2);
      const std::string fd = std::to_string(ends[1]);
      execlp("Xvfb", "Xvfb", "-displayfd", fd.c_str(), "-screen", "0", "1920x1920x24", "-nolisten",
             "tcp", "-noreset", static_cast<char*>(nullptr));
      _exit(127);
    }
    close(ends[1]);
    // Xvfb writes its number and the line's end apart; a pipe closed between the two ends it.
    std::string number;
    char digit = 0;
    while (read(ends[0], &digit, 1) == 1 && digit != '\n') number += digit;
    close(ends[0]);
    if (!number.empty()) setenv("DISPLAY", (":" + number).c_str(), 1);
  }
  ~OwnDisplay() {
    if (server_ <= 0) return;
    kill(server_, SIGTERM);
    // One that is told just as it falls asleep sleeps on, for ten minutes.
    for (int n = 0; n < 200; ++n, usleep(10'000))
      if (waitpid(server_, nullptr, WNOHANG) == server_) return;
    kill(server_, SIGKILL);
    waitpid(server_, nullptr, 0);
  }

 private:
  pid_t server_ = -1;
};

/// Opened by the first test that draws: a server and its OpenGL take a second, and most do not.
class World : public ::testing::Environment {
 public:
  void open() {
    if (display_) return;
    display_ = std::make_unique<OwnDisplay>();
    if (getenv("DISPLAY") == nullptr) return;
    const WindowOptions options{
        .width = 1280, .height = 720, .visible = false, .title = "Onggi render tests"};
    auto made = Renderer::create(options);
    if (!made) {
      ADD_FAILURE() << to_text(made.error());
      return;
    }
    renderer = std::move(*made);
    renderer->set_full_quality(true);
    // Said by embedded_test.py, so that it cannot compare one OpenGL with itself.
    if (getenv("ONGGI_EMBEDDED") != nullptr) {
      EXPECT_TRUE(renderer->status().embedded);
    }
  }
  void TearDown() override {
    renderer.reset();
    display_.reset();
  }
  std::unique_ptr<Renderer> renderer;

 private:
  std::unique_ptr<OwnDisplay> display_;
};

World* const world = static_cast<World*>(::testing::AddGlobalTestEnvironment(new World));

}  // namespace

void StudioTest::SetUp() {
  world->open();
  if (world->renderer == nullptr) GTEST_SKIP() << "no display, and Xvfb is not installed";
}

Renderer& StudioTest::renderer() { return *world->renderer; }

ClayDef grid_of(int rows, int sectors, double height, double floor) {
  ClayDef def;
  def.rows = rows;
  def.sectors = sectors;
  def.height = height;
  def.floor_thickness = floor;
  return def;
}

ClayView thrown_clay(const ClayDef& grid, double (*outer)(double), double wall, double grooves) {
  ClayView clay;
  clay.lay(grid);
  const auto sectors = static_cast<std::size_t>(grid.sectors);
  std::vector<float> outside(sectors), inside(sectors);
  for (int j = 0; j < grid.rows; ++j) {
    const double h = clay.row_height(j), t = h / grid.height;
    for (std::size_t i = 0; i < sectors; ++i) {
      // A finger that rises 4 mm a turn leaves a spiral.
      const double turn = (static_cast<double>(i) + 0.5) / grid.sectors;
      const double spiral = std::sin(6.283185307 * (h / 0.0055 - turn));
      outside[i] = static_cast<float>(outer(t) + grooves * spiral * (0.7 + 0.3 * std::sin(31 * t)));
      inside[i] = j < clay.floor_rows()
                      ? 0.0f
                      : static_cast<float>(outer(t) - wall - 0.5 * grooves * spiral);
    }
    clay.shape(j, outside, inside);
  }
  return clay;
}

void tear(ClayView& clay, int from, int to, bool torn) {
  for (int j = from; j < to; ++j)
    clay.place(j,
               {clay.row_height(j), clay.rim_height(), clay.floor_top(), clay.floor_rows(), torn});
}

namespace {

void keep(const std::vector<std::uint8_t>& rgb, const view::Image& image, const std::string& path) {
  std::ofstream file(path, std::ios::binary);
  file << "P6\n" << image.width << " " << image.height << "\n255\n";
  file.write(reinterpret_cast<const char*>(rgb.data()), static_cast<std::streamsize>(rgb.size()));
}

/// As keep() wrote it; empty where it is not there or of another size.
std::vector<std::uint8_t> kept(const view::Image& image, const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string head;
  int width = 0, height = 0, most = 0;
  file >> head >> width >> height >> most;
  file.get();
  if (!file || width != image.width || height != image.height) return {};
  return {std::istreambuf_iterator<char>(file), {}};
}

void expect_alike(const std::vector<std::uint8_t>& rgb, const std::vector<std::uint8_t>& other,
                  const std::string& name) {
  ASSERT_EQ(rgb.size(), other.size()) << name;
  double sum = 0.0, seen = 0.0;
  int most = 0;
  for (std::size_t i = 0; i < rgb.size(); ++i) {
    const int apart = std::abs(rgb[i] - other[i]);
    sum += apart;
    seen += apart > kSeenApart;
    most = std::max(most, apart);
  }
  const auto count = static_cast<double>(rgb.size());
  std::printf("%s: apart by %.4f of 255 on the mean, %d at most, more than %d in %.4f %%\n",
              name.c_str(), sum / count, most, kSeenApart, 100.0 * seen / count);
  EXPECT_LE(sum / count, kMeanApart) << name;
  EXPECT_LE(seen / count, kShareSeenApart) << name;
}

}  // namespace

void keep_for_looking(const view::Image& image, const std::string& name) {
  const char* const folder = getenv("ONGGI_GALLERY");
  const char* const other = getenv("ONGGI_ALIKE");
  if (folder == nullptr && other == nullptr) return;
  std::vector<std::uint8_t> rgb;
  for (std::size_t i = 0; i + 3 < image.rgba.size(); i += 4)
    rgb.insert(rgb.end(), {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]});
  const std::string file = "/" + name + ".ppm";
  if (folder != nullptr) keep(rgb, image, folder + file);
  if (other != nullptr) expect_alike(rgb, kept(image, other + file), name);
}

view::Frame frame_with_pot(int width, int height, double pot_height, double pot_radius) {
  view::Frame frame;
  frame.width = width;
  frame.height = height;
  view::PotView pot;
  const auto w = static_cast<float>(width), h = static_cast<float>(height);
  pot.camera = view::frame_pot(width, height, {0.25f * w, 0.12f * h, 0.5f * w, 0.70f * h},
                               pot_height, pot_radius);
  frame.pot = pot;
  return frame;
}

Pixel pixel_at(const view::Image& image, int x, int y) {
  const std::size_t i = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                             static_cast<std::size_t>(x));
  return {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]};
}

}  // namespace onggi::render::testing
