#include "tests/pages/spectrogram.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "kiosk/ground/files/output_kind.h"
#include "kiosk/lab/plots/chart_pen.h"
#include "kiosk/picture/view/palette.h"

namespace onggi::pages {
namespace {

constexpr double kLowest = 30.0, kHighest = 12000.0;   // Hz
constexpr double kFaintest = -90.0, kLoudest = -20.0;  // dB of full scale
constexpr std::size_t kWindow = 2048;                  // samples

/// The share of a sine of `hz` in `window`, 1 for a full-range sine. Goertzel's filter: two
/// multiplications a sample, for pitches at any spacing.
double share_of(const std::vector<double>& window, double hz, double rate) {
  const double w = plots::kFullCircle * hz / rate, c = 2.0 * std::cos(w);
  double s0 = 0.0, s1 = 0.0, s2 = 0.0;
  for (const double x : window) {
    s0 = x + c * s1 - s2;
    s2 = s1;
    s1 = s0;
  }
  const double power = s1 * s1 + s2 * s2 - c * s1 * s2;
  // A Hann window passes one half.
  return 4.0 * std::sqrt(std::max(power, 0.0)) / static_cast<double>(window.size());
}

class SpectrogramPen : private plots::ChartPen {
 public:
  std::vector<std::byte> draw(const Spectrogram& sound, bool vector) {
    begin(sound.width, sound.height, vector);
    const double seconds = std::max(static_cast<double>(sound.samples.size()) / sound.rate, 1e-3);
    drawing::PlotAxis time;
    time.low = 0.0;
    time.high = seconds;
    const plots::ChartPanel panel{150.0,
                                  sound.width - 50.0,
                                  210.0,
                                  sound.height - 110.0,
                                  drawing::PlotScale(time, 0.0, seconds, 16),
                                  plots::decades(kLowest, kHighest)};
    words(sound.title, 40, 30, {.px = 40, .color = view::kInk, .serif = true});
    words(sound.subtitle, 40, 92,
          {.px = 22, .color = view::kFaintInk, .width = sound.width - 80.0, .lines = 2});
    const view::Image image = loudness_of(sound, static_cast<int>(panel.right - panel.left),
                                          static_cast<int>(panel.bottom - panel.top));
    picture(image, panel.left, panel.top);
    axes(panel, "s", "Hz");
    for (const Spectrogram::Part& part : sound.parts) {
      const double x = panel.x(part.begin);
      ink(view::kInk, 0.5);
      line(x, panel.top - 26, x, panel.bottom, 1);
      words(part.name, x + 6, panel.top - 32, {.px = 20, .color = view::kInk});
    }
    return bytes();
  }

 private:
  static view::Image loudness_of(const Spectrogram& sound, int width, int height) {
    view::Image image{width, height,
                      std::vector<std::uint8_t>(4 * static_cast<std::size_t>(width) *
                                                static_cast<std::size_t>(height))};
    std::vector<double> window(kWindow);
    constexpr int kAcross = 2, kUp = 3;  // pixels that share a value
    for (int x = 0; x < width; x += kAcross) {
      const double middle = (x + 0.5 * kAcross) / width * static_cast<double>(sound.samples.size());
      const auto first =
          static_cast<std::ptrdiff_t>(middle) - static_cast<std::ptrdiff_t>(kWindow / 2);
      for (std::size_t n = 0; n < kWindow; ++n) {
        const std::ptrdiff_t at = first + static_cast<std::ptrdiff_t>(n);
        const bool inside = at >= 0 && at < static_cast<std::ptrdiff_t>(sound.samples.size());
        window[n] =
            inside
                ? sound.samples[static_cast<std::size_t>(at)] *
                      (0.5 - 0.5 * std::cos(plots::kFullCircle * static_cast<double>(n) / kWindow))
                : 0.0;
      }
      for (int y = 0; y < height; y += kUp) {
        const double up = 1.0 - (y + 0.5 * kUp) / height;
        const double share =
            share_of(window, kLowest * std::pow(kHighest / kLowest, up), sound.rate);
        const double db = 20.0 * std::log10(std::max(share, 1e-9));
        paint(image, x, y, kAcross, kUp,
              std::clamp((db - kFaintest) / (kLoudest - kFaintest), 0.0, 1.0));
      }
    }
    return image;
  }

  static void paint(view::Image& image, int x0, int y0, int w, int h, double loud) {
    const view::Color middle = view::kCobalt, ink = view::kInk;
    const auto mixed = [&](float paper, float half, float full) {
      const double v =
          loud < 0.5 ? paper + (half - paper) * 2 * loud : half + (full - half) * (2 * loud - 1);
      return static_cast<std::uint8_t>(std::lround(255 * std::clamp(v, 0.0, 1.0)));
    };
    const std::uint8_t rgba[4] = {mixed(drawing::kPaper.r, middle.r, ink.r),
                                  mixed(drawing::kPaper.g, middle.g, ink.g),
                                  mixed(drawing::kPaper.b, middle.b, ink.b), 255};
    for (int y = y0; y < std::min(y0 + h, image.height); ++y)
      for (int x = x0; x < std::min(x0 + w, image.width); ++x)
        std::copy_n(rgba, 4,
                    image.rgba.begin() + 4 * (static_cast<std::ptrdiff_t>(y) * image.width + x));
  }
};

}  // namespace

std::vector<std::byte> draw_spectrogram(const Spectrogram& sound, const std::string& file) {
  return SpectrogramPen().draw(sound, files::is_svg(file));
}

}  // namespace onggi::pages
