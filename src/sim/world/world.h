#ifndef PLACE_MEMORY_SIM_WORLD_WORLD_H
#define PLACE_MEMORY_SIM_WORLD_WORLD_H

#include <cstddef>
#include <string>
#include <vector>

#include "place_memory/core/pose2d.h"
#include "sim/world/material.h"
#include "sim/world/vec2.h"

namespace place_memory::sim {

/// Nothing lies further from the origin along either axis: a slip of the pen would ask for a huge
/// grid [m].
constexpr double kFarthest = 1000.0;

/// A polyline. Doors that lie along it cut their openings into it.
struct Wall {
  std::vector<Vec2> points;
  Material material;
};

/// A round thing that stands still: post, column, bin.
struct Post {
  Vec2 center;
  double radius = 0.1;  ///< [m]
  Material material;
};

/// A rectangle seen from all sides: desk, shelf, cabinet, partition.
struct Box {
  core::Pose2d pose;   ///< of its centre
  double width = 1.0;  ///< along its x axis [m]
  double depth = 0.5;  ///< along its y axis [m]
  Material material;
};

/// Four legs, too low or too thin a top to echo.
struct Table {
  core::Pose2d pose;
  double width = 1.2;
  double depth = 0.7;
};

struct Door {
  std::string name;
  Vec2 hinge;
  Vec2 latch;  ///< where the free edge rests when closed
  double swing =
      1.5;  ///< turn of the panel about the hinge from closed to open [rad], in [-pi, pi]
  bool open = false;
  Material material;
};

/// A swivel chair: seat and column, five feet on a star.
struct Chair {
  std::string name;
  core::Pose2d pose;
};

struct Bicycle {
  std::string name;
  core::Pose2d pose;  ///< of its middle, x axis along the frame
};

struct Whiteboard {
  std::string name;
  Vec2 from;
  Vec2 to;
};

/// Where a robot may stand and learn, in the world's frame.
struct Place {
  std::string label;
  Vec2 position;
  std::vector<std::string> links;  ///< labels of places that can be walked to in a straight line
};

/// Everything in a simulated environment but robots and people. x east, y north [m].
struct World {
  std::string name;
  std::vector<Wall> walls;
  std::vector<Post> posts;
  std::vector<Box> boxes;
  std::vector<Table> tables;
  std::vector<Door> doors;
  std::vector<Chair> chairs;
  std::vector<Bicycle> bicycles;
  std::vector<Whiteboard> whiteboards;
  std::vector<Place> places;
};

/// Null where the world has none of that name.
Door* findDoor(World& world, const std::string& name);
Chair* findChair(World& world, const std::string& name);
const Place* findPlace(const World& world, const std::string& label);

/// For each place, in order, the indices of the places linked with it in either direction.
std::vector<std::vector<std::size_t>> placeNeighbours(const World& world);

}  // namespace place_memory::sim

#endif  // PLACE_MEMORY_SIM_WORLD_WORLD_H
