#include "kiosk/lab/measure/similarity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace onggi::measure {
namespace {

constexpr int kReach = 5;  // of the window, to each side
constexpr double kSigma = 1.5;
constexpr double kOfMeans = (0.01 * 255) * (0.01 * 255), kOfSpreads = (0.03 * 255) * (0.03 * 255);

struct Plane {
  int width = 0, height = 0;
  std::vector<double> at{};
  double& operator()(int x, int y) {
    return at[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
              static_cast<std::size_t>(x)];
  }
};

Plane luma(const view::Image& image, int left, int top, int width, int height) {
  Plane plane{width, height, std::vector<double>(static_cast<std::size_t>(width * height))};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto* p = &image.rgba[4 * (static_cast<std::size_t>(top + y) *
                                           static_cast<std::size_t>(image.width) +
                                       static_cast<std::size_t>(left + x))];
      plane(x, y) = 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2];
    }
  return plane;
}

Plane product(const Plane& a, const Plane& b) {
  Plane out = a;
  for (std::size_t i = 0; i < out.at.size(); ++i) out.at[i] *= b.at[i];
  return out;
}

/// The filtered picture, without the kReach pixels on every side where the window does not fit.
Plane under_window(Plane plane) {
  std::array<double, 2 * kReach + 1> weight{};
  double sum = 0;
  for (int k = -kReach; k <= kReach; ++k)
    sum += weight[static_cast<std::size_t>(k + kReach)] = std::exp(-k * k / (2 * kSigma * kSigma));
  const int w = plane.width - 2 * kReach, h = plane.height - 2 * kReach;
  Plane across{w, plane.height, std::vector<double>(static_cast<std::size_t>(w * plane.height))};
  Plane out{w, h, std::vector<double>(static_cast<std::size_t>(w * h))};
  for (int k = 0; k <= 2 * kReach; ++k) {
    const double share = weight[static_cast<std::size_t>(k)] / sum;
    for (int y = 0; y < plane.height; ++y)
      for (int x = 0; x < w; ++x) across(x, y) += share * plane(x + k, y);
  }
  for (int k = 0; k <= 2 * kReach; ++k) {
    const double share = weight[static_cast<std::size_t>(k)] / sum;
    for (int y = 0; y < h; ++y)
      for (int x = 0; x < w; ++x) out(x, y) += share * across(x, y + k);
  }
  return out;
}

}  // namespace

double structural_similarity(const view::Image& a, const view::Image& b, const view::Rect& within) {
  if (a.width != b.width || a.height != b.height || a.rgba.size() != b.rgba.size()) return 0;
  const int left = std::clamp(static_cast<int>(within.x), 0, a.width);
  const int top = std::clamp(static_cast<int>(within.y), 0, a.height);
  const int width = std::clamp(static_cast<int>(within.w), 0, a.width - left);
  const int height = std::clamp(static_cast<int>(within.h), 0, a.height - top);
  if (std::min(width, height) <= 2 * kReach) return 0;
  const Plane pa = luma(a, left, top, width, height), pb = luma(b, left, top, width, height);
  const Plane mean_a = under_window(pa), mean_b = under_window(pb);
  const Plane aa = under_window(product(pa, pa)), bb = under_window(product(pb, pb));
  const Plane ab = under_window(product(pa, pb));
  double sum = 0;
  for (std::size_t i = 0; i < ab.at.size(); ++i) {
    const double ma = mean_a.at[i], mb = mean_b.at[i];
    sum +=
        (2 * ma * mb + kOfMeans) * (2 * (ab.at[i] - ma * mb) + kOfSpreads) /
        ((ma * ma + mb * mb + kOfMeans) * (aa.at[i] - ma * ma + bb.at[i] - mb * mb + kOfSpreads));
  }
  return sum / static_cast<double>(ab.at.size());
}

}  // namespace onggi::measure
