#include "routes/explore_account.h"

#include <algorithm>

namespace place_memory::routes {
namespace {

constexpr double kShows = 0.5;  // a task that shows less was in vain [m^2]

void add(const TickOfTask& task, double way, double area, ExploreAccount& account) {
  switch (task.aim) {
    case core::Explorer::Aim::kLoop:
      account.loops += way;
      return;
    case core::Explorer::Aim::kHome:
      account.home += way;
      return;
    case core::Explorer::Aim::kFrontier:
      break;
  }
  const bool is_in_vain = area < kShows;
  ++account.tasks;
  if (is_in_vain) ++account.in_vain;
  (is_in_vain ? account.fruitless : account.fruitful) += way;
}

}  // namespace

ExploreAccount accountOf(const std::vector<TickOfTask>& ticks, const std::vector<double>& seen,
                         double floor_area) {
  ExploreAccount account;
  if (ticks.empty()) return account;
  double way = 0.0, share = 0.0;
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const bool is_last = i + 1 == ticks.size() || ticks[i + 1].task != ticks[i].task;
    if (!is_last) continue;
    if (ticks[i].task > 0) {
      add(ticks[i], ticks[i].way - way, (seen[i] - share) * floor_area, account);
    }
    way = ticks[i].way;
    share = seen[i];
  }
  const auto enough = std::lower_bound(seen.begin(), seen.end(), ExploreAccount::kEnough);
  account.enough =
      enough == seen.end() ? way : ticks[static_cast<std::size_t>(enough - seen.begin())].way;
  return account;
}

}  // namespace place_memory::routes
