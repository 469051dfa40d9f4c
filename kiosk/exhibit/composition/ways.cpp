#include "kiosk/exhibit/composition/ways.h"

#include <algorithm>
#include <utility>

#include "engine/base/nearest_name.h"
#include "kiosk/ground/toml/toml_reader.h"

namespace fs = std::filesystem;

namespace onggi::exhibit {

namespace {

bool among(const std::vector<std::string>& all, const std::string& id) {
  return std::ranges::find(all, id) != all.end();
}

std::string remedy(const std::string& id, const std::vector<std::string>& all) {
  const std::string nearest = nearest_name(id, all);
  return (nearest.empty() ? "" : "Did you mean \"" + nearest + "\"? ") + "Choose one of " +
         joined(all) + ".";
}

}  // namespace

WaysRead read_ways(const fs::path& folder) {
  WaysRead read;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".toml") read.files.push_back(entry.path());
  std::ranges::sort(read.files);
  for (const fs::path& file : read.files) {
    decoration::WayRead one = decoration::read_way(file, {});
    read.keys_checked += one.keys_checked;
    if (one.problems.empty()) read.ways.emplace(one.way.id, std::move(one.way));
    std::ranges::move(one.problems, std::back_inserter(read.problems));
  }
  return read;
}

Problem no_ways(const fs::path& exhibit, const fs::path& folder) {
  const std::string what = "This folder of ways is empty: it has no file *.toml.",
                    remedy = "Copy content/ways of the program into it, or write decorate = false.";
  toml::TomlReader reader(exhibit);
  auto root = reader.root();
  if (!root.has("ways")) return {folder.string(), what, remedy};
  const auto before = reader.problems();
  root.complain("ways", what, remedy);
  return reader.problems_since(before).front();
}

WayFound find_way(const std::map<std::string, decoration::Way>& ways, const std::string& id,
                  const std::string& vessel) {
  const bool names_one = !id.empty();
  if (const auto own = ways.find(names_one ? id : kUsualWay); own != ways.end())
    return {&own->second, std::nullopt};
  std::vector<std::string> all;
  for (const auto& [each, way] : ways) all.push_back(each);
  const auto usual = ways.find(kUsualWay);
  const bool is_usual = usual != ways.end();
  const std::string instead =
      is_usual ? std::string("It is decorated by \"") + kUsualWay + "\"." : "It stays plain.";
  if (names_one)
    return {is_usual ? &usual->second : nullptr,
            Problem{"the vessel " + vessel, "There is no good way \"" + id + "\". " + instead,
                    remedy(id, all)}};
  return {nullptr, Problem{"the vessel " + vessel,
                           std::string("It names no way, and there is no good \"") + kUsualWay +
                               "\". " + instead,
                           std::string("Put ") + kUsualWay +
                               ".toml back, or write way = \"ID\" in its "
                               "vessel.toml."}};
}

settings::Problems unknown_ways(const fs::path& shelf, const std::vector<std::string>& ids,
                                const std::vector<std::string>& ways,
                                const std::vector<std::string>& glazes) {
  settings::Problems problems;
  for (const std::string& id : ids) {
    const fs::path file = shelf / id / "vessel.toml";
    std::error_code ignored;
    if (!fs::is_regular_file(file, ignored)) continue;
    toml::TomlReader reader(file);
    const auto before = reader.problems();
    auto root = reader.root();
    std::string way;
    if (root.text("way", way) && !among(ways, way))
      root.complain("way", "There is no way \"" + way + "\".", remedy(way, ways));
    if (!root.has("way") && !among(ways, kUsualWay))
      root.complain("", std::string("It names no way, and there is no \"") + kUsualWay + "\".",
                    std::string("Put ") + kUsualWay + ".toml back, or write way = \"ID\".");
    std::vector<std::string> own;
    root.texts("glazes", own);
    for (std::size_t n = 0; n < own.size(); ++n)
      if (!among(glazes, own[n]))
        root.complain_at("glazes", n, "There is no glaze \"" + own[n] + "\".",
                         remedy(own[n], glazes));
      else if (std::find(own.begin(), own.begin() + static_cast<std::ptrdiff_t>(n), own[n]) !=
               own.begin() + static_cast<std::ptrdiff_t>(n))
        root.complain_at("glazes", n, "\"" + own[n] + "\" is named twice.", "Name it once.");
    std::ranges::copy(reader.problems_since(before), std::back_inserter(problems));
  }
  return problems;
}

}  // namespace onggi::exhibit
