#include "engine/math/portable.h"

#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>

namespace onggi::portable {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

// c[0] + c[1] x + ... by Horner's rule. Contraction to fused multiply-add is off for the engine.
template <std::size_t N>
double polynomial(const double (&c)[N], double x) {
  double sum = c[N - 1];
  for (std::size_t n = N - 1; n-- > 0;) sum = sum * x + c[n];
  return sum;
}

// x = turns * pi/2 + r, |r| <= pi/4.
struct QuarterTurns {
  int quadrant;  // turns mod 4
  double r;
};

QuarterTurns reduce(double x) {
  constexpr double kTwoOverPi = 0x1.45f306dc9c883p-1;
  // pi/2 in three parts of 33 bits: times a count below 2^20 each product is exact.
  constexpr double kHalfPi1 = 0x1.921fb54400000p+0;
  constexpr double kHalfPi2 = 0x1.0b4611a600000p-34;
  constexpr double kHalfPi3 = 0x1.3198a2e037073p-69;
  if (std::fabs(x) > 1e6) x = std::fmod(x, 2.0 * kPi);  // exact by IEEE 754
  const double turns = std::floor(x * kTwoOverPi + 0.5);
  const double r = ((x - turns * kHalfPi1) - turns * kHalfPi2) - turns * kHalfPi3;
  return {static_cast<int>(static_cast<long long>(turns) & 3), r};
}

// Taylor series on |r| <= pi/4; the first term left out is below 1e-19.
double sin_small(double r) {
  static constexpr double c[] = {-1.0 / 6,
                                 1.0 / 120,
                                 -1.0 / 5040,
                                 1.0 / 362880,
                                 -1.0 / 39916800,
                                 1.0 / 6227020800.0,
                                 -1.0 / 1307674368000.0,
                                 1.0 / 355687428096000.0};
  const double z = r * r;
  return r + r * z * polynomial(c, z);
}

double cos_small(double r) {
  static constexpr double c[] = {
      1.0 / 24,        -1.0 / 720,           1.0 / 40320,           -1.0 / 3628800,
      1.0 / 479001600, -1.0 / 87178291200.0, 1.0 / 20922789888000.0};
  const double z = r * r;
  // 1 - z/2 rounded, with what the rounding lost put back.
  const double half = 0.5 * z;
  const double top = 1.0 - half;
  return top + (((1.0 - top) - half) + z * z * polynomial(c, z));
}

// e^r - 1 on |r| <= ln(2)/2, without its first term: e^r = 1 + r + tail.
double exp_tail(double r) {
  static constexpr double c[] = {1.0 / 2,        1.0 / 6,           1.0 / 24,
                                 1.0 / 120,      1.0 / 720,         1.0 / 5040,
                                 1.0 / 40320,    1.0 / 362880,      1.0 / 3628800,
                                 1.0 / 39916800, 1.0 / 479001600.0, 1.0 / 6227020800.0};
  return r * r * polynomial(c, r);
}

constexpr double kLn2High = 0x1.62e42fee00000p-1;  // 32 bits: times an exponent it is exact
constexpr double kLn2Low = 0x1.a39ef35793c76p-33;

// x = k ln 2 + high - low, |high - low| <= ln(2)/2.
struct BinaryPart {
  int k;
  double high, low;
};

BinaryPart split_binary(double x) {
  constexpr double kOneOverLn2 = 0x1.71547652b82fep+0;
  const double k = std::floor(x * kOneOverLn2 + 0.5);
  return {static_cast<int>(k), x - k * kLn2High, k * kLn2Low};
}

// atan(y / x) for 0 <= y <= x, x > 0.
double atan_octant(double y, double x) {
  // Turn back by the nearest of atan(0, 1/4, .. 1), so that the series' argument is at most 1/8.
  static constexpr double kAngle[] = {0.0, 0x1.f5b75f92c80ddp-3, 0x1.dac670561bb4fp-2,
                                      0x1.4978fa3269ee1p-1, 0x1.921fb54442d18p-1};
  const double step = std::floor(4.0 * (y / x) + 0.5);
  const double slope = 0.25 * step;
  const double u = (y - slope * x) / (x + slope * y);
  static constexpr double c[] = {-1.0 / 3,  1.0 / 5,  -1.0 / 7,  1.0 / 9,
                                 -1.0 / 11, 1.0 / 13, -1.0 / 15, 1.0 / 17};
  const double z = u * u;
  return kAngle[static_cast<int>(step)] + (u + u * z * polynomial(c, z));
}

}  // namespace

double sin(double x) {
  if (!std::isfinite(x)) return kNan;
  const QuarterTurns q = reduce(x);
  const double s = (q.quadrant & 1) != 0 ? cos_small(q.r) : sin_small(q.r);
  return (q.quadrant & 2) != 0 ? -s : s;
}

double cos(double x) {
  if (!std::isfinite(x)) return kNan;
  const QuarterTurns q = reduce(x);
  const double c = (q.quadrant & 1) != 0 ? sin_small(q.r) : cos_small(q.r);
  return q.quadrant == 1 || q.quadrant == 2 ? -c : c;
}

double atan2(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return kNan;
  const double ax = std::fabs(x);
  const double ay = std::fabs(y);
  if (ax == 0.0 && ay == 0.0) return 0.0;
  double angle = ay <= ax ? atan_octant(ay, ax) : 0.5 * kPi - atan_octant(ax, ay);
  if (x < 0.0) angle = kPi - angle;
  return y < 0.0 ? -angle : angle;
}

double asin(double x) {
  if (!(std::fabs(x) <= 1.0)) return kNan;
  return atan2(x, std::sqrt((1.0 - x) * (1.0 + x)));
}

double exp(double x) {
  if (std::isnan(x)) return kNan;
  if (x > 709.79) return kInf;
  if (x < -746.0) return 0.0;
  const BinaryPart b = split_binary(x);
  const double r = b.high - b.low;
  const double lost = (b.high - r) - b.low;
  const double p = 1.0 + (r + (lost + exp_tail(r)));
  return std::ldexp(p, b.k);  // exact, or rounded once where the result is subnormal
}

double expm1(double x) {
  if (std::isnan(x)) return kNan;
  if (x > 709.79) return kInf;
  if (x < -40.0) return -1.0;
  const BinaryPart b = split_binary(x);
  const double r = b.high - b.low;
  const double lost = (b.high - r) - b.low;
  const double p = r + (lost + exp_tail(r));
  if (b.k == 0) return p;
  if (b.k > 60) return std::ldexp(1.0 + p, b.k);
  const double scale = std::ldexp(1.0, b.k);
  return (scale - 1.0) + scale * p;
}

double log(double x) {
  if (std::isnan(x) || x < 0.0) return kNan;
  if (x == 0.0) return -kInf;
  if (std::isinf(x)) return kInf;
  int e = 0;
  double m = std::frexp(x, &e);  // 0.5..1
  if (m < 0x1.6a09e667f3bcdp-1) {
    m *= 2.0;
    --e;
  }
  // log m = 2 atanh(s), |s| <= 0.172.
  const double f = m - 1.0;
  const double s = f / (m + 1.0);
  static constexpr double c[] = {1.0 / 3,  1.0 / 5,  1.0 / 7,  1.0 / 9,  1.0 / 11,
                                 1.0 / 13, 1.0 / 15, 1.0 / 17, 1.0 / 19, 1.0 / 21};
  const double z = s * s;
  const double tail = 2.0 * s * z * polynomial(c, z);
  // 2 s = f - f s: f is exact, so only the small product carries the division's error.
  return e * kLn2High + (f + (tail - f * s + e * kLn2Low));
}

}  // namespace onggi::portable
