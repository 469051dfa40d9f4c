#include "kiosk/program/console/file_check.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>

#include "kiosk/ground/files/file_stamps.h"
#include "kiosk/ground/files/helper_process.h"
#include "kiosk/ground/files/json.h"
#include "kiosk/program/watch/last_good.h"

namespace onggi::console {

namespace {

constexpr std::size_t kMostOfAReport = 4u << 20;
constexpr double kPatience = 300.0;  // s of work: a hundred scans
// s between two checks of files whose list cannot be read, so that nobody sees when one changes
constexpr double kUnseen = 60.0;

}  // namespace

struct FileCheck::Shared {
  struct Checked {
    std::string report, trouble;
    std::optional<std::size_t> problems{};
  };

  static Checked check(const std::filesystem::path& onggi, const std::filesystem::path& exhibit) {
    files::Helper helper;
    helper.program = onggi.string();
    helper.arguments = {"check", "--json", "-", "--config", exhibit.string()};
    helper.timeout_s = kPatience;
    helper.most_bytes = kMostOfAReport;
    helper.answer = "check";
    helper.also_good = 2;  // with problems in the files
    const auto said = files::run_helper(helper);
    if (!said) return {"", to_text(said.error())};
    Checked checked{{reinterpret_cast<const char*>(said->data()), said->size()}, ""};
    // Where it has nothing to check, it prints no report.
    const auto report = nlohmann::json::parse(checked.report, nullptr, false);
    if (!report.is_object() || !report.contains("problems") || !report["problems"].is_array())
      return {"", "The exhibit's own file cannot be checked: " + exhibit.string() +
                      ". Is it there, and may this program's user read it?"};
    checked.problems = report["problems"].size();
    return checked;
  }

  std::filesystem::path onggi, exhibit;
  std::mutex mutex;  // guards the members below
  std::condition_variable wake;
  bool asked = false, ends = false, checking = true;  // true: the first one
  Checked checked;

  void ask() { asked = true, wake.notify_one(); }
  void look_and_check() {
    using Clock = std::chrono::steady_clock;
    std::string known;
    Clock::time_point checked_at{};
    std::unique_lock lock(mutex);
    for (;;) {
      wake.wait(lock, [this] { return asked || ends; });
      if (ends) return;
      asked = false;
      lock.unlock();
      const auto began = Clock::now();
      auto list = watch::files_of(exhibit.parent_path().parent_path());
      const bool unseen =
          !list && std::chrono::duration<double>(began - checked_at).count() > kUnseen;
      // Its own file is seen to change even so.
      const std::string now =
          list ? *list : to_text(list.error()) + files::stamp_of(exhibit).value_or("");
      const std::chrono::duration<double> took = Clock::now() - began;
      lock.lock();
      if (now != known || unseen) {
        checking = true;
        lock.unlock();
        Checked anew = check(onggi, exhibit);
        lock.lock();
        checked = std::move(anew);
        known = now;
        checked_at = Clock::now();
      }
      checking = false;
      const std::chrono::duration<double> pause(std::clamp(10.0 * took.count(), kEvery, kUnseen));
      wake.wait_for(lock, pause, [this] { return ends; });
      if (ends) return;
    }
  }
};

FileCheck::FileCheck(std::filesystem::path onggi, std::filesystem::path exhibit)
    : shared_(std::make_shared<Shared>()) {
  shared_->onggi = std::move(onggi);
  shared_->exhibit = std::move(exhibit);
  std::thread([shared = shared_] { shared->look_and_check(); }).detach();
}

FileCheck::~FileCheck() {
  if (!shared_) return;
  const std::lock_guard lock(shared_->mutex);
  shared_->ends = true;
  shared_->wake.notify_one();
}

std::optional<std::size_t> FileCheck::problems() {
  const std::lock_guard lock(shared_->mutex);
  shared_->ask();
  return shared_->checked.problems;
}

std::string FileCheck::json() {
  const std::lock_guard lock(shared_->mutex);
  shared_->ask();
  const Shared::Checked& checked = shared_->checked;
  const std::string report = checked.report.empty() ? "null" : checked.report;
  return "{\"checking\": " + std::string(shared_->checking ? "true" : "false") +
         ", \"trouble\": " + files::Json(checked.trouble).text(-1) + ", \"report\": " + report +
         "}";
}

}  // namespace onggi::console
