#include "kiosk/program/console/change_on_trial.h"

#include <nlohmann/json.hpp>
#include <span>
#include <system_error>
#include <utility>

#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/json.h"
#include "kiosk/ground/files/read_file.h"

namespace onggi::console {

namespace {
constexpr std::size_t kLongestTrial = 8192;  // bytes
}

ChangeOnTrial::ChangeOnTrial(std::filesystem::path file) : file_(std::move(file)) {
  const auto bytes = files::read_file(file_, kLongestTrial);
  if (!bytes) return;
  const auto kept =
      nlohmann::json::parse(std::string(bytes->begin(), bytes->end()), nullptr, false);
  if (!kept.is_object() || !kept.contains("revision") || !kept["revision"].is_string() ||
      !kept.contains("until") || !kept["until"].is_number_integer() || !kept.contains("what") ||
      !kept["what"].is_string())
    return;
  now_ = {kept["revision"].get<std::string>(), kept["until"].get<std::int64_t>(),
          kept["what"].get<std::string>()};
}

Result<void> ChangeOnTrial::set(Tried tried) {
  const std::string text =
      files::Json::object(
          {{"revision", tried.revision}, {"until", tried.until}, {"what", tried.what}})
          .text(-1) +
      "\n";
  if (auto put = files::write_durably(file_, std::as_bytes(std::span(text))); !put) {
    end();
    return put;
  }
  now_ = std::move(tried);
  return {};
}

void ChangeOnTrial::end() {
  now_.reset();
  std::error_code gone;
  std::filesystem::remove(file_, gone);
}

}  // namespace onggi::console
