#ifndef PLACE_MEMORY_TOOLS_STANDING_STRETCHES_H
#define PLACE_MEMORY_TOOLS_STANDING_STRETCHES_H

#include <ros/time.h>

#include <vector>

#include "config/parameters.h"
#include "tools/bag_set.h"
#include "tools/event_table.h"

namespace place_memory::tools {

/// Where odometry had the robot.
struct TrackPoint {
  ros::Time stamp;
  double x = 0.0;  ///< [m]
  double y = 0.0;  ///< [m]
};

/// What counts as standing, whether or not the robot turns meanwhile.
struct StandingOptions {
  double radius = 0.05;  ///< it stays so near to where it stopped [m]
  double shortest = 2.5;
  double longest = 60.0;  ///< of a longer one the first part is taken [s]
  double gap = 2.0;       ///< odometry may be silent so long [s]
};

struct Stretch {
  ros::Time start;
  ros::Time end;
};

/// The stretches in which the robot stood or turned on the spot, in order. The stamps of `track`
/// ascend.
std::vector<Stretch> standingStretches(const std::vector<TrackPoint>& track,
                                       const StandingOptions& options);

/// The robot's way by the tf of bags, from the odometry frame to whatever frame of the robot
/// stands next to it. Throws std::runtime_error where there is no such transform.
std::vector<TrackPoint> readTrack(const BagSet& bags, const config::Parameters& parameters);

/// For bags without a table of events: each stretch is recognized, and learned where the answer is
/// UNKNOWN (Event::visit). Throws std::runtime_error where the robot never stands, or has no
/// odometry.
std::vector<Event> findEvents(const BagSet& bags, const config::Parameters& parameters);

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_STANDING_STRETCHES_H
