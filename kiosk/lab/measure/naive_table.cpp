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

}  // namespace onggi::measure
