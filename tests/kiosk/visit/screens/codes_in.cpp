#include "tests/kiosk/visit/screens/codes_in.h"

#include <zbar.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace onggi::screens {

namespace {

std::vector<float> grey_of(const view::Image& image) {
  std::vector<float> grey;
  for (std::size_t i = 0; i + 3 < image.rgba.size(); i += 4)
    grey.push_back(static_cast<float>(299 * image.rgba[i] + 587 * image.rgba[i + 1] +
                                      114 * image.rgba[i + 2]) /
                   1000.0f);
  return grey;
}

/// The line of `count` values `stride` apart, to `wanted` values that each are the mean of what
/// falls into them.
std::vector<float> resampled(const float* from, int count, int stride, int wanted) {
  std::vector<float> out(static_cast<std::size_t>(wanted), 0.0f);
  const double step = static_cast<double>(count) / wanted;
  for (int n = 0; n < wanted; ++n) {
    const double begin = n * step, end = begin + step;
    double sum = 0;
    for (int k = static_cast<int>(begin); k < count && k < end; ++k)
      sum += from[k * stride] * (std::min(end, k + 1.0) - std::max(begin, static_cast<double>(k)));
    out[static_cast<std::size_t>(n)] = static_cast<float>(sum / step);
  }
  return out;
}

std::vector<float> blurred(const std::vector<float>& line, double sigma) {
  const int reach = static_cast<int>(std::ceil(3 * sigma)), count = static_cast<int>(line.size());
  std::vector<float> weights, out(line.size());
  float all = 0;
  for (int k = -reach; k <= reach; ++k) {
    weights.push_back(static_cast<float>(std::exp(-0.5 * k * k / (sigma * sigma))));
    all += weights.back();
  }
  for (int n = 0; n < count; ++n) {
    float sum = 0;
    for (int k = -reach; k <= reach; ++k)
      sum += weights[static_cast<std::size_t>(k + reach)] *
             line[static_cast<std::size_t>(std::clamp(n + k, 0, count - 1))];
    out[static_cast<std::size_t>(n)] = sum / all;
  }
  return out;
}

}  // namespace

std::vector<std::string> codes_in(const view::Image& image) {
  std::vector<std::uint8_t> grey;
  for (const float value : grey_of(image)) grey.push_back(static_cast<std::uint8_t>(value));
  const std::unique_ptr<zbar::zbar_image_scanner_t, void (*)(zbar::zbar_image_scanner_t*)> scanner(
      zbar::zbar_image_scanner_create(), zbar::zbar_image_scanner_destroy);
  zbar::zbar_image_scanner_set_config(scanner.get(), zbar::ZBAR_NONE, zbar::ZBAR_CFG_ENABLE, 0);
  zbar::zbar_image_scanner_set_config(scanner.get(), zbar::ZBAR_QRCODE, zbar::ZBAR_CFG_ENABLE, 1);
  const std::unique_ptr<zbar::zbar_image_t, void (*)(zbar::zbar_image_t*)> seen(
      zbar::zbar_image_create(), zbar::zbar_image_destroy);
  zbar::zbar_image_set_format(seen.get(), 'Y' | '8' << 8 | '0' << 16 | '0' << 24);
  zbar::zbar_image_set_size(seen.get(), static_cast<unsigned>(image.width),
                            static_cast<unsigned>(image.height));
  zbar::zbar_image_set_data(seen.get(), grey.data(), grey.size(), nullptr);
  zbar::zbar_scan_image(scanner.get(), seen.get());
  std::vector<std::string> found;
  for (const auto* at = zbar::zbar_image_first_symbol(seen.get()); at != nullptr;
       at = zbar::zbar_symbol_next(at)) {
    std::string text(zbar::zbar_symbol_get_data(at), zbar::zbar_symbol_get_data_length(at));
    if (std::find(found.begin(), found.end(), text) == found.end()) found.push_back(text);
  }
  std::sort(found.begin(), found.end());
  return found;
}

view::Image seen_through(const view::Image& image, double scale, double sigma) {
  const int width = static_cast<int>(std::lround(image.width * scale));
  const int height = static_cast<int>(std::lround(image.height * scale));
  const std::vector<float> grey = grey_of(image);
  const auto at = [](int x, int y, int across) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(across) +
           static_cast<std::size_t>(x);
  };
  std::vector<float> rows(at(0, image.height, width));
  for (int y = 0; y < image.height; ++y) {
    auto line = resampled(&grey[at(0, y, image.width)], image.width, 1, width);
    if (sigma > 0) line = blurred(line, sigma);
    std::copy(line.begin(), line.end(),
              rows.begin() + static_cast<std::ptrdiff_t>(at(0, y, width)));
  }
  view::Image out{width, height, std::vector<std::uint8_t>(4 * at(0, height, width), 255)};
  for (int x = 0; x < width; ++x) {
    auto line = resampled(&rows[at(x, 0, width)], image.height, width, height);
    if (sigma > 0) line = blurred(line, sigma);
    for (int y = 0; y < height; ++y)
      for (std::size_t c = 0; c < 3; ++c)
        out.rgba[4 * at(x, y, width) + c] =
            static_cast<std::uint8_t>(std::lround(line[static_cast<std::size_t>(y)]));
  }
  return out;
}

}  // namespace onggi::screens
