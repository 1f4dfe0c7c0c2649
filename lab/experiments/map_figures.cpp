#include <algorithm>
#include <cmath>
#include <queue>

#include "experiments/figures.h"
#include "experiments/recipes.h"

namespace place_memory::experiments {
namespace {

MapFigure mapOf(const sim::World& world) {
  MapFigure figure;
  for (const sim::Place& place : world.places) {
    figure.places.emplace_back(place.label, place.position);
  }
  const auto neighbours = sim::placeNeighbours(world);
  for (std::size_t from = 0; from < neighbours.size(); ++from) {
    for (const std::size_t to : neighbours[from]) {
      if (from < to) figure.links.emplace_back(from, to);
    }
  }
  return figure;
}

/// Where dead reckoning puts the places of a robot that walks the links from the middle place, its
/// heading off by -drift in the west to +drift in the east.
void bend(const sim::World& world, double drift, MapFigure& figure) {
  const auto& places = world.places;
  const auto [west, east] =
      std::minmax_element(places.begin(), places.end(),
                          [](const auto& a, const auto& b) { return a.position.x < b.position.x; });
  const double middle = 0.5 * (west->position.x + east->position.x);
  const double half = 0.5 * (east->position.x - west->position.x);
  const auto first = static_cast<std::size_t>(
      std::min_element(places.begin(), places.end(),
                       [&](const auto& a, const auto& b) {
                         return std::abs(a.position.x - middle) < std::abs(b.position.x - middle);
                       }) -
      places.begin());
  const auto neighbours = sim::placeNeighbours(world);
  std::vector<bool> reached(places.size(), false);
  std::queue<std::size_t> queue({first});
  reached[first] = true;
  for (; !queue.empty(); queue.pop()) {
    const std::size_t from = queue.front();
    for (const std::size_t to : neighbours[from]) {
      if (reached[to]) continue;
      const sim::Vec2 step = places[to].position - places[from].position;
      const double error =
          drift * (0.5 * (places[to].position.x + places[from].position.x) - middle) / half;
      const core::Pose2d turned = core::Pose2d{0.0, 0.0, error} * core::Pose2d{step.x, step.y, 0.0};
      figure.places[to].second = figure.places[from].second + sim::Vec2{turned.x, turned.y};
      reached[to] = true;
      queue.push(to);
    }
  }
}

}  // namespace

std::vector<MapFigure> mapFigures(const ShippedWorlds& worlds) {
  MapFigure office = mapOf(worlds.office);
  office.name = "figure_4";
  office.caption = "Map of the office of experiment 3: 47 places and their links";
  MapFigure hallway = mapOf(worlds.hallway);
  hallway.name = "figure_6";
  hallway.caption =
      "Map of the hallway of experiment 4 by dead reckoning, 30 degrees off at its ends: the "
      "hallway is straight";
  bend(worlds.hallway, hallwayRecipe(0.0).drift, hallway);
  return {office, hallway};
}

}  // namespace place_memory::experiments
