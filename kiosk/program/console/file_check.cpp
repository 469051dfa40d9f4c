#include "kiosk/program/console/file_check.h"

#include <chrono>
#include <utility>

#include "kiosk/ground/files/helper_process.h"
#include "kiosk/ground/files/json.h"
#include "kiosk/program/watch/last_good.h"

namespace onggi::console {

namespace {

constexpr std::size_t kMostOfAReport = 4u << 20;
constexpr double kPatience = 300.0;  // s of work: a hundred scans

}  // namespace

FileCheck::FileCheck(std::filesystem::path onggi, std::filesystem::path exhibit)
    : onggi_(std::move(onggi)), exhibit_(std::move(exhibit)) {}

FileCheck::Answer FileCheck::ask(const std::filesystem::path& onggi,
                                 const std::filesystem::path& exhibit) {
  files::Helper helper;
  helper.program = onggi.string();
  helper.arguments = {"check", "--json", "-", "--config", exhibit.string()};
  helper.timeout_s = kPatience;
  helper.most_bytes = kMostOfAReport;
  helper.answer = "check";
  helper.also_good = 2;  // with problems in the files
  const auto said = files::run_helper(helper);
  if (!said) return {"", to_text(said.error())};
  return {{reinterpret_cast<const char*>(said->data()), said->size()}, ""};
}

std::string FileCheck::stamps() const {
  // A disk that refuses is told by the check itself.
  return watch::files_of(exhibit_.parent_path().parent_path()).value_or("unreadable");
}

std::string FileCheck::json() {
  if (coming_.valid() && coming_.wait_for(std::chrono::seconds(0)) == std::future_status::ready)
    answer_ = coming_.get();
  if (!coming_.valid())
    if (std::string now = stamps(); now != checked_) {
      checked_ = std::move(now);
      coming_ = std::async(std::launch::async, ask, onggi_, exhibit_);
    }
  const std::string report = answer_.report.empty() ? "null" : answer_.report;
  return "{\"checking\": " + std::string(coming_.valid() ? "true" : "false") +
         ", \"trouble\": " + files::Json(answer_.trouble).text(-1) + ", \"report\": " + report +
         "}";
}

}  // namespace onggi::console
