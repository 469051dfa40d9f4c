#pragma once

/// Elementary functions that give the same bits on every machine, compiler and optimisation level.
/// libm's do not: it picks code by the processor (with or without fused multiply-add), and the last
/// bit of a sine is enough to send a replay elsewhere. Only +, -, *, / and sqrt are used here, each
/// correctly rounded by IEEE 754. Within 2 units in the last place unless said otherwise. No
/// allocation, no errno, any thread.
namespace onggi::portable {

inline constexpr double kPi = 0x1.921fb54442d18p+1;

/// Radians. To 2 ulp for |x| <= 1e6 (beyond, x is first reduced by the double nearest 2 pi, so the
/// error grows with x / 2 pi turns); not finite gives NaN.
double sin(double x);
double cos(double x);
/// Angle of the point (x, y) from the x axis, -pi..pi; 0 at the origin. |x|, |y| <= 1e300.
double atan2(double y, double x);
/// -pi/2..pi/2; NaN outside -1..1.
double asin(double x);

double exp(double x);    ///< e^x; 0 below -746, infinity above 709.79.
double expm1(double x);  ///< e^x - 1 without cancellation near 0; 3 ulp.
double log(double x);    ///< Natural; -infinity at 0, NaN below.

}  // namespace onggi::portable
