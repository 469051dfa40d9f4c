#include "kiosk/lab/measure/naive_table.h"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <functional>
#include <mutex>
#include <thread>

#include "kiosk/exhibit/tuning/machine.h"
#include "kiosk/lab/measure/middle.h"

namespace onggi::measure {

namespace {

NaiveLine line_of(const std::string& name, const std::vector<const HeadlessOutcome*>& visits,
                  std::size_t moment, double seconds) {
  NaiveLine line;
  line.vessel = name;
  line.seconds = seconds;
  line.visits = static_cast<int>(visits.size());
  const auto all = [&](const std::function<double(const PotLook&)>& of) {
    std::vector<double> values;
    for (const HeadlessOutcome* visit : visits) values.push_back(of(visit->looks[moment]));
    return values;
  };
  const std::vector<double> points = all([](const PotLook& look) { return look.points; });
  line.points = middle(points);
  line.least_points = *std::ranges::min_element(points);
  line.stars = middle(all([](const PotLook& look) { return look.stars; }));
  line.roughness = middle(all([](const PotLook& look) { return look.smooth.roughness; }));
  line.ledge = middle(all([](const PotLook& look) { return look.smooth.ledge; }));
  line.out_of_round = middle(all([](const PotLook& look) { return look.out_of_round; }));
  line.way_in = middle(all([](const PotLook& look) { return look.way_in; }));
  line.wall = middle(all([](const PotLook& look) { return look.wall; }));
  std::vector<double> when;
  for (const HeadlessOutcome* visit : visits) {
    line.five_stars += visit->looks[moment].stars >= 5 ? 1 : 0;
    if (visit->handsome_at && *visit->handsome_at <= seconds) when.push_back(*visit->handsome_at);
  }
  line.handsome = static_cast<int>(when.size());
  if (!when.empty()) line.handsome_at = middle(when);
  return line;
}

files::Json looks_json(const HeadlessOutcome& visit) {
  files::Json looks = files::Json::list();
  for (const PotLook& look : visit.looks)
    looks.push_back(files::Json::object({{"seconds", look.seconds},
                                         {"points", look.points},
                                         {"stars", look.stars},
                                         {"roughness", look.smooth.roughness},
                                         {"ledge", look.smooth.ledge},
                                         {"out_of_round", look.out_of_round},
                                         {"way_in", look.way_in},
                                         {"wall", look.wall}}));
  files::Json out = files::Json::object({{"vessel", visit.vessel},
                                         {"seed", static_cast<double>(visit.seed)},
                                         {"mishaps", visit.mishaps},
                                         {"looks", looks}});
  if (visit.handsome_at) out["handsome_at"] = *visit.handsome_at;
  return out;
}

}  // namespace

std::vector<NaiveLine> lines_of(const std::vector<HeadlessOutcome>& outcomes,
                                const std::vector<double>& moments) {
  std::vector<NaiveLine> lines;
  std::vector<std::string> names;
  for (const HeadlessOutcome& visit : outcomes)
    if (std::ranges::find(names, visit.vessel) == names.end()) names.push_back(visit.vessel);
  for (std::size_t m = 0; m < moments.size() && !outcomes.empty(); ++m) {
    std::vector<const HeadlessOutcome*> everyone;
    for (const HeadlessOutcome& visit : outcomes) everyone.push_back(&visit);
    for (const std::string& name : names) {
      std::vector<const HeadlessOutcome*> its;
      for (const HeadlessOutcome* visit : everyone)
        if (visit->vessel == name) its.push_back(visit);
      lines.push_back(line_of(name, its, m, moments[m]));
    }
    lines.push_back(line_of("all", everyone, m, moments[m]));
  }
  return lines;
}

Result<NaiveTable> measure_naive(const NaivePlan& plan, std::FILE* progress) {
  const auto opened = HeadlessVisits::open(plan.exhibit_file, plan.scene);
  if (!opened) return tl::unexpected(opened.error());
  const HeadlessVisits& visits = **opened;
  std::vector<int> cards;
  for (const std::string& vessel : plan.vessels) {
    const auto card = visits.card_of(vessel);
    if (!card) return tl::unexpected(card.error());
    cards.push_back(*card);
  }
  if (plan.vessels.empty())
    for (std::size_t n = 0; n < visits.cards().size(); ++n) cards.push_back(static_cast<int>(n));

  const auto seeds = static_cast<std::size_t>(plan.seeds);
  const std::size_t each = seeds + (plan.careful ? 1 : 0), count = cards.size() * each;
  std::vector<std::optional<Result<HeadlessOutcome>>> done(count);
  std::atomic<std::size_t> next{0};
  std::mutex telling;
  std::size_t told = 0;
  const auto work = [&] {
    for (std::size_t n = next++; n < count; n = next++) {
      const int card = cards[n / each];
      const std::size_t seed = n % each;
      done[n] = seed < seeds ? visits.naive(card, plan.first + seed, plan.pointer, plan.moments)
                             : visits.careful(card, plan.first);
      const std::scoped_lock lock(telling);
      if (progress != nullptr) std::fprintf(progress, "\r%zu of %zu visits", ++told, count);
    }
  };
  std::vector<std::thread> threads;
  for (int n = 1; n < plan.threads; ++n) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  if (progress != nullptr) std::fputc('\n', progress);

  NaiveTable table;
  table.scene = plan.scene.empty() ? "the exhibit's scenes"
                                   : std::filesystem::path(plan.scene).stem().string();
  table.machine = tuning::machine_name();
  table.plan = plan;
  for (std::size_t n = 0; n < count; ++n) {
    const Result<HeadlessOutcome>& one = *done[n];
    if (!one) return tl::unexpected(one.error());
    (n % each < seeds ? table.naive : table.careful).push_back(*one);
  }
  table.lines = lines_of(table.naive, plan.moments);
  return table;
}

files::Json json_of(const NaiveTable& table) {
  files::Json naive = files::Json::list(), careful = files::Json::list();
  for (const HeadlessOutcome& visit : table.naive) naive.push_back(looks_json(visit));
  for (const HeadlessOutcome& visit : table.careful) careful.push_back(looks_json(visit));
  return files::Json::object(
      {{"scene", table.scene},
       {"machine", table.machine},
       {"pointer",
        table.plan.pointer == rehearsal::NaiveHands::Pointer::finger ? "finger" : "mouse"},
       {"naive", naive},
       {"careful", careful}});
}

std::string text_of(const NaiveTable& table) {
  char line[200];
  std::snprintf(line, sizeof line, "naive hands, %s, %s, seeds %llu to %llu\n", table.scene.c_str(),
                table.plan.pointer == rehearsal::NaiveHands::Pointer::finger ? "finger" : "mouse",
                static_cast<unsigned long long>(table.plan.first),
                static_cast<unsigned long long>(table.plan.first) + table.plan.seeds - 1);
  std::string text = line;
  std::snprintf(line, sizeof line, "%5s %-22s %6s %6s %5s %6s %9s %9s %9s %7s %8s  %s\n", "s",
                "vessel", "points", "least", "stars", "of 5", "rough mm", "ledge mm", "round mm",
                "way in", "wall mm", "handsome after");
  text += line;
  for (const NaiveLine& one : table.lines) {
    std::snprintf(line, sizeof line,
                  "%5.0f %-22s %6.1f %6.1f %5.1f %6d %9.2f %9.2f %9.2f %6.0f%% %8.1f  ",
                  one.seconds, one.vessel.c_str(), one.points, one.least_points, one.stars,
                  one.five_stars, 1e3 * one.roughness, 1e3 * one.ledge, 1e3 * one.out_of_round,
                  100 * one.way_in, 1e3 * one.wall);
    text += line;
    if (one.handsome_at)
      std::snprintf(line, sizeof line, "%.0f s (%d of %d)\n", *one.handsome_at, one.handsome,
                    one.visits);
    else
      std::snprintf(line, sizeof line, "never\n");
    text += line;
  }
  for (const HeadlessOutcome& one : table.careful) {
    const PotLook& look = one.looks.front();
    std::snprintf(line, sizeof line,
                  "%5.0f %-22s %6.1f %6s %5d %6s %9.2f %9.2f %9.2f %6.0f%% %8.1f  careful\n",
                  look.seconds, one.vessel.c_str(), look.points, "", look.stars, "",
                  1e3 * look.smooth.roughness, 1e3 * look.smooth.ledge, 1e3 * look.out_of_round,
                  100 * look.way_in, 1e3 * look.wall);
    text += line;
  }
  return text;
}

}  // namespace onggi::measure
