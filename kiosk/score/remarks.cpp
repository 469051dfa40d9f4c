#include "kiosk/score/remarks.h"

#include <algorithm>
#include <cmath>

namespace onggi::score {

namespace {

/// Below this share of the vessel's size a visitor does not see a difference side by side.
constexpr double kAlike = 0.025;
constexpr double kOutlineAlike = 0.95;
constexpr double kWallAlike = 0.85;
constexpr double kWallUneven = 0.75;
constexpr std::size_t kMost = 3;
/// A named part is the largest difference where it is as much as this share of the worst place's.
constexpr double kAsMuch = 0.9;
/// A place this near to a part is that part, of the height.
constexpr double kAtEnd = 0.06, kAtPart = 0.08;
/// A neck is a neck where it is this much narrower than the lip over it.
constexpr double kNeck = 0.97;
/// A belly this near to the rim is the mouth.
constexpr double kMouthHeight = 0.93;

/// One thing that callipers measure: its name, and made minus wanted in metres.
struct Feature {
  const char* name;
  double difference;
  const char* more;  ///< Ending of the remark's key where `difference` is above 0...
  const char* less;  ///< ...and below.
  double weight;
};

std::vector<Feature> features(const Measures& m) {
  std::vector<Feature> out;
  const Dimensions &made = m.made, &target = m.target;
  const bool bellied = target.belly_height < kMouthHeight * target.height;
  if (bellied) {
    out.push_back({"belly", made.belly - target.belly, "wide", "narrow", 1.0});
    // Where the belly is hardly one, its height says little.
    const double pronounced =
        std::min(1.0, 4.0 * (target.belly - std::max(target.foot, target.mouth)) / target.belly);
    out.push_back({"belly", made.belly_height - target.belly_height, "high", "low",
                   std::max(0.0, 0.5 * pronounced)});
  }
  if (target.neck < kNeck * target.mouth)
    out.push_back({"neck", made.neck - target.neck, "wide", "narrow", 1.0});
  out.push_back({"mouth", made.mouth - target.mouth, "wide", "narrow", 1.0});
  out.push_back({"foot", made.foot - target.foot, "wide", "narrow", 0.9});
  return out;
}

std::string whole(double value) { return std::to_string(std::lround(value)); }

struct Ranked {
  double rank;
  Remark remark;
};

/// The first few by falling rank; equals keep their order.
std::vector<Remark> best(std::vector<Ranked> all) {
  std::stable_sort(all.begin(), all.end(),
                   [](const Ranked& a, const Ranked& b) { return a.rank > b.rank; });
  std::vector<Remark> out;
  for (std::size_t i = 0; i < std::min(kMost, all.size()); ++i)
    out.push_back(std::move(all[i].remark));
  return out;
}

}  // namespace

double size_of(const Dimensions& target) {
  return std::sqrt(target.height * std::max(target.height, target.belly));
}

std::vector<Remark> alike(const Measures& m, bool scale_free) {
  const double size = size_of(m.target);
  std::vector<Ranked> found;
  if (m.outline_overlap >= kOutlineAlike)
    found.push_back({1.0, {"alike.outline", {{"percent", whole(100.0 * m.outline_overlap)}}}});
  for (const Feature& f : features(m)) {
    const double apart = std::abs(f.difference) / size;
    // The height of the belly is only ever something to try.
    if (apart <= kAlike && std::string(f.more) == "wide")
      found.push_back({1.0 - apart, {std::string("alike.") + f.name, {}}});
  }
  const double taller = std::abs(m.made.height - m.target.height) / m.target.height;
  if (!scale_free && taller <= kAlike) found.push_back({1.0 - taller, {"alike.height", {}}});
  if (m.made.wall_mean > 0.0 && m.made.wall_evenness >= kWallAlike)
    found.push_back({0.5 + 0.4 * m.made.wall_evenness, {"alike.wall", {}}});
  if (found.empty()) found.push_back({0.0, {"alike.start", {}}});
  return best(std::move(found));
}

std::optional<Remark> largest_difference(const Measures& m, bool scale_free, double true_scale) {
  const double worst = 2.0 * m.common_worst * m.target.height;  // as a diameter
  const auto mm = [&](double apart) { return std::lround(1000.0 * true_scale * std::abs(apart)); };
  const auto told = [&](const std::string& ending, double apart) -> std::optional<Remark> {
    if (mm(apart) == 0) return std::nullopt;
    return Remark{"difference." + ending, {{"mm", std::to_string(mm(apart))}}};
  };
  const double taller = m.made.height - m.target.height;
  if (!scale_free && std::abs(taller) > worst) return told(taller > 0.0 ? "tall" : "short", taller);

  const std::vector<Feature> parts = features(m);
  const Feature* largest = nullptr;
  for (const Feature& f : parts) {
    // How high the belly sits counts where there is one to speak of, and it is out by more.
    const bool height = std::string(f.more) == "high";
    if (std::abs(f.difference) < (height ? 1.0 : kAsMuch) * worst || f.weight < 0.2) continue;
    if (largest == nullptr || std::abs(f.difference) > std::abs(largest->difference)) largest = &f;
  }
  if (largest != nullptr)
    return told(std::string(largest->name) + "_" +
                    (largest->difference > 0.0 ? largest->more : largest->less),
                largest->difference);

  const std::string ending = m.common_worst_sign > 0.0 ? "wide" : "narrow";
  const double at = m.common_worst_at;
  const auto near = [&](double height, double reach) {
    return std::abs(at - height / m.target.height) <= reach;
  };
  if (at <= kAtEnd) return told("foot_" + ending, worst);
  if (at >= 1.0 - kAtEnd) return told("mouth_" + ending, worst);
  for (const Feature& f : parts) {
    if (std::string(f.more) != "wide") continue;
    if (f.name == std::string("neck") && near(m.target.neck_height, kAtPart))
      return told("neck_" + ending, worst);
    if (f.name == std::string("belly") && near(m.target.belly_height, kAtPart))
      return told("belly_" + ending, worst);
  }
  auto remark = told(ending, worst);
  if (remark) remark->places["percent"] = whole(100.0 * at);
  return remark;
}

std::vector<Remark> try_next(const Measures& m, bool scale_free, double true_scale) {
  const double size = size_of(m.target);
  const auto mm = [&](double difference) {
    return std::lround(1000.0 * true_scale * std::abs(difference));
  };
  std::vector<Ranked> found;
  for (const Feature& f : features(m)) {
    const double apart = std::abs(f.difference) / size;
    if (apart <= kAlike || f.weight * apart <= 0.5 * kAlike || mm(f.difference) == 0) continue;
    const std::string key =
        std::string("remark.") + f.name + "_" + (f.difference > 0.0 ? f.more : f.less);
    found.push_back({f.weight * apart, {key, {{"mm", std::to_string(mm(f.difference))}}}});
  }
  const double taller = m.made.height - m.target.height;
  if (!scale_free && std::abs(taller) > kAlike * m.target.height && mm(taller) > 0)
    found.push_back(
        {std::abs(taller) / size,
         {taller > 0.0 ? "remark.tall" : "remark.short", {{"mm", std::to_string(mm(taller))}}}});
  if (m.made.wall_mean > 0.0 &&
      m.made.wall_evenness < std::min(kWallUneven, m.target.wall_evenness))
    found.push_back(
        {0.05 * (1.0 - m.made.wall_evenness),
         {"remark.wall_uneven", {{"percent", whole(100.0 * (1.0 - m.made.wall_evenness))}}}});

  // The place where the outlines are furthest apart, unless a named part already says as much.
  const double worst = 2.0 * m.outline_worst * m.target.height;
  double named = 0.0;
  for (const Ranked& r : found) named = std::max(named, r.rank);
  if (m.outline_worst_sign != 0.0 && worst / size > 2.0 * named && m.outline_worst_at <= 1.0 &&
      mm(worst) > 0)
    found.push_back(
        {worst / size,
         {m.outline_worst_sign > 0.0 ? "remark.wide" : "remark.narrow",
          {{"mm", std::to_string(mm(worst))}, {"percent", whole(100.0 * m.outline_worst_at)}}}});
  return best(std::move(found));
}

std::vector<std::string> remark_keys() {
  std::vector<std::string> keys{"alike.outline", "alike.belly", "alike.mouth",
                                "alike.foot",    "alike.neck",  "alike.height",
                                "alike.wall",    "alike.start", "remark.wall_uneven"};
  for (const char* family : {"remark.", "difference."})
    for (const char* ending : {"belly_wide", "belly_narrow", "belly_high", "belly_low", "neck_wide",
                               "neck_narrow", "mouth_wide", "mouth_narrow", "foot_wide",
                               "foot_narrow", "wide", "narrow", "tall", "short"})
      keys.push_back(std::string(family) + ending);
  return keys;
}

}  // namespace onggi::score
