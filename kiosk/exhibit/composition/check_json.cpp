#include "kiosk/exhibit/composition/check_json.h"

#include <charconv>
#include <optional>
#include <string>

namespace onggi::exhibit {
namespace {

using files::Json;

/// Takes ":12" from the end of `where`. Nothing if it does not end so.
std::optional<int> take_number(std::string& where) {
  const std::size_t colon = where.rfind(':');
  if (colon == std::string::npos || colon + 1 == where.size()) return std::nullopt;
  int number = 0;
  const char* const end = where.data() + where.size();
  const auto read = std::from_chars(where.data() + colon + 1, end, number);
  if (read.ec != std::errc() || read.ptr != end || number < 1) return std::nullopt;
  where.erase(colon);
  return number;
}

Json json_of_problem(const Problem& problem) {
  std::string file = problem.where;
  const std::optional<int> column = take_number(file),
                           line = column ? take_number(file) : std::nullopt;
  Json out = Json::object({{"file", line ? file : problem.where}});
  if (line) {
    out["line"] = *line;
    out["column"] = *column;
  }
  out["what"] = problem.what;
  out["remedy"] = problem.remedy;
  return out;
}

Json json_of_problems(const std::vector<Problem>& problems) {
  Json out = Json::list();
  for (const Problem& problem : problems) out.push_back(json_of_problem(problem));
  return out;
}

}  // namespace

Json json_of(const CheckReport& report) {
  Json files = Json::list();
  for (const auto& file : report.files) files.push_back(file.string());
  return Json::object({{"good", report.problems.empty()},
                       {"summary", report.summary()},
                       {"keys", report.keys},
                       {"vessels", report.vessels},
                       {"languages", report.languages},
                       {"problems", json_of_problems(report.problems)},
                       {"notes", json_of_problems(report.notes)},
                       {"files", files}});
}

}  // namespace onggi::exhibit
