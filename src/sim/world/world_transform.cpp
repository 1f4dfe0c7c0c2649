#include "sim/world/world_transform.h"

namespace place_memory::sim {

void transformWorld(World& world, const core::Pose2d& by) {
  const auto move = [&](Vec2& p) { p = Vec2{by.x, by.y} + rotated(p, by.yaw); };
  for (Wall& wall : world.walls) {
    for (Vec2& point : wall.points) move(point);
  }
  for (Post& post : world.posts) move(post.center);
  for (Box& box : world.boxes) box.pose = by * box.pose;
  for (Table& table : world.tables) table.pose = by * table.pose;
  for (Door& door : world.doors) {
    move(door.hinge);
    move(door.latch);
  }
  for (Chair& chair : world.chairs) chair.pose = by * chair.pose;
  for (Bicycle& bicycle : world.bicycles) bicycle.pose = by * bicycle.pose;
  for (Whiteboard& board : world.whiteboards) {
    move(board.from);
    move(board.to);
  }
  for (Place& place : world.places) move(place.position);
}

}  // namespace place_memory::sim
