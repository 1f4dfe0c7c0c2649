#include "place_memory/core/place_graph.h"

#include <stdexcept>

namespace place_memory::core {

const Place* PlaceGraph::find(PlaceId id) const {
  const auto found = nodes_.find(id);
  return found == nodes_.end() ? nullptr : &found->second.place;
}

const Place* PlaceGraph::find(const std::string& label) const {
  const auto found = id_of_label_.find(label);
  return found == id_of_label_.end() ? nullptr : find(found->second);
}

std::vector<Place> PlaceGraph::places() const {
  std::vector<Place> places;
  places.reserve(nodes_.size());
  for (const auto& [id, node] : nodes_) places.push_back(node.place);
  return places;
}

std::vector<PlaceLink> PlaceGraph::links() const {
  std::vector<PlaceLink> links;
  for (const auto& [id, node] : nodes_) {
    const auto first_above = node.neighbours.upper_bound(id);
    for (auto other = first_above; other != node.neighbours.end(); ++other) {
      links.push_back({id, *other});
    }
  }
  return links;
}

void PlaceGraph::add(const Place& place) {
  if (find(place.id) != nullptr) {
    throw std::invalid_argument("place " + std::to_string(place.id) + " is in the map already");
  }
  if (!id_of_label_.emplace(place.label, place.id).second) {
    throw std::invalid_argument("label \"" + place.label + "\" is in the map already");
  }
  nodes_[place.id].place = place;
}

void PlaceGraph::rename(PlaceId id, const std::string& label) {
  Place& place = node(id).place;
  if (place.label == label) return;
  if (!id_of_label_.emplace(label, id).second) {
    throw std::invalid_argument("label \"" + label + "\" is in the map already");
  }
  id_of_label_.erase(place.label);
  place.label = label;
}

void PlaceGraph::remove(PlaceId id) {
  const auto found = nodes_.find(id);
  if (found == nodes_.end()) return;
  for (const PlaceId other : found->second.neighbours) nodes_.at(other).neighbours.erase(id);
  id_of_label_.erase(found->second.place.label);
  nodes_.erase(found);
}

void PlaceGraph::link(PlaceId one, PlaceId other) {
  if (one == other) throw std::invalid_argument("a place is not linked to itself");
  Node& one_node = node(one);
  Node& other_node = node(other);
  one_node.neighbours.insert(other);
  other_node.neighbours.insert(one);
}

void PlaceGraph::clear() {
  nodes_.clear();
  id_of_label_.clear();
}

PlaceGraph::Node& PlaceGraph::node(PlaceId id) {
  const auto found = nodes_.find(id);
  if (found == nodes_.end()) {
    throw std::invalid_argument("there is no place " + std::to_string(id) + " in the map");
  }
  return found->second;
}

}  // namespace place_memory::core
