#include "sim/world/world.h"

#include <algorithm>
#include <map>

namespace place_memory::sim {

namespace {

template <typename T>
T* findNamed(std::vector<T>& items, const std::string& name) {
  const auto it =
      std::find_if(items.begin(), items.end(), [&](const T& item) { return item.name == name; });
  return it == items.end() ? nullptr : &*it;
}

}  // namespace

Door* findDoor(World& world, const std::string& name) { return findNamed(world.doors, name); }

Chair* findChair(World& world, const std::string& name) { return findNamed(world.chairs, name); }

const Place* findPlace(const World& world, const std::string& label) {
  const auto it = std::find_if(world.places.begin(), world.places.end(),
                               [&](const Place& place) { return place.label == label; });
  return it == world.places.end() ? nullptr : &*it;
}

std::vector<std::vector<std::size_t>> placeNeighbours(const World& world) {
  std::map<std::string, std::size_t> index;
  for (std::size_t i = 0; i < world.places.size(); ++i) index[world.places[i].label] = i;
  std::vector<std::vector<std::size_t>> neighbours(world.places.size());
  const auto add = [&](std::size_t from, std::size_t to) {
    auto& list = neighbours[from];
    if (std::find(list.begin(), list.end(), to) == list.end()) list.push_back(to);
  };
  for (std::size_t i = 0; i < world.places.size(); ++i) {
    for (const std::string& label : world.places[i].links) {
      const auto it = index.find(label);
      if (it == index.end() || it->second == i) continue;
      add(i, it->second);
      add(it->second, i);
    }
  }
  return neighbours;
}

}  // namespace place_memory::sim
