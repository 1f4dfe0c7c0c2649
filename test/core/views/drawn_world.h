#ifndef PLACE_MEMORY_TEST_CORE_VIEWS_DRAWN_WORLD_H
#define PLACE_MEMORY_TEST_CORE_VIEWS_DRAWN_WORLD_H

#include <cmath>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "core/views/view_adviser.h"

namespace place_memory::core {

/// Rectangles that stop rays, places among them, and links as long as they are straight.
class DrawnWorld {
 public:
  static constexpr double kSpeed = 0.5;  ///< [m/s]
  static constexpr double kReach = 4.0;  ///< of what is seen from a place [m]

  void addBox(double left, double bottom, double right, double top) {
    boxes_.push_back({left, bottom, right, top});
  }
  /// Four walls, open nowhere.
  void addRoom(double left, double bottom, double right, double top) {
    constexpr double kThick = 0.3;
    addBox(left - kThick, bottom - kThick, right + kThick, bottom);
    addBox(left - kThick, top, right + kThick, top + kThick);
    addBox(left - kThick, bottom, left, top);
    addBox(right, bottom, right + kThick, top);
  }
  /// Linked to those.
  PlaceId addPlace(double x, double y, const std::vector<PlaceId>& links = {}) {
    const auto id = static_cast<PlaceId>(places_.size() + 1);
    places_[id] = {x, y, 0.0};
    for (const PlaceId other : links) {
      links_[id].push_back(other);
      links_[other].push_back(id);
    }
    return id;
  }

  const Pose2d& pose(PlaceId id) const { return places_.at(id); }
  const std::map<PlaceId, Pose2d>& places() const { return places_; }

  /// What is seen from there up to the first box; the axes along the world's. `half`: only of the
  /// bearings within a right angle of straight ahead.
  EvidenceGrid seenFrom(const Pose2d& spot, bool half = false) const {
    EvidenceGrid grid;
    const GridGeometry& geometry = grid.geometry();
    for (int degrees = 0; degrees < 360; ++degrees) {
      const double angle = kPi * degrees / 180.0;
      if (half && std::cos(angle - spot.yaw) < 0.0) continue;
      for (double way = 0.0; way < kReach; way += 0.06) {
        const double x = way * std::cos(angle), y = way * std::sin(angle);
        std::int8_t& cell = grid.cells()[static_cast<std::size_t>(kGridSize * geometry.index(y) +
                                                                  geometry.index(x))];
        if (isBoxed(spot.x + x, spot.y + y)) {
          cell = 100;
          break;
        }
        cell = std::min<std::int8_t>(cell, cell > 0 ? 100 : -60);
      }
    }
    return grid;
  }

  ViewAdviser::Grids grids() const {
    return [this](PlaceId id) { return std::make_shared<const EvidenceGrid>(seenFrom(pose(id))); };
  }

  /// By the fewest links.
  std::vector<ViewPoint> reached(PlaceId from) const {
    std::vector<ViewPoint> points{{from, kNoPlace, pose(from), 0.0}};
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto links = links_.find(points[i].place);
      if (links == links_.end()) continue;
      for (const PlaceId next : links->second) {
        bool is_known = false;
        for (const ViewPoint& point : points) is_known = is_known || point.place == next;
        const Pose2d way = pose(points[i].place).inverse() * pose(next);
        const double time = points[i].time + std::hypot(way.x, way.y) / kSpeed;
        if (!is_known) points.push_back({next, points[i].place, pose(next), time});
      }
    }
    return points;
  }
  ViewAdviser::Reach reach() const {
    return [this](const PoseCandidate& candidate) { return reached(candidate.place); };
  }

 private:
  struct Box {
    double left, bottom, right, top;
  };

  bool isBoxed(double x, double y) const {
    for (const Box& box : boxes_) {
      if (x >= box.left && x <= box.right && y >= box.bottom && y <= box.top) return true;
    }
    return false;
  }

  std::vector<Box> boxes_;
  std::map<PlaceId, Pose2d> places_;
  std::map<PlaceId, std::vector<PlaceId>> links_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_TEST_CORE_VIEWS_DRAWN_WORLD_H
