#ifndef PLACE_MEMORY_LAB_ROUTES_DOOR_WORLD_H
#define PLACE_MEMORY_LAB_ROUTES_DOOR_WORLD_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include "place_memory/core/place_map.h"

namespace place_memory::routes {

constexpr double kDay = 86400.0;  // [s]

/// The hours of a day in which robots drive [s].
constexpr double kWorkBegins = 8.0 * 3600.0;
constexpr double kWorkEnds = 20.0 * 3600.0;

/// How a link is closed at times.
struct Door {
  enum class Kind {
    kNone,    ///< never
    kRhythm,  ///< open from one hour of each day to another
    kRandom,  ///< open or closed for an hour at a time
    kSpell,   ///< closed from one time to another
  };
  Kind kind = Kind::kNone;
  double opens = 0.0;   ///< [s of the day]
  double closes = 0.0;  ///< [s of the day]
  double share = 1.0;   ///< of hours in which it is open
  double from = 0.0;    ///< of the spell [s]
  double until = 0.0;
};

/// A way between two places, alike in both directions.
struct Passage {
  std::size_t one = 0;
  std::size_t other = 0;
  double time = 0.0;  ///< that it takes on average [s]
  Door door;
};

/// Places of a floor and the passages between them, some with doors that open and close by
/// themselves: what happens depends on the seed and on the time alone.
class DoorWorld {
 public:
  /// Every fifth passage or so has a door, unless `with_doors` is false.
  DoorWorld(std::uint64_t seed, bool with_doors);

  std::size_t places() const { return xs_.size(); }
  const std::vector<Passage>& passages() const { return passages_; }
  void setDoor(std::size_t passage, const Door& door) { passages_[passage].door = door; }
  /// Index into passages().
  std::size_t passageBetween(std::size_t one, std::size_t other) const;

  bool isOpen(std::size_t passage, double time) const;
  /// Share of working hours in which it is open.
  double share(std::size_t passage) const;
  /// How long going along takes at that time [s], some percent more or less than on average.
  double timeThrough(std::size_t passage, double time) const;
  /// How long it takes to find it closed and to come back [s].
  double timeLost(std::size_t passage, double time) const;

  /// The map as a robot has it that was driven along every passage once, both ways, but knows of
  /// their length alone how long they take. Place i has the id i + 1.
  core::PlaceMap learnedMap() const;

 private:
  double chance(std::size_t passage, std::int64_t moment, std::uint64_t of) const;

  std::uint64_t seed_;
  std::vector<double> xs_, ys_;  ///< [m]
  std::vector<Passage> passages_;
};

}  // namespace place_memory::routes

#endif  // PLACE_MEMORY_LAB_ROUTES_DOOR_WORLD_H
