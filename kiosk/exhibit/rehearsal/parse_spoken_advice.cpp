#include "kiosk/exhibit/rehearsal/parse_spoken_advice.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>
#include <vector>

namespace onggi::rehearsal {

namespace {

constexpr std::array<const char*, device::kWallParts> kParts{"foot", "low", "middle",
                                                             "high", "rim", "all"};
constexpr std::array<const char*, device::kAsks> kAsks{"open", "widen", "narrow", "pull", "even"};

/// The number in place of {mm} or {percent} in `text`.
std::optional<int> figure_in(const std::string& text, const content::Language& language,
                             const std::string& key, const std::string& place) {
  constexpr const char* kMark = "\x01";
  const std::string words = language.say(key, {{place, kMark}});
  const auto mark = words.find(kMark);
  const std::string before = words.substr(0, mark), after = words.substr(mark + 1);
  for (std::size_t at = text.find_first_of("0123456789"); at != std::string::npos;
       at = text.find_first_of("0123456789", at)) {
    const std::size_t end = text.find_first_not_of("0123456789", at);
    const bool fits = at >= before.size() &&
                      text.compare(at - before.size(), before.size(), before) == 0 &&
                      end != std::string::npos && text.compare(end, after.size(), after) == 0;
    if (fits) return std::atoi(text.c_str() + at);
    if (end == std::string::npos) break;
    at = end;
  }
  return std::nullopt;
}

}  // namespace

std::string name_of_part(device::WallPart part, const content::Language& language) {
  return language.say(std::string("stroke.") + kParts[static_cast<std::size_t>(part)]);
}
std::string name_of_ask(device::Ask ask, const content::Language& language) {
  return language.say(std::string("stroke.") + kAsks[static_cast<std::size_t>(ask)]);
}

std::optional<AdvisedStroke> stroke_advised(const std::string& text,
                                            const content::Language& language) {
  for (int part = 0; part < device::kWallParts; ++part)
    for (int ask = 0; ask < device::kAsks; ++ask) {
      const AdvisedStroke one{static_cast<device::WallPart>(part), static_cast<device::Ask>(ask)};
      const std::string words = language.say(
          "stroke.try",
          {{"what", name_of_ask(one.ask, language)}, {"where", name_of_part(one.part, language)}});
      if (text.find(words) != std::string::npos) return one;
    }
  return std::nullopt;
}

std::optional<ToldDifference> understand(const std::string& text,
                                         const content::Language& language) {
  std::vector<std::pair<std::size_t, ToldDifference>> all;
  constexpr const char* kMark = "\x01";
  for (int n = 0; n + 1 < device::kWallParts; ++n) {
    const auto part = static_cast<device::WallPart>(n);
    const std::string whole =
        language.say("stroke.differs", {{"where", name_of_part(part, language)}, {"how", kMark}});
    const std::string begin = whole.substr(0, whole.find(kMark));
    const std::size_t at = text.find(begin);
    if (at == std::string::npos) continue;
    const std::size_t from = at + begin.size();
    const std::string how = text.substr(from, text.find_first_of(".。", from) - from) + ".";
    for (const bool wide : {true, false})
      for (const bool mm : {true, false}) {
        const std::string key =
            std::string("off.") + (wide ? "wide" : "narrow") + (mm ? "" : "_part");
        if (const auto by = figure_in(how, language, key, mm ? "mm" : "percent"))
          all.push_back({at, {part, wide, *by}});
      }
  }
  if (all.empty()) return std::nullopt;
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  ToldDifference worst = all.front().second;
  for (std::size_t n = 1; n < all.size(); ++n)
    worst.all_so =
        worst.all_so || (all[n].second.wide == worst.wide && 2 * all[n].second.by >= worst.by);
  return worst;
}

}  // namespace onggi::rehearsal
