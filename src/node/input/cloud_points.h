#ifndef PLACE_MEMORY_NODE_INPUT_CLOUD_POINTS_H
#define PLACE_MEMORY_NODE_INPUT_CLOUD_POINTS_H

#include <sensor_msgs/PointCloud.h>
#include <sensor_msgs/PointCloud2.h>

#include <string>
#include <vector>

namespace place_memory::node {

/// A point of a cloud as seen from above, in the cloud's frame; it may be infinite or NaN.
struct CloudPoint {
  double x = 0.0;  ///< [m]
  double y = 0.0;  ///< [m]
};

/// A ring of sonars has no more.
constexpr std::size_t kMostCloudPoints = 64;

struct CloudPoints {
  std::vector<CloudPoint> points;
  std::string problem;  ///< why there are none, in a sentence
};

CloudPoints pointsOf(const sensor_msgs::PointCloud& cloud);

/// Needs fields x and y of FLOAT32 or FLOAT64; the rest is not looked at.
CloudPoints pointsOf(const sensor_msgs::PointCloud2& cloud);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_INPUT_CLOUD_POINTS_H
