#ifndef PLACE_MEMORY_LAB_ROUTES_ROUTE_MINDS_H
#define PLACE_MEMORY_LAB_ROUTES_ROUTE_MINDS_H

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "core/route/route_planner.h"
#include "routes/door_world.h"

namespace place_memory::routes {

using Way = std::vector<std::size_t>;  ///< places from start to goal
using Steps = std::vector<std::pair<std::size_t, std::size_t>>;

/// What chooses the ways of a simulated robot.
class RouteMind {
 public:
  RouteMind() = default;
  RouteMind(const RouteMind&) = delete;
  RouteMind& operator=(const RouteMind&) = delete;
  virtual ~RouteMind() = default;
  /// Without those steps; nothing where none leads there.
  virtual std::optional<Way> plan(std::size_t from, std::size_t to, const Steps& avoided,
                                  double time) = 0;
  /// The step was taken between those times [s], or tried.
  virtual void notice(std::size_t from, std::size_t to, double begin, double end,
                      bool succeeded) = 0;
};

/// Links that learn, and the planner of the package.
class LearningMind : public RouteMind {
 public:
  LearningMind(const DoorWorld& world, const core::LinkLearningOptions& options);

  std::optional<Way> plan(std::size_t from, std::size_t to, const Steps& avoided,
                          double time) override;
  void notice(std::size_t from, std::size_t to, double begin, double end, bool succeeded) override;
  /// Of all links and directions on average.
  double traversalsALink() const;

 private:
  core::LinkLearningOptions options_;
  core::PlaceMap map_;
  core::RoutePlanner planner_;
  std::size_t traversals_ = 0;
};

/// Knows how long every passage takes and how often it is open, or even whether it is now.
class OracleMind : public RouteMind {
 public:
  enum class Knows { kOdds, kEveryDoor, kTimesAlone };

  OracleMind(const DoorWorld& world, Knows knows) : world_(world), knows_(knows) {}

  std::optional<Way> plan(std::size_t from, std::size_t to, const Steps& avoided,
                          double time) override;
  void notice(std::size_t /*from*/, std::size_t /*to*/, double /*begin*/, double /*end*/,
              bool /*succeeded*/) override {}

 private:
  double cost(std::size_t passage, double time) const;

  const DoorWorld& world_;
  Knows knows_;
};

}  // namespace place_memory::routes

#endif  // PLACE_MEMORY_LAB_ROUTES_ROUTE_MINDS_H
