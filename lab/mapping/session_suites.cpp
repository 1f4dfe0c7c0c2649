// Later sessions: in the same building, in others, on damaged maps, and very long ones.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "mapping/join_offset.h"
#include "mapping/mapping_figures.h"
#include "mapping/mapping_worlds.h"
#include "mapping/suites.h"
#include "sim/world/random.h"

namespace place_memory::mapping {
namespace {

using core::Pose2d;
using experiments::fixed;

/// The drive as odometry that starts elsewhere has it.
trials::Drive startedElsewhere(trials::Drive moments, const Pose2d& start) {
  for (trials::DriveMoment& moment : moments) moment.odom = start * moment.odom;
  return moments;
}

trials::Drive driveOf(const SuiteOptions& options, const sim::World& world, std::uint64_t seed,
                      std::size_t start) {
  trials::DriveRecipe recipe = recipeOf(options);
  recipe.start = start % world.places.size();
  return trials::simulateDrive(world, {}, recipe, seed);
}

DrivePart partOf(const SuiteOptions& options, double start) {
  DrivePart part;
  part.compass = options.compass;
  part.start = start;
  return part;
}

/// Ties of places with scans that are nowhere near, as many as `share` of all.
std::size_t addFalseTies(core::KeptMap& map, double share, std::uint64_t seed) {
  sim::Rng rng(seed);
  const std::size_t count = map.ties.size();
  const auto wanted = static_cast<std::size_t>(share * static_cast<double>(count));
  std::vector<core::NodeIndex> places;
  for (core::NodeIndex at = 0; at < map.nodes.size(); ++at) {
    if (map.nodes[at].place != core::kNoPlace) places.push_back(at);
  }
  for (std::size_t added = 0; added < wanted;) {
    core::Tie tie = map.ties[sim::uniformIndex(rng, count)];
    tie.place = places[sim::uniformIndex(rng, places.size())];
    tie.node = sim::uniformIndex(rng, map.nodes.size());
    const Pose2d& place = map.nodes[tie.place].pose;
    const Pose2d& node = map.nodes[tie.node].pose;
    if (tie.node == tie.place || std::hypot(place.x - node.x, place.y - node.y) < 2.0) continue;
    tie.relative = {sim::uniform(rng, -1.0, 1.0), sim::uniform(rng, -1.0, 1.0),
                    sim::uniform(rng, -0.5, 0.5)};
    map.ties.push_back(tie);
    ++added;
  }
  return wanted;
}

}  // namespace

experiments::Table sessionSuite(const SuiteOptions& options) {
  experiments::Table table({"map", "second session", "joined", "offset", "wrong", "of"});
  for (std::size_t w = 0; w < options.names.size(); ++w) {
    for (int i = 0; i < options.seeds; ++i) {
      const std::uint64_t seed = options.first_seed + static_cast<std::uint64_t>(i);
      const std::string& other = options.names[(w + 1) % options.names.size()];
      const sim::World own = mappingWorld(options.names[w], seed, options.worlds);
      const sim::World strange = mappingWorld(other, seed + 500, options.worlds);
      for (const bool foreign : {false, true}) {
        core::Mapper mapper(mapperOptions());
        Truth truth;
        drive(mapper, driveOf(options, own, seed, 0), partOf(options, 1000.0), truth);
        mapper.beginSession();
        const trials::Drive later = startedElsewhere(
            foreign ? driveOf(options, strange, seed + 1, 3) : driveOf(options, own, seed + 1, 5),
            {3.0, -7.0, 2.0});
        const MappingRun run = drive(mapper, later, partOf(options, 100000.0), truth);
        const double offset = joinOffset(mapper, run, truth);
        const bool joined = mapper.mapFromOdom().has_value();
        const MappingFigures found = figures(mapper, run, truth);
        table.add({options.names[w] + " " + std::to_string(seed),
                   foreign ? other + " " + std::to_string(seed + 500) : "the same",
                   joined ? "yes" : "no", offset < 0.0 || foreign ? "" : fixed(offset, 3),
                   std::to_string(found.wrong), std::to_string(found.answers)});
      }
    }
  }
  return table;
}

experiments::Table linkSuite(const SuiteOptions& options) {
  constexpr int kVisits = 20;
  experiments::Table table({"world", "links", "false ones put in", "left after 20 visits", "left",
                            "final before", "final after"});
  for (const std::string& name : options.names) {
    for (int i = 0; i < options.seeds; ++i) {
      const std::uint64_t seed = options.first_seed + static_cast<std::uint64_t>(i);
      const trials::Drive moments =
          driveOf(options, mappingWorld(name, seed, options.worlds), seed, 0);
      Truth truth;
      DrivePart part = partOf(options, 1000.0);
      part.last = moments.size() / 2;
      core::Mapper first(mapperOptions());
      drive(first, moments, part, truth);
      part.first = part.last;
      part.last = moments.size();
      core::KeptMap damaged = first.map();
      const std::size_t put = addFalseTies(damaged, 0.1, seed);
      const std::size_t links = damaged.ties.size();
      first.beginSession();
      Truth other = truth;
      const double before = figures(first, drive(first, moments, part, other), other).final;
      core::Mapper later(mapperOptions());
      later.restore(damaged);
      int visits = 0;
      std::size_t left = put;
      MappingRun run;
      for (std::size_t at = part.first; at < moments.size(); ++at) {
        DrivePart one = part;
        one.first = at;
        one.last = at + 1;
        MappingRun step = drive(later, moments, one, truth);
        run.moments.push_back(step.moments.front());
        for (const DecisionRecord& record : step.decisions) {
          visits += record.decision.kind == core::ScanDecision::Kind::kTracked ? 1 : 0;
        }
        if (visits == kVisits) left = figures(later, step, truth).false_ties;
      }
      const MappingFigures found = figures(later, run, truth);
      table.add({name + " " + std::to_string(seed), std::to_string(links), std::to_string(put),
                 std::to_string(left), std::to_string(found.false_ties), fixed(before, 3),
                 fixed(found.final, 3)});
    }
  }
  return table;
}

experiments::Table soakSuite(const SuiteOptions& options) {
  constexpr int kParts = 8;
  experiments::Table table({"world", "way", "places", "nodes", "ties", "median", "99 %", "wrong",
                            "false ties", "ms by m"});
  for (const std::string& name : options.names) {
    trials::DriveRecipe recipe = recipeOf(options);
    recipe.way = 10.0 * options.way;
    recipe.change_every = 0.5 * options.way;
    const trials::Drive moments = trials::simulateDrive(
        mappingWorld(name, options.first_seed, options.worlds), {}, recipe, options.first_seed);
    core::Mapper mapper(mapperOptions());
    Truth truth;
    DrivePart part = partOf(options, 1000.0);
    double way = 0.0;
    for (int k = 0; k < kParts; ++k) {
      part.first = moments.size() * static_cast<std::size_t>(k) / kParts;
      part.last = moments.size() * static_cast<std::size_t>(k + 1) / kParts;
      const MappingRun run = drive(mapper, moments, part, truth);
      const MappingFigures found = figures(mapper, run, truth);
      way += run.way();
      table.add({name, fixed(way, 0), std::to_string(found.places),
                 std::to_string(mapper.graph().nodes().size()),
                 std::to_string(mapper.graph().ties().size()), fixed(found.median(), 3),
                 fixed(found.p99(), 3), std::to_string(found.wrong),
                 std::to_string(found.false_ties), fixed(found.cpu, 1)});
    }
  }
  return table;
}

}  // namespace place_memory::mapping
