#include "kiosk/visit/screens/pen_strokes.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace onggi::screens {
namespace {

constexpr double kDegree = 3.14159265358979 / 180;

/// The numbers of `text`, separated by spaces and commas. Nothing if it contains anything else.
std::optional<std::vector<float>> numbers_of(std::string_view text) {
  std::vector<float> numbers;
  for (const char* at = text.data(); at != text.data() + text.size();) {
    if (*at == ' ' || *at == ',') {
      ++at;
      continue;
    }
    float number = 0;
    const auto read = std::from_chars(at, text.data() + text.size(), number);
    if (read.ec != std::errc()) return std::nullopt;
    numbers.push_back(number);
    at = read.ptr;
  }
  return numbers;
}

PenStroke arc_of(const std::vector<float>& n) {
  PenStroke stroke;
  constexpr int kParts = 20;
  const double from = static_cast<double>(n[4]) * kDegree, to = static_cast<double>(n[5]) * kDegree;
  for (int i = 0; i <= kParts; ++i) {
    const double angle = from + (to - from) * i / kParts;
    stroke.emplace_back(n[0] + n[2] * static_cast<float>(std::cos(angle)),
                        n[1] + n[3] * static_cast<float>(std::sin(angle)));
  }
  return stroke;
}

PenStroke stroke_of(std::string_view text) {
  constexpr std::string_view kArc = "arc ";
  while (text.starts_with(' ')) text.remove_prefix(1);
  const bool arc = text.starts_with(kArc);
  const auto numbers = numbers_of(arc ? text.substr(kArc.size()) : text);
  if (!numbers) return {};
  if (arc) return numbers->size() == 6 ? arc_of(*numbers) : PenStroke{};
  PenStroke stroke;
  for (std::size_t n = 0; n + 1 < numbers->size(); n += 2)
    stroke.emplace_back((*numbers)[n], (*numbers)[n + 1]);
  return numbers->size() % 2 == 0 && stroke.size() >= 2 ? stroke : PenStroke{};
}

}  // namespace

std::vector<PenStroke> pen_strokes(std::string_view drawing) {
  std::vector<PenStroke> strokes;
  while (!drawing.empty()) {
    const std::size_t end = std::min(drawing.find(';'), drawing.size());
    if (PenStroke stroke = stroke_of(drawing.substr(0, end)); !stroke.empty())
      strokes.push_back(std::move(stroke));
    drawing.remove_prefix(std::min(end + 1, drawing.size()));
  }
  return strokes;
}

}  // namespace onggi::screens
