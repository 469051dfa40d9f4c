#include "engine/lab/recommend.h"

#include <algorithm>
#include <numeric>

namespace onggi::lab {

std::vector<SettingSummary> summaries(const std::vector<AccuracyRow>& rows) {
  std::vector<SettingSummary> all;
  for (const AccuracyRow& row : rows) {
    auto at = std::ranges::find_if(
        all, [&](const SettingSummary& one) { return one.setting == row.setting; });
    if (at == all.end()) {
      all.emplace_back().setting = row.setting;
      at = all.end() - 1;
    }
    const auto most = [](double& a, double b) { a = std::max(a, b); };
    most(at->p50, row.p50);
    most(at->p999, row.p999);
    most(at->worst, row.worst);
    most(at->errors.shape_rms, row.errors.shape_rms);
    most(at->errors.shape_max, row.errors.shape_max);
    most(at->errors.force_rms, row.errors.force_rms);
    most(at->errors.volume, row.errors.volume);
    if (row.true_force > 0.0) most(at->force_share, row.errors.force_rms / row.true_force);
    ++at->scripts;
  }
  return all;
}

std::vector<std::size_t> pareto_edge(const std::vector<SettingSummary>& all) {
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
    return all[a].p999 != all[b].p999 ? all[a].p999 < all[b].p999
                                      : all[a].errors.shape_rms < all[b].errors.shape_rms;
  });
  std::vector<std::size_t> edge;
  for (const std::size_t n : order)
    if (edge.empty() || all[n].errors.shape_rms < all[edge.back()].errors.shape_rms)
      edge.push_back(n);
  return edge;
}

std::optional<Recommendation> recommend(const std::vector<SettingSummary>& all, double rate_hz,
                                        const HumanThresholds& thresholds) {
  std::vector<SettingSummary> grids;
  for (const SettingSummary& one : all)
    if (one.setting.model == AccuracySetting::Model::shipped && one.setting.substeps == 1 &&
        one.setting.rate_hz == rate_hz)
      grids.push_back(one);
  if (grids.empty()) return std::nullopt;
  const int most = std::ranges::max(grids, {}, &SettingSummary::scripts).scripts;
  std::erase_if(grids, [most](const SettingSummary& one) { return one.scripts < most; });
  std::ranges::sort(grids, {}, [](const SettingSummary& one) { return one.setting.rows; });
  const auto in_time = [](const SettingSummary& one) { return one.share() <= kTickBudget; };
  const auto fine_enough = [&](const SettingSummary& one) {
    return one.errors.shape_rms <= thresholds.device && one.errors.shape_max <= thresholds.wall &&
           one.force_share <= thresholds.force;
  };
  // Coarsest first: apart from noise, the first that is fine enough is also the quickest.
  auto chosen = std::ranges::find_if(
      grids, [&](const SettingSummary& one) { return fine_enough(one) && in_time(one); });
  if (chosen == grids.end()) {
    chosen =
        std::ranges::min_element(grids, {}, [](const SettingSummary& one) { return one.p999; });
    for (auto one = grids.begin(); one != grids.end(); ++one)
      if (in_time(*one) && (!in_time(*chosen) || one->errors.shape_rms < chosen->errors.shape_rms))
        chosen = one;
  }
  Recommendation out;
  out.chosen = *chosen;
  if (chosen + 1 != grids.end()) out.finer = *(chosen + 1);
  out.fine_enough = fine_enough(*chosen);
  out.in_time = in_time(*chosen);
  return out;
}

}  // namespace onggi::lab
