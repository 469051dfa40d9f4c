#include "kiosk/collection/score/in_words.h"

#include <array>
#include <utility>

namespace onggi::score {

namespace {

constexpr std::array<std::pair<const char*, const char*>, 4> kNamed{
    {{"belly", "belly"}, {"neck", "neck"}, {"mouth", "rim"}, {"foot", "foot"}}};

constexpr std::array<std::pair<const char*, const char*>, 7> kSayings{
    {{"alike.outline", "plain.outline"},
     {"belly_high", "plain.belly_lower"},
     {"belly_low", "plain.belly_higher"},
     {"tall", "plain.lower"},
     {"short", "plain.taller"},
     {"opening_narrow", "plain.opening"},
     {"wall_uneven", "plain.even"}}};

/// From here on it is the rim, at the wheel too.
constexpr double kRim = 0.93;

/// The place of a width at `height` of the vessel, where no part has a name.
const char* place_at(double height) {
  if (height < 0.1) return "foot";
  if (height > kRim) return "rim";
  if (height < 0.36) return "low";
  return height > 0.64 ? "high" : "middle";
}

}  // namespace

Remark in_words(const Remark& remark) {
  const std::string ending = remark.key.substr(remark.key.find('.') + 1);
  for (const auto& [known, saying] : kSayings)
    if (remark.key == known || ending == known) return {saying, {}, remark.seen};
  const bool wide = ending.ends_with("wide"), narrow = ending.ends_with("narrow");
  if (!remark.seen || (!wide && !narrow)) return remark;
  std::string place = place_at(remark.seen->wanted);
  for (const auto& [part, name] : kNamed)
    // A neck right below the lip is no neck to a visitor.
    if (ending.starts_with(part) && (name != std::string("neck") || place != "rim")) place = name;
  const std::string much = remark.seen->share >= kMuch ? "plain.much_" : "plain.";
  return {much + (wide ? "narrower" : "wider"), {{"place", place}}, remark.seen};
}

std::vector<std::string> word_keys() {
  std::vector<std::string> keys{"plain.much_wider", "plain.wider", "plain.much_narrower",
                                "plain.narrower"};
  for (const auto& saying : kSayings) keys.emplace_back(saying.second);
  return keys;
}

}  // namespace onggi::score
