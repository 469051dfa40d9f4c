#include "kiosk/visit/screens/hidden_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "kiosk/collection/textures/srgb.h"

namespace onggi::screens {

namespace {

constexpr int kEveryRow = 6, kEverySector = 7;
constexpr int kFootRows = 32;        // 8 mm that no cover reaches
constexpr int kLevels = 15;          // that a share is told by
constexpr double kSeenApart = 0.12;  // of sRGB's range, weighted as the eye does
constexpr int kDeepEnough = 2;       // levels of depth: 0.14 mm
constexpr double kHardly = 0.2;      // of what the best glaze shows

/// What matters of a place: its top slip, and the levels of its cover, depth and glaze.
struct Sample {
  int pigment = 0, cover = 0, depth = 0, glaze = 0;
  auto operator<=>(const Sample&) const = default;
};

std::map<Sample, int> samples_of(const decorating::DecoratedPot& pot) {
  const auto& picture = pot.picture();
  const auto rows =
      std::min(static_cast<int>(pot.outside() * 1e6) / surface::kRowHeight, pot.surface().rows());
  const bool glazed = pot.glazed();
  std::map<Sample, int> all;
  const auto level = [](std::uint8_t value) { return (value * kLevels + 127) / 255; };
  for (int j = kFootRows; j < rows; j += kEveryRow)
    for (int i = 0; i < surface::kSectors; i += kEverySector) {
      const auto at = static_cast<std::size_t>(j) * surface::kSectors + static_cast<std::size_t>(i);
      Sample one;
      one.cover = level(picture.paint()[at][3]);
      one.depth = level(picture.form()[at][2]);
      const auto top = pot.surface().slip(j, i).at(0);
      // Smoke covers without a slip. So does glaze until it melts.
      if (glazed) {
        one.glaze = level(picture.form()[at][3]);
        if (pot.surface().glaze(j, i) > 0)
          one.cover = top.code > 0 ? kLevels : pot.surface().smoke(j, i) > 0 ? one.cover : 0;
      }
      one.pigment = one.cover == 0 ? 0 : top.code > 0 ? top.pigment : -1;
      ++all[one];
    }
  return all;
}

using Light = std::array<double, 3>;

/// A place under a glaze, as of_glaze in clay.glsl has it without pools and flecks; sRGB.
Light under_glaze(const Sample& at, const decoration::Palette& palette,
                  const content::GlazeLook& look, double coat, bool own_glaze) {
  constexpr double kEven = 0.62, kGroove = 2.55, kPaintSeen = 0.65, kAbsorbs = 1.15;
  constexpr float kCarbonLight = 0.02f;
  const double share = static_cast<double>(at.cover) / kLevels;
  double thick = kEven + kGroove * at.depth / kLevels * std::min(1.3 * look.pooling, 1.0);
  if (own_glaze) coat *= kGroove * at.glaze / kLevels;
  thick = coat * std::clamp(thick, 0.05, 1.8);
  const double slip = look.slip_cover * (1.0 - 0.5 * look.brushed) * std::min(1.9 * thick, 1.0);
  const double glass = std::min(4.0 * coat, 1.0);
  Light out{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double paint = at.pigment < 0 ? kCarbonLight
                         : palette.pigments.empty()
                             ? 0.0
                             : palette.pigments[static_cast<std::size_t>(at.pigment)].fired[k];
    const double body = look.body[k];
    const double clay = body + (look.slip[k] - body) * slip;
    const double under = clay + (paint - clay) * share, bare = body + (paint - body) * share;
    const double through =
        std::pow(std::max(look.glass[k], 1e-4f), kAbsorbs * thick * (1.0 - kPaintSeen * share));
    out[k] = textures::srgb_of_light(bare + (under * through * 0.86 - bare) * glass);
  }
  return out;
}

double apart(const Light& a, const Light& b) {
  constexpr Light kEye{0.30, 0.59, 0.11};
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k) sum += kEye[k] * (a[k] - b[k]) * (a[k] - b[k]);
  return std::sqrt(sum);
}

/// How much of the outside stands out from what most of it looks like, samples.
int seen(const std::map<Sample, int>& samples, const decoration::Palette& palette,
         const content::GlazeLook& look, double coat, bool own_glaze) {
  const auto most =
      std::ranges::max_element(samples, {}, [](const auto& one) { return one.second; });
  const Light ground = under_glaze(most->first, palette, look, coat, own_glaze);
  int sum = 0;
  for (const auto& [sample, times] : samples)
    // What is cut shows by light and shade.
    if (sample.depth >= kDeepEnough ||
        apart(under_glaze(sample, palette, look, coat, own_glaze), ground) > kSeenApart)
      sum += times;
  return sum;
}

}  // namespace

std::vector<bool> hiding(const decorating::DecoratedPot& pot, const Kiln& kiln) {
  const auto samples = samples_of(pot);
  std::vector<int> shown;
  for (const content::Glaze& glaze : *kiln.glazes)
    shown.push_back(samples.empty()
                        ? 0
                        : seen(samples, pot.way().palette, glaze.look, kiln.coat, pot.glazed()));
  const int best = shown.empty() ? 0 : *std::ranges::max_element(shown);
  std::vector<bool> hides;
  for (const int one : shown) hides.push_back(best > 0 && one < kHardly * best);
  return hides;
}

}  // namespace onggi::screens
