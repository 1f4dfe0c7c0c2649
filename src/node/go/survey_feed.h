#ifndef PLACE_MEMORY_NODE_GO_SURVEY_FEED_H
#define PLACE_MEMORY_NODE_GO_SURVEY_FEED_H

#include <mutex>
#include <vector>

#include "place_memory/core/map_change.h"
#include "place_memory/core/pose2d.h"
#include "place_memory/core/sonar_reading.h"

namespace place_memory::node {

/// Collects for one who explores what the drive along with the robot hears, how sure it is of where
/// the robot is, and what becomes of the map. Thread-safe.
class SurveyFeed {
 public:
  struct Heard {
    core::Pose2d odom_from_base;
    core::SonarReading reading;  ///< in the base's frame
  };
  struct News {
    std::vector<Heard> heard;  ///< in the order of stamps
    std::vector<core::MapChange> changes;
    double doubt = 0.0;  ///< 1 sigma of where the robot is in the map [m], as of now
  };

  /// Somebody collects from now on, or does no more.
  void begin();
  void end();
  /// Everything since begin(), or since it was called before.
  News fetch();

  // Left out while nobody collects.
  void hear(const core::Pose2d& odom_from_base, const core::SonarReading& reading);
  void follow(const core::MapChange& change);
  void setDoubt(double doubt);

 private:
  std::mutex mutex_;
  bool collects_ = false;
  News news_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_GO_SURVEY_FEED_H
