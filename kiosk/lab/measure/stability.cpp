#include "kiosk/lab/measure/stability.h"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <map>
#include <mutex>
#include <sstream>
#include <thread>

#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/monotonic.h"
#include "kiosk/ground/files/read_file.h"

namespace onggi::measure {

namespace {

constexpr double kKeepEvery = 10.0;          // s
constexpr std::uint64_t kShrinkTicks = 2e6;  // at most, to reduce one finding
constexpr std::size_t kLongestProgress = 1u << 20;
constexpr const char* kHead =
    "onggi stability, trials of kind 1";  // another generator has another kind

std::atomic<bool> stop_asked{false};
static_assert(std::atomic<bool>::is_always_lock_free);
void ask_to_stop(int) { stop_asked = true; }

// While it lives, SIGINT and SIGTERM request a stop, so that the results are kept.
class StopOnSignal {
 public:
  StopOnSignal() {
    stop_asked = false;
    struct sigaction action {};
    action.sa_handler = ask_to_stop;
    sigaction(SIGINT, &action, &before_[0]);
    sigaction(SIGTERM, &action, &before_[1]);
  }
  ~StopOnSignal() {
    sigaction(SIGINT, &before_[0], nullptr);
    sigaction(SIGTERM, &before_[1], nullptr);
  }
  StopOnSignal(const StopOnSignal&) = delete;
  StopOnSignal& operator=(const StopOnSignal&) = delete;

 private:
  struct sigaction before_[2]{};
};

lab::Trial trial_of(std::uint64_t seed, std::uint64_t number) {
  Random random(seed ^ number * 0x9e3779b97f4a7c15ULL);
  lab::TrialPlan plan;
  plan.ticks = kTrialTicks;
  return lab::random_trial(random.bits(), plan);
}

// Shared by all threads.
class Night {
 public:
  Night(const StabilityPlan& plan, StabilityTally tally)
      : plan_(plan), tally_(std::move(tally)), next_(tally_.trials) {}

  void work() {
    for (std::uint64_t number = 0; take(number);)
      if (!run(number)) return;
  }
  // False if a stop was requested before the end of the trial.
  bool run(std::uint64_t number) {
    const lab::Trial trial = trial_of(plan_.seed, number);
    const lab::TrialChecks checks{.twice = true, .give_up = [] { return stop_asked.load(); }};
    const lab::TrialResult result = lab::run_trial(trial, checks);
    if (stop_asked && !result.breach) return false;
    if (result.breach) found(number, trial, *result.breach, checks);
    done(number, result.ticks);
    return true;
  }

  // A copy of the current state.
  StabilityTally tally() {
    const std::lock_guard lock(mutex_);
    return tally_;
  }
  std::uint64_t ticks() {
    const std::lock_guard lock(mutex_);
    return ticks_ + tally_.ticks;
  }
  bool over() {
    const std::lock_guard lock(mutex_);
    return is_over();
  }
  const std::string& trouble() const { return trouble_; }

 private:
  bool is_over() const {
    return stop_asked || static_cast<double>(tally_.ticks + ticks_) >= plan_.ticks ||
           tally_.finds.size() >= kMostFinds || !trouble_.empty();
  }
  bool take(std::uint64_t& number) {
    const std::lock_guard lock(mutex_);
    if (is_over()) return false;
    number = next_++;
    return true;
  }
  // Trials end in any order; the tally counts those before the first unfinished one.
  void done(std::uint64_t number, std::uint64_t ticks) {
    const std::lock_guard lock(mutex_);
    waiting_[number] = ticks;
    ticks_ += ticks;
    for (auto at = waiting_.begin(); at != waiting_.end() && at->first == tally_.trials;
         at = waiting_.erase(at)) {
      ++tally_.trials;
      tally_.ticks += at->second;
      ticks_ -= at->second;
    }
  }
  void found(std::uint64_t number, const lab::Trial& trial, const lab::Breach& breach,
             const lab::TrialChecks& checks) {
    const lab::Shrunk least = lab::least_of(trial, breach, checks, kShrinkTicks);
    const auto file =
        plan_.folder / (std::to_string(plan_.seed) + "_" + std::to_string(number) + ".onggi");
    const auto kept = files::write_durably(file, lab::replay_of(least.trial, least.breach.tick));
    const std::lock_guard lock(mutex_);
    if (!kept) trouble_ = to_text(kept.error());
    tally_.finds.push_back(
        {number, lab::name_of(breach.invariant), least.breach.what, file.string()});
  }

  const StabilityPlan& plan_;
  std::mutex mutex_;
  StabilityTally tally_;
  std::uint64_t next_;
  std::uint64_t ticks_ = 0;                         // of those in waiting_
  std::map<std::uint64_t, std::uint64_t> waiting_;  // done, but an earlier one is not
  std::string trouble_;
};

std::filesystem::path progress_of(const StabilityPlan& plan) {
  return plan.folder / ("seed_" + std::to_string(plan.seed) + ".txt");
}

Result<void> keep(const StabilityPlan& plan, const StabilityTally& tally) {
  const std::string text = text_of(tally);
  if (auto good = files::make_folder(plan.folder); !good) return good;
  return files::write_durably(progress_of(plan), std::as_bytes(std::span(text)));
}

tl::unexpected<Problem> not_kept(const StabilityPlan& plan, const Night& night) {
  return problem(plan.folder.string(), "A replay could not be kept: " + night.trouble(),
                 "Choose another folder: --out DIR.", 1);
}

void tell(std::FILE* told, const StabilityPlan& plan, std::uint64_t ticks, std::size_t finds,
          double pace) {
  const double left = std::max(plan.ticks - static_cast<double>(ticks), 0.0);
  std::fprintf(told, "%.3g of %.3g ticks, %.2f million a second, %zu found, %.0f min left\n",
               static_cast<double>(ticks), plan.ticks, pace * 1e-6, finds,
               pace > 0.0 ? left / pace / 60.0 : 0.0);
  std::fflush(told);
}

}  // namespace

std::string text_of(const StabilityTally& tally) {
  std::ostringstream text;
  text << kHead << "\nseed " << tally.seed << "\ntrials " << tally.trials << "\nticks "
       << tally.ticks << '\n';
  for (const StabilityFind& find : tally.finds)
    text << "found " << find.trial << '\n'
         << find.invariant << '\n'
         << find.what << '\n'
         << find.replay << '\n';
  return text.str();
}

Result<StabilityTally> read_tally(const std::string& text, const std::string& name) {
  const auto wrong = [&](const char* what) {
    return problem(name, what, "Remove the file to start again, or choose another --seed.");
  };
  std::istringstream lines(text);
  std::string line;
  if (!std::getline(lines, line) || line != kHead)
    return wrong("It is not a progress file of this program.");
  StabilityTally tally;
  std::string seed, trials, ticks;
  if (!(lines >> seed >> tally.seed >> trials >> tally.trials >> ticks >> tally.ticks) ||
      seed != "seed" || trials != "trials" || ticks != "ticks")
    return wrong("Its counts are inconsistent.");
  StabilityFind find;
  for (std::string word; lines >> word;) {
    if (word != "found" || !(lines >> find.trial) || !std::getline(lines, line) ||
        !std::getline(lines, find.invariant) || !std::getline(lines, find.what) ||
        !std::getline(lines, find.replay))
      return wrong("Its findings are inconsistent.");
    tally.finds.push_back(find);
  }
  return tally;
}

Result<StabilityTally> measure_stability(const StabilityPlan& plan, std::FILE* told) {
  StabilityTally tally;
  tally.seed = plan.seed;
  const auto file = progress_of(plan);
  if (std::filesystem::exists(file)) {
    const auto read = files::read_file(file, kLongestProgress);
    if (!read)
      return problem(file.string(), "Its progress cannot be read. " + read.error().reason,
                     "Remove it to start again, or choose another --seed.");
    const auto kept = read_tally(
        std::string(reinterpret_cast<const char*>(read->data()), read->size()), file.string());
    if (!kept) return tl::unexpected(kept.error());
    if (kept->seed != plan.seed)
      return problem(file.string(), "The file belongs to another seed.",
                     "Give it the name of its seed again, or remove it.");
    tally = *kept;
    std::fprintf(told, "Continues from trial %llu, %.3g ticks.\n",
                 static_cast<unsigned long long>(tally.trials), static_cast<double>(tally.ticks));
  }
  if (auto good = keep(plan, tally); !good) return tl::unexpected(good.error());

  const StopOnSignal signals;
  Night night(plan, tally);
  const std::uint64_t before = tally.ticks;
  const double begun = files::monotonic_seconds();
  std::vector<std::thread> threads;
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  std::atomic<int> working = plan.threads > 0 ? plan.threads : cores;
  for (int n = working; n > 0; --n)
    threads.emplace_back([&] {
      night.work();
      --working;
    });
  Result<void> good;
  double next = begun + kKeepEvery;
  while (working > 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    if (const double now = files::monotonic_seconds(); now >= next && good) {
      const StabilityTally so_far = night.tally();
      const auto ticks = night.ticks();
      tell(told, plan, ticks, so_far.finds.size(),
           static_cast<double>(ticks - before) / (now - begun));
      good = keep(plan, so_far);
      if (!good) stop_asked = true;
      next = now + kKeepEvery;
    }
  }
  for (std::thread& thread : threads) thread.join();
  if (!good) return tl::unexpected(good.error());
  if (!night.trouble().empty()) return not_kept(plan, night);
  tally = night.tally();
  tally.interrupted = stop_asked;
  if (good = keep(plan, tally); !good) return tl::unexpected(good.error());
  return tally;
}

Result<StabilityTally> measure_trial(const StabilityPlan& plan, std::uint64_t number) {
  if (auto good = files::make_folder(plan.folder); !good) return tl::unexpected(good.error());
  StabilityTally tally;
  tally.seed = plan.seed;
  tally.trials = number;
  const StopOnSignal signals;
  Night night(plan, tally);
  const bool whole = night.run(number);
  if (!night.trouble().empty()) return not_kept(plan, night);
  tally = night.tally();
  tally.trials -= number;
  tally.interrupted = !whole;
  return tally;
}

Result<std::string> check_replay(const Replay& replay) {
  auto scene = Scene::create(replay.def);
  if (!scene) return tl::unexpected(scene.error());
  lab::InvariantChecker watch(*scene);
  for (const TickRecord& record : replay.ticks) {
    const Feedback felt = scene->step(record.hands, record.dt);
    if (const auto breach = watch.after(*scene, record.dt, felt))
      return problem("tick " + std::to_string(breach->tick),
                     std::string(lab::name_of(breach->invariant)) + ": " + breach->what,
                     "engine/docs/stability.md says what must hold.", 1);
  }
  if (const auto breach = watch.whole(*scene))
    return problem("the end", std::string(lab::name_of(breach->invariant)) + ": " + breach->what,
                   "engine/docs/stability.md says what must hold.", 1);
  return std::to_string(replay.ticks.size()) + " ticks; every check passed after each.";
}

files::Json json_of(const StabilityTally& tally) {
  using files::Json;
  Json finds = Json::list();
  for (const StabilityFind& find : tally.finds)
    finds.push_back(Json::object({{"trial", find.trial},
                                  {"invariant", find.invariant},
                                  {"what", find.what},
                                  {"replay", find.replay}}));
  return Json::object({{"seed", tally.seed},
                       {"trials", tally.trials},
                       {"ticks", tally.ticks},
                       {"interrupted", tally.interrupted},
                       {"found", finds}});
}

}  // namespace onggi::measure
