#include "kiosk/collection/settings/scene_words.h"

#include <sstream>

namespace onggi::settings {

std::string words_of_scene(const std::string& toml) {
  std::istringstream lines(toml);
  std::string line, words;
  while (std::getline(lines, line) && line.starts_with("#")) {
    line.erase(0, line.starts_with("# ") ? 2 : 1);
    words += (words.empty() ? "" : " ") + line;
  }
  std::string kept;
  for (std::size_t from = 0; from < words.size();) {
    const std::size_t stop = words.find(". ", from);
    const std::size_t to = stop == std::string::npos ? words.size() : stop + 2;
    const std::string sentence = words.substr(from, to - from);
    if (!sentence.starts_with("What each") && !sentence.starts_with("An effect is") &&
        !sentence.starts_with("The exhibit's") && !sentence.starts_with("These are the engine's") &&
        sentence.find(".md") == std::string::npos)
      kept += sentence;
    from = to;
  }
  while (!kept.empty() && kept.back() == ' ') kept.pop_back();
  return kept;
}

}  // namespace onggi::settings
