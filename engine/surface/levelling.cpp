#include "engine/surface/levelling.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/math/portable.h"

namespace onggi::surface {

namespace {

/// (1 / pi) integral of exp(-k^4) cos(k x) over k > 0, for x = 0..kEnd: the smoothing of a line as
/// a function of the distance, in lengths by which it levels.
class LevelShape {
 public:
  static constexpr int kParts = 32;  ///< Of a length.
  static constexpr double kEnd = 9.5;

  static const LevelShape& get() {
    static const LevelShape shape;
    return shape;
  }
  double at(double x) const {
    const double place = x * kParts;
    const auto n = static_cast<std::size_t>(place);
    if (n + 2 >= table_.size()) return 0.0;
    // Through three points: the error is below 1e-5.
    const double t = place - static_cast<double>(n);
    const double a = table_[n], b = table_[n + 1], c = table_[n + 2];
    return a + t * (b - a) + 0.5 * t * (t - 1.0) * (c - 2.0 * b + a);
  }

 private:
  LevelShape() {
    // By the trapezoid rule, which is exact but for e^-39 here: exp(-k^4) is nothing beyond 2.5.
    constexpr int kSteps = 128;
    constexpr double kStep = 2.5 / kSteps;
    std::array<double, kSteps> keeps{};
    for (int n = 0; n < kSteps; ++n) {
      const double k = kStep * n;
      keeps[static_cast<std::size_t>(n)] = portable::exp(-k * k * k * k) * (n == 0 ? 0.5 : 1.0);
    }
    table_.resize(static_cast<std::size_t>(kEnd * kParts) + 1);
    for (std::size_t i = 0; i < table_.size(); ++i) {
      double sum = 0.0;
      for (int n = 0; n < kSteps; ++n)
        sum += keeps[static_cast<std::size_t>(n)] *
               portable::cos(kStep * n * static_cast<double>(i) / kParts);
      table_[i] = sum * kStep / portable::kPi;
    }
  }
  std::vector<double> table_;
};

/// kLanes sums over neighbours `stride` apart.
void sum_lanes(const float* at, std::ptrdiff_t stride, const LevelKernel& kernel, float* out) {
  std::array<float, kLanes> sum;
  const float* weights = kernel.weights.data();
  for (std::size_t k = 0; k < kLanes; ++k) sum[k] = weights[0] * at[k];
  const auto reach = static_cast<std::ptrdiff_t>(kernel.reach());
  for (std::ptrdiff_t m = 1; m <= reach; ++m) {
    const float *before = at - m * stride, *behind = at + m * stride;
    const float weight = weights[m];
    for (std::size_t k = 0; k < kLanes; ++k) sum[k] += weight * (before[k] + behind[k]);
  }
  std::copy(sum.begin(), sum.end(), out);
}

float sum_one(const float* at, const LevelKernel& kernel) {
  float sum = kernel.weights[0] * *at;
  for (std::ptrdiff_t m = 1; m <= kernel.reach(); ++m)
    sum += kernel.weights[static_cast<std::size_t>(m)] * (at[-m] + at[m]);
  return sum;
}

int reach_of_all(std::span<const LevelKernel* const> kernels) {
  int most = 0;
  for (const LevelKernel* kernel : kernels) most = std::max(most, kernel->reach());
  return most;
}

/// The cell of a line of `count` that place n is the mirror of.
std::ptrdiff_t mirrored(std::ptrdiff_t n, std::ptrdiff_t count) {
  const std::ptrdiff_t there_and_back = 2 * count;
  n %= there_and_back;
  if (n < 0) n += there_and_back;
  return n < count ? n : there_and_back - 1 - n;
}

}  // namespace

LevelKernel level_kernel(double b) {
  if (!(b >= kLeastLevelling)) return {{1.0f}};
  const double cell = 1.0 / std::sqrt(std::sqrt(b));  // in lengths by which it levels
  const LevelShape& shape = LevelShape::get();
  // Beyond lies 0.2 % of its waves.
  constexpr double kFar = 9.2;
  std::vector<double> weights;
  double sum = 0.0;
  for (int m = 0; m == 0 || m * cell <= kFar; ++m) {
    weights.push_back(cell * shape.at(m * cell));
    sum += (m == 0 ? 1.0 : 2.0) * weights.back();
  }
  LevelKernel kernel;
  for (const double weight : weights) kernel.weights.push_back(static_cast<float>(weight / sum));
  return kernel;
}

void level_lanes(std::span<float> values, std::span<const LevelKernel* const> kernels,
                 std::vector<float>& room) {
  const auto count = static_cast<std::ptrdiff_t>(kernels.size());
  const std::ptrdiff_t reach = reach_of_all(kernels);
  if (reach == 0) return;
  room.resize(static_cast<std::size_t>((count + 2 * reach) * kLanes));
  for (std::ptrdiff_t n = -reach; n < count + reach; ++n)
    std::copy_n(values.data() + mirrored(n, count) * kLanes, kLanes,
                room.data() + (n + reach) * kLanes);
  for (std::ptrdiff_t n = 0; n < count; ++n) {
    const LevelKernel& kernel = *kernels[static_cast<std::size_t>(n)];
    if (!kernel.idle())
      sum_lanes(room.data() + (n + reach) * kLanes, kLanes, kernel, values.data() + n * kLanes);
  }
}

void level_line(std::span<float> values, std::span<const LevelKernel* const> kernels,
                std::vector<float>& room) {
  const auto count = static_cast<std::ptrdiff_t>(values.size());
  const std::ptrdiff_t reach = reach_of_all(kernels);
  if (reach == 0) return;
  room.resize(static_cast<std::size_t>(count + 2 * reach));
  for (std::ptrdiff_t n = -reach; n < count + reach; ++n)
    room[static_cast<std::size_t>(n + reach)] =
        values[static_cast<std::size_t>(mirrored(n, count))];
  for (std::ptrdiff_t n = 0; n < count; ++n) {
    const LevelKernel& kernel = *kernels[static_cast<std::size_t>(n)];
    if (!kernel.idle())
      values[static_cast<std::size_t>(n)] = sum_one(room.data() + n + reach, kernel);
  }
}

void level_ring(std::span<float> values, const LevelKernel& kernel, std::vector<float>& room) {
  if (kernel.idle()) return;
  const auto count = static_cast<std::ptrdiff_t>(values.size());
  const std::ptrdiff_t reach = kernel.reach();
  // kLanes more, so that the last sums find their neighbours, too.
  room.resize(static_cast<std::size_t>(count + 2 * reach + kLanes));
  for (std::size_t n = 0; n < room.size(); ++n) {
    const std::ptrdiff_t from = (static_cast<std::ptrdiff_t>(n) - reach) % count;
    room[n] = values[static_cast<std::size_t>(from < 0 ? from + count : from)];
  }
  std::array<float, kLanes> out;
  for (std::ptrdiff_t n = 0; n < count; n += kLanes) {
    sum_lanes(room.data() + n + reach, 1, kernel, out.data());
    std::copy_n(out.begin(), std::min<std::ptrdiff_t>(kLanes, count - n), values.data() + n);
  }
}

}  // namespace onggi::surface
