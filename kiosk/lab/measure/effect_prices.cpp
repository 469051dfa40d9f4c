#include "kiosk/lab/measure/effect_prices.h"

#include <malloc.h>
#include <time.h>

#include <algorithm>

#include "engine/scene/scene.h"
#include "engine/script/script.h"

extern "C" [[gnu::noinline]] void onggi_priced_ticks(onggi::Scene& scene, onggi::Script& script,
                                                     double from) {
  for (int n = 0; n < onggi::measure::kPricedTicks; ++n)
    scene.step(script.at(from + 0.001 * n, scene.clay()), 0.001);
}

namespace onggi::measure {

namespace {

constexpr const char* kScript = "pull_tall";
constexpr double kInContact = 6.0;  // s: the first pull is halfway up
constexpr int kResting = 3000;      // ticks after the script; the last third counts

std::int64_t heap_bytes() {
  const struct mallinfo2 heap = mallinfo2();
  return static_cast<std::int64_t>(heap.uordblks + heap.hblkhd);
}

double rank(std::vector<double>& ns, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(ns.size() - 1));
  std::nth_element(ns.begin(), ns.begin() + at, ns.end());
  return ns[static_cast<std::size_t>(at)];
}

double thread_ns() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

// In the thread's own time, without other work of the machine and without the clock's own cost.
template <class Work>
double timed(Work&& work) {
  const double start = thread_ns();
  work();
  return thread_ns() - start;
}

// The result of timed() for no work.
double clock_ns() {
  std::vector<double> ns;
  for (int n = 0; n < 2000; ++n) ns.push_back(timed([] {}));
  return rank(ns, 0.5);
}

}  // namespace

std::vector<PricedScene> priced_scenes(int rows, int sectors) {
  SceneDef base;
  base.clay.rows = rows;
  base.clay.sectors = sectors;
  each_effect(base, [](auto& effect) { effect.reset(); });
  std::vector<PricedScene> scenes{{"base", base}};
  PricedScene all{"all", base};
  each_effect(all.def, [&]<class Def>(std::optional<Def>& effect) {
    effect.emplace();
    PricedScene one{std::string("+ ") + Def::kName, base};
    each_effect(one.def, []<class One>(std::optional<One>& other) {
      if constexpr (std::is_same_v<One, Def>) other.emplace();
    });
    if (one.def.prints) {
      one.def.beating.emplace();
      one.name += " (and beating)";
    }
    if ((one.def.slump || one.def.building || one.def.beating) && !one.def.volume) {
      one.def.volume.emplace();
      one.name += " (and volume)";
    }
    scenes.push_back(std::move(one));
  });
  scenes.push_back(std::move(all));
  return scenes;
}

Result<EffectPrice> price_of(const PricedScene& priced, int passes) {
  EffectPrice price;
  price.name = priced.name;
  const double clock = clock_ns();
  std::vector<double> least;
  std::vector<bool> pressing;
  int ticks = 0;
  for (int pass = 0; pass < passes; ++pass) {
    auto script = make_script(kScript, {.scene = priced.def});
    if (!script) return tl::unexpected(script.error());
    const std::int64_t before = heap_bytes();
    auto scene = Scene::create(priced.def);
    if (!scene) return tl::unexpected(scene.error());
    if (pass == 0) {
      price.bytes = heap_bytes() - before;
      ticks = static_cast<int>((*script)->duration() * 1000.0);
      least.assign(static_cast<std::size_t>(ticks + kResting), 1e300);
      pressing.assign(least.size(), false);
    }
    for (std::size_t n = 0; n < least.size(); ++n) {
      const Hands hands = (*script)->at(0.001 * static_cast<double>(n), scene->clay());
      Feedback felt;
      const double ns = timed([&] { felt = scene->step(hands, 0.001); }) - clock;
      least[n] = std::min(least[n], std::max(ns, 0.0));
      pressing[n] = felt.hand[0].contact || felt.hand[1].contact;
    }
  }
  std::vector<double> pressed, resting;
  for (std::size_t n = 0; n < least.size(); ++n) {
    if (pressing[n]) pressed.push_back(least[n]);
    if (static_cast<int>(n) > ticks + kResting * 2 / 3) resting.push_back(least[n]);
  }
  if (pressed.size() < 1000)
    return problem(priced.name, "The scripted hands hardly touched the clay.",
                   "Choose a grid of at least 8 rows and a lump with a wall.", 1);
  price.median_ns = rank(pressed, 0.5);
  price.p999_ns = rank(pressed, 0.999);
  price.asleep_ns = rank(resting, 0.5);
  return price;
}

Result<void> play_priced_ticks(const PricedScene& priced) {
  auto script = make_script(kScript, {.scene = priced.def});
  if (!script) return tl::unexpected(script.error());
  auto scene = Scene::create(priced.def);
  if (!scene) return tl::unexpected(scene.error());
  // Under valgrind play fewer ticks, and count the last ones.
  double t = 0.0;
  for (; t < kInContact - 0.1; t += 0.005) scene->step((*script)->at(t, scene->clay()), 0.005);
  for (; t < kInContact; t += 0.001) scene->step((*script)->at(t, scene->clay()), 0.001);
  onggi_priced_ticks(*scene, **script, t);
  return {};
}

}  // namespace onggi::measure
