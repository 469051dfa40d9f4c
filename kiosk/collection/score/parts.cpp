#include "kiosk/collection/score/parts.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace onggi::score {

namespace {

/// Percentages that have names: a fiftieth, a thirtieth ... half ... nine tenths; and kFar: "far".
constexpr int kFar = 100;
constexpr int kParts[] = {2, 3, 5, 7, 10, 12, 17, 20, 25, 33, 40, 50, 60, 67, 75, 90, kFar};

bool ends_with(const std::string& text, const std::string& ending) {
  return text.size() >= ending.size() &&
         text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

/// The length of the vessel that the remark compares with.
double whole_of(const std::string& key, const Dimensions& target) {
  for (const char* along : {"_high", "_low", ".tall", ".short"})
    if (ends_with(key, along)) return target.height;
  const auto about = [&key](const char* name) { return key.find(name) != std::string::npos; };
  if (about(".neck_")) return target.neck;
  if (about(".mouth_")) return target.mouth;
  if (about(".foot_")) return target.foot;
  return target.belly;
}

/// "Far too wide" is a sentence, "far of the height" is none.
bool may_be_far(const std::string& key) {
  return !ends_with(key, "_high") && !ends_with(key, "_low");
}

int nearest_part(double share, bool far) {
  int best = kParts[0];
  for (const int part : kParts) {
    if (part == kFar && !far) continue;
    if (std::abs(std::log(share / (0.01 * part))) < std::abs(std::log(share / (0.01 * best))))
      best = part;
  }
  return best;
}

}  // namespace

Remark in_parts(Remark remark, const Measures& measures, double true_scale) {
  const auto mm = remark.places.find("mm");
  if (mm == remark.places.end()) return remark;
  const double apart = 0.001 * std::strtod(mm->second.c_str(), nullptr) / true_scale;
  const double share = apart / std::max(whole_of(remark.key, measures.target), 1e-9);
  remark.places.erase(mm);
  remark.places["part"] = std::to_string(nearest_part(share, may_be_far(remark.key)));
  remark.key.insert(remark.key.find('.'), "_part");
  return remark;
}

std::vector<std::string> part_keys() {
  std::vector<std::string> keys;
  for (const int part : kParts) keys.push_back("part." + std::to_string(part));
  for (const char* family : {"remark_part.", "difference_part."})
    for (const char* ending : {"belly_wide", "belly_narrow", "belly_high", "belly_low", "neck_wide",
                               "neck_narrow", "mouth_wide", "mouth_narrow", "foot_wide",
                               "foot_narrow", "wide", "narrow", "tall", "short"})
      keys.push_back(std::string(family) + ending);
  return keys;
}

}  // namespace onggi::score
