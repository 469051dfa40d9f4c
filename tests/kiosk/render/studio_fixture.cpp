#include "tests/kiosk/render/studio_fixture.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>

namespace onggi::render::testing {
namespace {

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

class World : public ::testing::Environment {
 public:
  void SetUp() override {
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

void keep_for_looking(const view::Image& image, const std::string& name) {
  const char* folder = getenv("ONGGI_GALLERY");
  if (folder == nullptr) return;
  std::ofstream file(std::string(folder) + "/" + name + ".ppm", std::ios::binary);
  file << "P6\n" << image.width << " " << image.height << "\n255\n";
  for (std::size_t i = 0; i + 3 < image.rgba.size(); i += 4) {
    file.write(reinterpret_cast<const char*>(&image.rgba[i]), 3);
  }
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
