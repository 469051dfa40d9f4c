#include "kiosk/program/console/onggi_process.h"

#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>

#include "kiosk/ground/files/helper_process.h"
#include "kiosk/ground/files/json.h"

namespace onggi::console {

namespace {

constexpr double kWorkPatience = 300.0;  // s of work: a hundred scans
constexpr int kRefused = 2;
constexpr std::size_t kMostOfAnAnswer = 16u << 20;  // sixty vessels of a scan take one MiB

}  // namespace

struct OnggiProcess::Shared {
  std::mutex mutex;  // guards:
  std::optional<std::string> said;
};

bool OnggiProcess::begin(std::vector<std::string> arguments) {
  if (shared_) return false;
  shared_ = std::make_shared<Shared>();
  std::thread([shared = shared_, program = onggi_.string(), words = std::move(arguments)] {
    files::Helper helper;
    helper.program = program;
    helper.arguments = words;
    helper.timeout_s = kWorkPatience;
    helper.answer = "report";
    helper.most_bytes = kMostOfAnAnswer;
    helper.also_good = kRefused;
    const auto printed = files::run_helper(helper);
    std::string said;
    if (printed) said.assign(reinterpret_cast<const char*>(printed->data()), printed->size());
    if (!nlohmann::json::parse(said, nullptr, false).is_object())
      said = files::Json::object(
                 {{"done", false},
                  {"what", printed ? "It could not be done." : printed.error().what},
                  {"remedy", printed ? "Try again, and look at Files." : printed.error().remedy}})
                 .text(-1);
    const std::lock_guard lock(shared->mutex);
    shared->said = std::move(said);
  }).detach();
  return true;
}

bool OnggiProcess::under_way() const {
  if (!shared_) return false;
  const std::lock_guard lock(shared_->mutex);
  return !shared_->said;
}

std::optional<std::string> OnggiProcess::take() {
  if (!shared_ || under_way()) return std::nullopt;
  const std::optional<std::string> said = std::move(shared_->said);
  shared_.reset();
  return said;
}

}  // namespace onggi::console
