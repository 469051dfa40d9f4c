#include "kiosk/collection/score/remarks.h"

#include <algorithm>
#include <cmath>

#include "kiosk/collection/score/in_words.h"
#include "kiosk/collection/score/parts.h"

namespace onggi::score {

namespace {

/// Visitors do not see a smaller difference side by side, as a share of the vessel's size.
constexpr double kAlike = 0.025;
constexpr double kOutlineAlike = 0.95;
constexpr double kWallAlike = 0.85;
constexpr double kWallUneven = 0.75, kAsEven = 0.01;
/// A pot that is further out of round is told so, before what nobody sees of its shape. Share of
/// the size.
constexpr double kTrue = 0.0005;
/// Rank of what cost more than the shape; a closed pot has 1.
constexpr double kBeforeShape = 0.5;
constexpr std::size_t kMost = 3;
/// A named part counts as the largest difference from this share of the worst place on.
constexpr double kAsMuch = 0.9;
/// If the worst place is at the part, within this share of the height, this smaller share is
/// enough.
constexpr double kAtPart = 0.08, kAsMuchThere = 0.6;
/// A ripple is a ring and a groove; it is seen sooner than a width that is out as much.
constexpr double kRipples = 1.5;
/// A neck must be this much narrower than the lip above it.
constexpr double kNeck = 0.97;
/// An opening that lacks this share of the vessel's own counts as closed.
constexpr double kShut = 0.75;
/// A belly this near the rim counts as the mouth.
constexpr double kMouthHeight = 0.93;
/// A belly is this share of its width wider than foot and mouth: a cylinder has none. To speak of
/// its height, vessel and pot need twice as much.
constexpr double kBelly = 0.05;

/// One measure of callipers: its name, and made minus wanted in metres.
struct Feature {
  const char* name;
  double difference;
  const char* more;  ///< Ending of the remark's key where `difference` is above 0...
  const char* less;  ///< ...and below.
  double weight;
  double place;   ///< Its height on the target, metres.
  double length;  ///< The target's own, metres: its width there, or its height.
  /// Where the pot has it, share of the pot's height.
  double made_at;
  /// The pot's own place says it: it is wider or narrower there than the target is anywhere.
  bool at_made = false;
};

/// How much wider than foot and mouth, as a share of its own width.
double bulge(const Dimensions& d) {
  return d.belly > 0.0 ? 1.0 - std::max(d.foot, d.mouth) / d.belly : 0.0;
}

std::vector<Feature> features(const Measures& m) {
  std::vector<Feature> out;
  const Dimensions &made = m.made, &target = m.target;
  const double belly_at = made.belly_height / made.height, neck_at = made.neck_height / made.height;
  const bool bellied = target.belly_height < kMouthHeight * target.height && bulge(target) > kBelly;
  if (bellied) {
    out.push_back({"belly", made.belly - target.belly, "wide", "narrow", 1.0, target.belly_height,
                   target.belly, belly_at, made.belly > target.belly});
    // If there is hardly a belly, its height means little; without one it means nothing.
    const double least = std::min(bulge(target), bulge(made));
    if (least > 2 * kBelly)
      out.push_back({"belly", made.belly_height - target.belly_height, "high", "low",
                     std::min(0.5, 2.0 * least), target.belly_height, target.height, belly_at});
  }
  if (target.neck < kNeck * target.mouth)
    out.push_back({"neck", made.neck - target.neck, "wide", "narrow", 1.0, target.neck_height,
                   target.neck, neck_at, made.neck < target.neck});
  out.push_back({"mouth", made.mouth - target.mouth, "wide", "narrow", 1.0, target.height,
                 target.mouth, 1.0});
  out.push_back({"foot", made.foot - target.foot, "wide", "narrow", 0.9, 0.0, target.foot, 0.0});
  return out;
}

/// At the pot's own size the width is right, or out the other way.
bool only_scaled(const Feature& f, const Measures& m, double size) {
  const double unscaled = (f.length + f.difference) / m.scale - f.length;
  return unscaled * f.difference <= 0.0 || std::abs(unscaled) <= kAlike * size;
}

bool narrow_inside(const Measures& m) { return m.opening_lacking > kOpenEnough; }
bool shut(const Measures& m) { return m.opening_lacking > kShut; }
/// How much narrower the opening is, roughly, as a diameter at the mouth, m.
double opening_apart(const Measures& m) {
  return m.opening_lacking * m.target.opening * m.target.mouth;
}

std::string whole(double value) { return std::to_string(std::lround(value)); }

/// A place on the wall, 1 to 99 percent: 0 is the foot and 100 the rim.
std::string percent_of_height(double at) {
  return std::to_string(std::clamp(std::lround(100.0 * at), 1L, 99L));
}

/// The part of a remark: "mouth" for "difference.mouth_wide" and "alike.mouth".
std::string part_of(const std::string& key) {
  const std::string ending = key.substr(key.find('.') + 1);
  return ending.substr(0, ending.find('_'));
}

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
    // A closed mouth is not right, even if its outside is.
    if (std::string(f.name) == "mouth" && narrow_inside(m)) continue;
    // The height of the belly is only advice, never praise.
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
  const double worst = 2.0 * m.common_firm * m.target.height;  // as a diameter
  const auto mm = [&](double apart) { return std::lround(1000.0 * true_scale * std::abs(apart)); };
  const auto told = [&](const std::string& ending, double apart) -> std::optional<Remark> {
    if (mm(apart) == 0) return std::nullopt;
    return Remark{"difference." + ending, {{"mm", std::to_string(mm(apart))}}};
  };
  if (shut(m)) return Remark{"difference.opening_shut", {}};
  const double taller = m.made.height - m.target.height;
  if (narrow_inside(m) && opening_apart(m) > std::max(worst, scale_free ? 0.0 : std::abs(taller)))
    return Remark{"difference.opening_narrow", {{"percent", whole(100.0 * m.opening_lacking)}}};
  if (!scale_free && std::abs(taller) > worst) return told(taller > 0.0 ? "tall" : "short", taller);

  const std::vector<Feature> parts = features(m);
  const Feature* largest = nullptr;
  for (const Feature& f : parts) {
    // The height of the belly counts only if it is the larger difference.
    const bool height = std::string(f.more) == "high";
    const bool there =
        f.difference * m.common_firm_sign > 0.0 &&
        std::abs(f.place - m.common_firm_at * m.target.height) <= kAtPart * m.target.height;
    const double share = height ? 1.0 : there ? kAsMuchThere : kAsMuch;
    if (std::abs(f.difference) < share * worst) continue;
    if (largest == nullptr || std::abs(f.difference) > std::abs(largest->difference)) largest = &f;
  }
  if (largest != nullptr)
    return told(std::string(largest->name) + "_" +
                    (largest->difference > 0.0 ? largest->more : largest->less),
                largest->difference);

  // Name a part only for the difference that callipers find there. A difference beside a part, such
  // as a rounder lip above a right mouth, is named by its place on the wall.
  auto remark = told(m.common_firm_sign > 0.0 ? "wide" : "narrow", worst);
  if (remark) remark->places["percent"] = percent_of_height(m.common_firm_at);
  return remark;
}

std::vector<Remark> try_next(const Measures& m, const Asked& asked) {
  const double size = size_of(m.target);
  const auto& [scale_free, true_scale, by_line, lost, ripples] = asked;
  const auto mm = [scale = true_scale](double difference) {
    return std::lround(1000.0 * scale * std::abs(difference));
  };
  // The wheel's own metres: what the line shows.
  const double taller = m.made.height / m.scale - m.target.height;
  const bool height_off =
      (by_line || !scale_free) && std::abs(taller) > kAlike * m.target.height && mm(taller) > 0;
  double by_height = scale_free ? 0.0 : std::abs(taller) / size;
  std::vector<Ranked> found;
  for (const Feature& f : features(m)) {
    const double apart = std::abs(f.difference) / size;
    if (apart <= kAlike || f.weight * apart <= 0.5 * kAlike || mm(f.difference) == 0) continue;
    // The widest place is one of the rings.
    if (ripples > 0.0 && std::string(f.more) == "high") continue;
    if (height_off && std::string(f.more) == "wide" && only_scaled(f, m, size)) {
      by_height = std::max(by_height, f.weight * apart);
      continue;
    }
    const std::string key =
        std::string("remark.") + f.name + "_" + (f.difference > 0.0 ? f.more : f.less);
    const double wanted = f.at_made ? f.made_at : f.place / m.target.height;
    const double made = std::string(f.more) == "high" ? f.made_at : wanted;
    found.push_back({f.weight * apart,
                     {key,
                      {{"mm", std::to_string(mm(f.difference))}},
                      Remark::Seen{made, wanted, std::abs(f.difference) / f.length}}});
  }
  if (height_off && by_height > 0.0)
    found.push_back(
        {by_height,
         {taller > 0.0 ? "remark.tall" : "remark.short", {{"mm", std::to_string(mm(taller))}}}});
  // A closed pot comes before everything else.
  if (shut(m))
    found.push_back({1.0, {"remark.opening_shut", {}}});
  else if (narrow_inside(m))
    found.push_back({opening_apart(m) / size,
                     {"remark.opening_narrow", {{"percent", whole(100.0 * m.opening_lacking)}}}});
  if (m.made.wall_mean > 0.0 &&
      m.made.wall_evenness < std::min(kWallUneven, m.target.wall_evenness - kAsEven))
    found.push_back(
        {0.05 * (1.0 - m.made.wall_evenness),
         {"remark.wall_uneven", {{"percent", whole(100.0 * (1.0 - m.made.wall_evenness))}}}});

  if (m.out_of_round > kTrue * size) found.push_back({kAlike, {"remark.not_round", {}}});
  if (ripples > 0.0)
    found.push_back({std::max(kAlike, kRipples * ripples / size), {"remark.rippled", {}}});

  // The place where the outlines are furthest apart, unless a named part already covers it.
  const double worst = 2.0 * m.common_firm * m.target.height;
  double named = 0.0;
  for (const Ranked& r : found) named = std::max(named, r.rank);
  if (worst / size > 2.0 * named && mm(worst) > 0)
    found.push_back(
        {worst / size,
         {m.common_firm_sign > 0.0 ? "remark.wide" : "remark.narrow",
          {{"mm", std::to_string(mm(worst))}, {"percent", percent_of_height(m.common_firm_at)}},
          Remark::Seen{m.common_firm_at, m.common_firm_at, worst / m.target.belly}}});
  for (Ranked& r : found) {
    const double cost = r.remark.key == "remark.not_round"     ? lost.round
                        : r.remark.key == "remark.wall_uneven" ? lost.wall
                                                               : 0.0;
    if (cost > lost.shape) r.rank = kBeforeShape + kBeforeShape * cost;
  }
  return best(std::move(found));
}

void take_back(std::vector<Remark>& alike, const Remark& largest) {
  const std::string part = part_of(largest.key);
  if (alike.size() > 1)
    std::erase_if(alike, [&part](const Remark& r) { return part_of(r.key) == part; });
}

std::vector<std::string> remark_keys() {
  std::vector<std::string> keys{"alike.outline",    "alike.belly",   "alike.mouth",
                                "alike.foot",       "alike.neck",    "alike.height",
                                "alike.wall",       "alike.start",   "remark.wall_uneven",
                                "remark.not_round", "remark.rippled"};
  for (const char* family : {"remark.", "difference."})
    for (const char* ending :
         {"belly_wide", "belly_narrow", "belly_high", "belly_low", "neck_wide", "neck_narrow",
          "mouth_wide", "mouth_narrow", "foot_wide", "foot_narrow", "opening_narrow",
          "opening_shut", "wide", "narrow", "tall", "short"})
      keys.push_back(std::string(family) + ending);
  for (std::string& key : part_keys()) keys.push_back(std::move(key));
  for (std::string& key : word_keys()) keys.push_back(std::move(key));
  return keys;
}

}  // namespace onggi::score
