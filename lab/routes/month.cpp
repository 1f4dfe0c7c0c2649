#include "routes/month.h"

#include <algorithm>
#include <random>

namespace place_memory::routes {
namespace {

constexpr int kDays = 30;
constexpr int kErrandsADay = 40;
constexpr double kCarried = 600.0;  // [s]
constexpr double kEnoughTraversals = 20.0;

constexpr int kSpellBegins = 10;  // [days]
constexpr int kSpellEnds = 20;

double timeOf(const DoorWorld& world, const Way& way) {
  double time = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) {
    time += world.passages()[world.passageBetween(way[i - 1], way[i])].time;
  }
  return time;
}

// The passage that most of the shortest ways of some days use, of those that can be driven around.
std::size_t busiestPassage(const DoorWorld& world, std::uint64_t seed) {
  std::vector<std::size_t> uses(world.passages().size(), 0);
  OracleMind mind(world, OracleMind::Knows::kTimesAlone);
  for (int day = 0; day < 3; ++day) {
    for (const Errand& errand : errandsOf(world, seed, day)) {
      const Way way = *mind.plan(errand.from, errand.to, {}, 0.0);
      for (std::size_t i = 1; i < way.size(); ++i) {
        ++uses[world.passageBetween(way[i - 1], way[i])];
      }
    }
  }
  std::size_t busiest = 0;
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const Passage& passage = world.passages()[i];
    const Steps both{{passage.one, passage.other}, {passage.other, passage.one}};
    if (uses[i] > uses[busiest] && mind.plan(passage.one, passage.other, both, 0.0)) busiest = i;
  }
  return busiest;
}

}  // namespace

void drive(const DoorWorld& world, const Errand& errand, RouteMind& mind, Errands& sum,
           const std::function<void(std::size_t, double)>& passed) {
  double time = errand.begin;
  std::size_t at = errand.from;
  Steps avoided;
  while (at != errand.to) {
    const std::optional<Way> way = mind.plan(at, errand.to, avoided, time);
    if (!way) {
      ++sum.not_reached;
      sum.time += time - errand.begin + kCarried;
      return;
    }
    for (std::size_t i = 1; i < way->size(); ++i) {
      const std::size_t to = (*way)[i];
      const std::size_t passage = world.passageBetween(at, to);
      const bool is_open = world.isOpen(passage, time);
      const double begin = time;
      time += is_open ? world.timeThrough(passage, time) : world.timeLost(passage, time);
      mind.notice(at, to, begin, time, is_open);
      if (!is_open) {
        avoided.emplace_back(at, to);
        ++sum.blocked;
        break;
      }
      if (passed) passed(passage, time);
      at = to;
    }
  }
  ++sum.reached;
  sum.time += time - errand.begin;
}

std::vector<Errand> errandsOf(const DoorWorld& world, std::uint64_t seed, int day) {
  std::mt19937_64 random(seed * 1000 + static_cast<std::uint64_t>(day));
  std::uniform_int_distribution<std::size_t> place(0, world.places() - 1);
  std::vector<Errand> errands;
  const double pause = (kWorkEnds - kWorkBegins) / kErrandsADay;
  while (errands.size() < kErrandsADay) {
    Errand errand;
    errand.from = place(random);
    errand.to = place(random);
    errand.begin = day * kDay + kWorkBegins + pause * static_cast<double>(errands.size());
    if (errand.from != errand.to) errands.push_back(errand);
  }
  return errands;
}

MonthResult runMonth(std::uint64_t seed, const core::LinkLearningOptions& options) {
  const DoorWorld world(seed, true);
  LearningMind learning(world, options);
  OracleMind odds(world, OracleMind::Knows::kOdds);
  OracleMind doors(world, OracleMind::Knows::kEveryDoor);
  OracleMind times(world, OracleMind::Knows::kTimesAlone);
  MonthResult result;
  Errands before;  // enough was learned
  for (int day = 0; day < kDays; ++day) {
    for (const Errand& errand : errandsOf(world, seed, day)) {
      if (learning.traversalsALink() < kEnoughTraversals) {
        drive(world, errand, learning, before);
        result.learned_after = errand.begin / kDay;
        continue;
      }
      drive(world, errand, learning, result.learning);
      drive(world, errand, odds, result.odds);
      drive(world, errand, doors, result.doors);
      drive(world, errand, times, result.times);
    }
  }
  return result;
}

std::optional<double> daysToReturn(std::uint64_t seed, const core::LinkLearningOptions& options) {
  DoorWorld world(seed, true);
  const std::size_t passage = busiestPassage(world, seed);
  Door spell;
  spell.kind = Door::Kind::kSpell;
  spell.from = kSpellBegins * kDay;
  spell.until = kSpellEnds * kDay + kWorkBegins;
  world.setDoor(passage, spell);
  LearningMind mind(world, options);
  Errands sum;
  std::optional<double> returned;
  for (int day = 0; day < kDays && !returned; ++day) {
    for (const Errand& errand : errandsOf(world, seed, day)) {
      drive(world, errand, mind, sum, [&](std::size_t through, double time) {
        if (through == passage && time > spell.until && !returned) {
          returned = (time - spell.until) / kDay;
        }
      });
    }
  }
  return returned;
}

Detours detours(std::uint64_t seed, const core::LinkLearningOptions& options) {
  const DoorWorld world(seed, false);
  LearningMind mind(world, options);
  OracleMind oracle(world, OracleMind::Knows::kTimesAlone);
  Detours detours;
  Errands sum;
  std::size_t count = 0;
  for (int day = 0; day < kDays; ++day) {
    for (const Errand& errand : errandsOf(world, seed, day)) {
      if (mind.traversalsALink() >= kEnoughTraversals) {
        const double chosen = timeOf(world, *mind.plan(errand.from, errand.to, {}, errand.begin));
        const double least = timeOf(world, *oracle.plan(errand.from, errand.to, {}, errand.begin));
        detours.worst = std::max(detours.worst, chosen / least - 1.0);
        detours.mean += chosen / least - 1.0;
        ++count;
      }
      drive(world, errand, mind, sum);
    }
  }
  detours.mean /= static_cast<double>(std::max<std::size_t>(count, 1));
  return detours;
}

}  // namespace place_memory::routes
