#include "routes/door_world.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

namespace place_memory::routes {
namespace {

constexpr std::size_t kSide = 7;       // places along a side
constexpr double kSpacing = 4.0;       // [m]
constexpr double kSpeed = 0.3;         // [m/s]
constexpr double kShareOfLinks = 0.8;  // of neighbours between which there is no wall
constexpr double kShareOfDoors = 0.2;
constexpr double kPatience = 5.0;  // before a closed door [s]

std::uint64_t mixed(std::uint64_t bits) {  // splitmix64
  bits += 0x9e3779b97f4a7c15U;
  bits = (bits ^ bits >> 30U) * 0xbf58476d1ce4e5b9U;
  bits = (bits ^ bits >> 27U) * 0x94d049bb133111ebU;
  return bits ^ bits >> 31U;
}

double secondOfDay(double time) { return time - kDay * std::floor(time / kDay); }

/// Which places hang together.
class Groups {
 public:
  explicit Groups(std::size_t size) : of_(size) {
    for (std::size_t i = 0; i < size; ++i) of_[i] = i;
  }
  std::size_t of(std::size_t i) const { return of_[i] == i ? i : of(of_[i]); }
  bool join(std::size_t i, std::size_t j) {
    const std::size_t one = of(i), other = of(j);
    of_[one] = other;
    return one != other;
  }

 private:
  std::vector<std::size_t> of_;
};

}  // namespace

DoorWorld::DoorWorld(std::uint64_t seed, bool with_doors) : seed_(seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (std::size_t i = 0; i < kSide * kSide; ++i) {
    xs_.push_back(kSpacing * (static_cast<double>(i % kSide) + 0.6 * share(random)));
    ys_.push_back(kSpacing * (static_cast<double>(i / kSide) + 0.6 * share(random)));
  }
  std::vector<std::pair<std::size_t, std::size_t>> neighbours;
  for (std::size_t i = 0; i < xs_.size(); ++i) {
    if (i % kSide + 1 < kSide) neighbours.emplace_back(i, i + 1);
    if (i + kSide < xs_.size()) neighbours.emplace_back(i, i + kSide);
  }
  std::shuffle(neighbours.begin(), neighbours.end(), random);
  Groups groups(xs_.size());
  for (const auto& [one, other] : neighbours) {
    const bool joins = groups.join(one, other);
    if (!joins && share(random) > kShareOfLinks) continue;
    const double way = std::hypot(xs_[one] - xs_[other], ys_[one] - ys_[other]);
    Passage passage{one, other, way / kSpeed * (0.9 + 0.2 * share(random)), {}};
    const double kind = share(random), begin = share(random), length = share(random);
    if (with_doors && kind < 0.5 * kShareOfDoors) {
      passage.door.kind = Door::Kind::kRhythm;
      passage.door.opens = kWorkBegins + 4.0 * 3600.0 * begin;
      passage.door.closes = passage.door.opens + 3600.0 * (2.0 + 6.0 * length);
    } else if (with_doors && kind < kShareOfDoors) {
      passage.door.kind = Door::Kind::kRandom;
      passage.door.share = 0.2 + 0.7 * begin;
    }
    passages_.push_back(passage);
  }
}

std::size_t DoorWorld::passageBetween(std::size_t one, std::size_t other) const {
  for (std::size_t i = 0; i < passages_.size(); ++i) {
    const Passage& passage = passages_[i];
    if ((passage.one == one && passage.other == other) ||
        (passage.one == other && passage.other == one)) {
      return i;
    }
  }
  throw std::out_of_range("no passage there");
}

double DoorWorld::chance(std::size_t passage, std::int64_t moment, std::uint64_t of) const {
  const std::uint64_t bits =
      mixed(seed_ ^ mixed(passage ^ mixed(static_cast<std::uint64_t>(moment) ^ mixed(of))));
  return static_cast<double>(bits >> 11U) * 0x1p-53;
}

bool DoorWorld::isOpen(std::size_t passage, double time) const {
  const Door& door = passages_[passage].door;
  switch (door.kind) {
    case Door::Kind::kRhythm:
      return secondOfDay(time) >= door.opens && secondOfDay(time) < door.closes;
    case Door::Kind::kRandom:
      return chance(passage, std::llround(std::floor(time / 3600.0)), 1) < door.share;
    case Door::Kind::kSpell:
      return time < door.from || time >= door.until;
    case Door::Kind::kNone:
      break;
  }
  return true;
}

double DoorWorld::share(std::size_t passage) const {
  const Door& door = passages_[passage].door;
  if (door.kind == Door::Kind::kRhythm) {
    return (std::min(door.closes, kWorkEnds) - door.opens) / (kWorkEnds - kWorkBegins);
  }
  return door.kind == Door::Kind::kRandom ? door.share : 1.0;
}

double DoorWorld::timeThrough(std::size_t passage, double time) const {
  return passages_[passage].time * (0.95 + 0.1 * chance(passage, std::llround(time), 2));
}

double DoorWorld::timeLost(std::size_t passage, double time) const {
  return timeThrough(passage, time) + kPatience;
}

core::PlaceMap DoorWorld::learnedMap() const {
  std::vector<core::Place> places;
  for (std::size_t i = 0; i < xs_.size(); ++i) {
    core::Place place;
    place.id = static_cast<core::PlaceId>(i + 1);
    place.label = "place " + std::to_string(place.id);
    place.map_from_place = {xs_[i], ys_[i], 0.0};
    places.push_back(place);
  }
  std::vector<core::PlaceLink> links;
  for (const Passage& passage : passages_) {
    core::PlaceLink link;
    link.first = static_cast<core::PlaceId>(passage.one + 1);
    link.second = static_cast<core::PlaceId>(passage.other + 1);
    link.first_from_second = {xs_[passage.other] - xs_[passage.one],
                              ys_[passage.other] - ys_[passage.one], 0.0};
    for (core::LinkDirection* direction : {&link.forward, &link.backward}) {
      direction->succeeded = 1;
      direction->through = 1.0;
      direction->last = std::chrono::nanoseconds(1);
    }
    links.push_back(link);
  }
  return {places, links, 0, std::chrono::nanoseconds(0)};
}

}  // namespace place_memory::routes
