#include "tests/pages/spectrogram.h"

#include <cairo.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace onggi::pages {
namespace {

struct Reader {
  const std::vector<std::byte>* bytes;
  std::size_t at = 0;
};
cairo_status_t read_some(void* from, unsigned char* into, unsigned size) {
  auto& reader = *static_cast<Reader*>(from);
  if (reader.at + size > reader.bytes->size()) return CAIRO_STATUS_READ_ERROR;
  std::memcpy(into, reader.bytes->data() + reader.at, size);
  reader.at += size;
  return CAIRO_STATUS_SUCCESS;
}

/// How much light column x sends at y, 0..765.
class Picture {
 public:
  explicit Picture(const std::vector<std::byte>& png) {
    Reader reader{&png};
    surface_ = cairo_image_surface_create_from_png_stream(read_some, &reader);
  }
  ~Picture() { cairo_surface_destroy(surface_); }
  Picture(const Picture&) = delete;
  Picture& operator=(const Picture&) = delete;
  int light(int x, int y) const {
    const unsigned char* p = cairo_image_surface_get_data(surface_) +
                             y * cairo_image_surface_get_stride(surface_) + 4 * x;
    return p[0] + p[1] + p[2];
  }
  int height() const { return cairo_image_surface_get_height(surface_); }

 private:
  cairo_surface_t* surface_;
};

TEST(Spectrogram, ATonesLineLiesAtItsPitchAndWhileItSounds) {
  std::vector<float> sound(2 * 48000, 0.0f);
  for (std::size_t n = 0; n < 48000; ++n)
    sound[n] = 0.1f * static_cast<float>(
                          std::sin(2.0 * 3.14159265 * 1000.0 * static_cast<double>(n) / 48000.0));
  Spectrogram what;
  what.samples = sound;
  what.width = 1000;
  what.height = 600;
  const Picture picture(draw_spectrogram(what, "x.png"));
  ASSERT_EQ(picture.height(), 600);
  // The panel lies 150 from the left and 50 from the right, 210 from above and 110 from below.
  const auto darkest = [&](int x) {
    int at = 215;
    for (int y = 215; y < 485; ++y)
      if (picture.light(x, y) < picture.light(x, at)) at = y;
    return at;
  };
  const double up = std::log(1000.0 / 30.0) / std::log(12000.0 / 30.0);
  EXPECT_NEAR(darkest(150 + 200), 490 - up * 280, 4);
  EXPECT_LT(picture.light(350, darkest(350)), 250);
  const int rest = 150 + 653;  // between two lines of the grid
  EXPECT_GT(picture.light(rest, darkest(rest)), 600) << "nothing sounds";
}

}  // namespace
}  // namespace onggi::pages
