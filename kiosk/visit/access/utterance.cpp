#include "kiosk/visit/access/utterance.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace onggi::access {

std::string spoken(const screens::Control& control, const content::Language& language) {
  std::string all = control.words;
  const auto add = [&](const std::string& more) {
    if (!more.empty()) all += (all.empty() ? "" : ", ") + more;
  };
  if (control.on)
    add(language.say(*control.on ? "access.on" : "access.off"));
  else
    add(language.say("access.button"));
  add(control.note);
  return all;
}

std::string joined(const std::vector<std::string>& sentences) {
  constexpr std::array<std::string_view, 12> kEnds{".",  "!",  "?",  ":", "…", "。",
                                                   "！", "？", "：", "؟", ",", "»"};
  std::string all;
  for (const std::string& one : sentences) {
    if (one.empty()) continue;
    if (!all.empty()) all += ' ';
    all += one;
    if (std::none_of(kEnds.begin(), kEnds.end(),
                     [&](std::string_view end) { return one.ends_with(end); }))
      all += '.';
  }
  return all;
}

}  // namespace onggi::access
