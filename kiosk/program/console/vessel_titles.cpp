#include "kiosk/program/console/vessel_titles.h"

#include <algorithm>
#include <cctype>
#include <system_error>

#include "kiosk/collection/content/pack.h"

namespace onggi::console {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostKept = 1000;  // vessels; a shelf has 500

/// Of Latin letters alone; other scripts are compared as they are.
std::string small_letters(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace

const VesselTitles::Titles& VesselTitles::of(const std::string& id) {
  static const Titles kNone;
  if (id.empty() || id.find('/') != std::string::npos || id.starts_with('.')) return kNone;
  const fs::path file = site_.exhibit().shelf / id / "vessel.toml";
  std::error_code gone;
  const auto at = fs::last_write_time(file, gone);
  if (gone) return kNone;
  const auto known = read_.find(id);
  if (known != read_.end() && known->second.at == at) return known->second.titles;
  if (read_.size() > kMostKept) read_.clear();
  Read& read = read_[id] = {at, {}};
  for (const auto& [language, label] : content::read_pack(file).pack.labels)
    if (!label.title.empty()) read.titles[language] = label.title;
  return read.titles;
}

files::Json VesselTitles::json_of(const std::string& id) {
  files::Json json = files::Json::object();
  for (const auto& [language, title] : of(id)) json[language] = title;
  return json;
}

bool VesselTitles::has(const std::string& id, const std::string& words) {
  const std::string wanted = small_letters(words);
  return std::ranges::any_of(of(id), [&](const auto& one) {
    return small_letters(one.second).find(wanted) != std::string::npos;
  });
}

}  // namespace onggi::console
