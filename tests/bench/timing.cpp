#include "tests/bench/timing.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace onggi::bench {

Times times_of(std::vector<double>& ns) {
  std::ranges::sort(ns);
  const auto at = [&](double share) {
    const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(ns.size())));
    return ns[std::max<std::size_t>(rank, 1) - 1];
  };
  return {at(0.5), at(0.99), at(0.999), ns.back()};
}

double clock_ns() {
  static const double median = [] {
    std::vector<double> ns(10001);
    for (double& each : ns) each = timed([] {});
    return times_of(ns).median;
  }();
  return median;
}

ScriptTimes measure_script(const TickScript& script, int rows, int sectors,
                           const Patience& patience) {
  auto made = Scene::create(script.scene(rows, sectors));
  if (!made) std::abort();
  Scene& scene = *made;
  ScriptTimes out;
  for (int n = 0; n < kHashTicks; ++n) scene.step(script.hands(n), kTickSeconds);
  out.hash = scene.state_hash();
  renew_clay(scene, script.wheel_speed);

  std::vector<double> wall;
  std::vector<double> cpu;
  double visited = 0;
  double touched = 0;
  double total = 0;
  const auto count = [&] { return static_cast<int>(wall.size()); };
  for (int n = 0;
       count() < patience.ticks || (count() < patience.most && total < 1e9 * patience.seconds);) {
    if (n == script.pass()) {
      renew_clay(scene, script.wheel_speed);
      n = 0;
    }
    const SceneCounters before = scene.counters();
    const Hands hands = script.hands(n++);
    const double cpu_before = thread_ns();
    wall.push_back(timed([&] { scene.step(hands, kTickSeconds); }));
    cpu.push_back(thread_ns() - cpu_before);
    const SceneCounters& after = scene.counters();
    visited += static_cast<double>(after.visited_elements - before.visited_elements);
    touched += static_cast<double>(after.touched_elements - before.touched_elements);
    total += wall.back();
  }
  out.visited = visited / count();
  out.touched = touched / count();
  out.wall = times_of(wall);
  out.cpu = times_of(cpu);
  return out;
}

std::vector<double> medians_in_turns(const std::vector<Work*>& works, int pass, int ticks,
                                     int batch) {
  std::vector<std::vector<double>> ns(works.size());
  int n = pass;  // so that it begins fresh
  for (int done = 0; done < ticks; done += batch, n += batch) {
    if (n + batch > pass) {
      for (Work* work : works) work->freshen();
      n = 0;
    }
    for (std::size_t w = 0; w < works.size(); ++w) {
      // The first to go changes with the batch.
      const std::size_t k = (w + static_cast<std::size_t>(done / batch)) % works.size();
      for (int m = n; m < n + batch; ++m) ns[k].push_back(timed([&] { works[k]->tick(m); }));
    }
  }
  std::vector<double> medians;
  for (std::vector<double>& each : ns) medians.push_back(times_of(each).median - clock_ns());
  return medians;
}

}  // namespace onggi::bench
