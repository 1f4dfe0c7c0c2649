#ifndef PLACE_MEMORY_TEST_CORE_RANDOM_ROOM_H
#define PLACE_MEMORY_TEST_CORE_RANDOM_ROOM_H

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "place_memory/core/scan.h"
#include "place_memory/core/sonar_model.h"

namespace place_memory::core {

/// A small room with some boxes in it, drawn from a seed, that a ring of sonars can be cast in: the
/// truth that matching is tested against. Lengths are in units of `scale` metres, so that a room
/// fits the grid whatever its cells.
class RandomRoom {
 public:
  explicit RandomRoom(unsigned seed, double scale = 1.0) : scale_(scale) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> wall(1.6, 3.4);
    std::uniform_real_distribution<double> direction(-kPi, kPi);
    std::uniform_real_distribution<double> from_middle(1.2, 2.4);
    std::uniform_real_distribution<double> half_side(0.15, 0.5);
    const double tilt = direction(engine);
    addBox({0.0, 0.0, tilt}, -wall(engine), wall(engine), -wall(engine), wall(engine));
    for (int i = 0; i < 4; ++i) {
      const double bearing = direction(engine);
      const double distance = from_middle(engine);
      const double x = half_side(engine);
      const double y = half_side(engine);
      addBox({distance * std::cos(bearing), distance * std::sin(bearing), direction(engine)}, -x, x,
             -y, y);
    }
  }

  /// What a robot senses whose scan frame has this pose in the room: a ring of sixteen sonars
  /// turned through eleven headings (paper 3.1.3).
  Scan scanFrom(const Pose2d& room_from_scan, double cell_size = kDefaultCellSize) const {
    Scan scan;
    const SonarSpec spec{kArc, 0.05 * scale_, 5.0 * scale_};
    for (int heading = 0; heading < 11; ++heading) {
      for (int sonar = 0; sonar < 16; ++sonar) {
        const double yaw = sonar * kArc + heading * kArc / 11.0;
        const double radius = 0.2 * scale_;
        const Pose2d sensor{radius * std::cos(yaw), radius * std::sin(yaw), wrapAngle(yaw)};
        scan.readings.push_back({sensor, spec, range(room_from_scan * sensor, spec)});
      }
    }
    scan.grid = SonarModel(SonarModelOptions{}).build(scan.readings, GridGeometry{cell_size});
    return scan;
  }

 private:
  static constexpr double kArc = kPi / 8.0;

  struct Wall {
    Pose2d start;   ///< x axis along the wall
    double length;  ///< [m]
  };

  void addBox(const Pose2d& frame, double left, double right, double bottom, double top) {
    const Pose2d corners[] = {
        {left, bottom, 0.0}, {right, bottom, 0.0}, {right, top, 0.0}, {left, top, 0.0}};
    for (std::size_t i = 0; i < 4; ++i) {
      const Pose2d a = frame * corners[i];
      const Pose2d b = frame * corners[(i + 1) % 4];
      walls_.push_back({{a.x * scale_, a.y * scale_, std::atan2(b.y - a.y, b.x - a.x)},
                        std::hypot(b.x - a.x, b.y - a.y) * scale_});
    }
  }

  /// The nearest wall in the cone, or infinity.
  double range(const Pose2d& sensor, const SonarSpec& spec) const {
    constexpr int kRays = 9;
    double nearest = std::numeric_limits<double>::infinity();
    for (int ray = 0; ray < kRays; ++ray) {
      const double angle = spec.field_of_view * (static_cast<double>(ray) / (kRays - 1) - 0.5);
      nearest = std::min(nearest, cast(sensor * Pose2d{0.0, 0.0, angle}));
    }
    if (nearest > spec.max_range) return std::numeric_limits<double>::infinity();
    return std::max(nearest, spec.min_range);
  }

  double cast(const Pose2d& ray) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Wall& wall : walls_) {
      const Pose2d local = wall.start.inverse() * ray;
      const double towards = -std::sin(local.yaw);
      if (local.y * towards <= 0.0) continue;
      const double distance = local.y / towards;
      const double along = local.x + distance * std::cos(local.yaw);
      if (along >= 0.0 && along <= wall.length) nearest = std::min(nearest, distance);
    }
    return nearest;
  }

  double scale_;
  std::vector<Wall> walls_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_TEST_CORE_RANDOM_ROOM_H
