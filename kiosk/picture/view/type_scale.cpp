#include "kiosk/picture/view/type_scale.h"

#include <algorithm>
#include <cmath>

namespace onggi::view {
namespace {

constexpr double kCapitalAngle = 0.7 * 3.14159265358979 / 180.0;
constexpr double kCapitalHeight = 0.714;  // of an em, in the Noto families

}  // namespace

TypeScale TypeScale::for_screen(int width, int height, double diagonal_mm, double distance_mm) {
  const double pixels_per_mm = std::hypot(width, height) / std::max(diagonal_mm, 1.0);
  const double capital = distance_mm * std::tan(kCapitalAngle) * pixels_per_mm;
  const double most = std::min(width, height) / 18.0;
  return TypeScale(
      static_cast<float>(std::clamp(capital / kCapitalHeight, 10.0, std::max(most, 10.0))));
}

float TypeScale::px(int step) const {
  return std::round(body_ * std::pow(1.333f, static_cast<float>(step)));
}

}  // namespace onggi::view
