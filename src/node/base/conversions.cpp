#include "node/base/conversions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace place_memory::node {
namespace {

constexpr std::int8_t kUnsensed = -1;

// The message of each evidence a cell can have, from -127 up.
class CellValues {
 public:
  explicit CellValues(double prior) {
    for (int evidence = -core::EvidenceGrid::kLimit; evidence <= core::EvidenceGrid::kLimit;
         ++evidence) {
      const double percent = 100.0 * core::EvidenceGrid::probability(evidence, prior);
      values_[index(evidence)] =
          evidence == 0 ? kUnsensed : static_cast<std::int8_t>(std::lround(percent));
    }
  }

  std::int8_t of(int evidence) const { return values_[index(evidence)]; }

 private:
  static std::size_t index(int evidence) {
    const int from_least = evidence + core::EvidenceGrid::kLimit;
    return static_cast<std::size_t>(from_least);
  }

  std::array<std::int8_t, 2 * core::EvidenceGrid::kLimit + 1> values_{};
};

// The two count alike; naming both makes a change of either a compile error.
std::uint8_t toMessage(core::Verdict verdict) {
  switch (verdict) {
    case core::Verdict::kRecognized:
      return Recognition::RECOGNIZED;
    case core::Verdict::kAmbiguous:
      return Recognition::AMBIGUOUS;
    case core::Verdict::kUnknown:
      break;
  }
  return Recognition::UNKNOWN;
}

}  // namespace

ros::Time toRosTime(std::chrono::nanoseconds time) {
  constexpr std::chrono::seconds kLatest(std::numeric_limits<std::uint32_t>::max());
  const auto held =
      std::clamp<std::chrono::nanoseconds>(time, std::chrono::nanoseconds(0), kLatest);
  ros::Time message;
  message.fromNSec(static_cast<std::uint64_t>(held.count()));
  return message;
}

std_msgs::Header makeHeader(const std::string& frame_id, const ros::Time& stamp) {
  std_msgs::Header header;
  header.frame_id = frame_id;
  header.stamp = stamp;
  return header;
}

geometry_msgs::Pose toPose(const core::Pose2d& pose) {
  geometry_msgs::Pose message;
  message.position.x = pose.x;
  message.position.y = pose.y;
  message.orientation.z = std::sin(0.5 * pose.yaw);
  message.orientation.w = std::cos(0.5 * pose.yaw);
  return message;
}

geometry_msgs::Pose2D toPose2D(const core::Pose2d& pose) {
  geometry_msgs::Pose2D message;
  message.x = pose.x;
  message.y = pose.y;
  message.theta = core::wrapAngle(pose.yaw);
  return message;
}

geometry_msgs::PoseWithCovariance toPoseWithCovariance(const core::Pose2d& pose,
                                                       const std::array<double, 9>& covariance) {
  constexpr std::array<std::size_t, 3> kPlanar{0, 1, 5};  // x, y, yaw among six
  geometry_msgs::PoseWithCovariance message;
  message.pose = toPose(pose);
  for (std::size_t row = 0; row < kPlanar.size(); ++row) {
    for (std::size_t column = 0; column < kPlanar.size(); ++column) {
      message.covariance[6 * kPlanar[row] + kPlanar[column]] = covariance[3 * row + column];
    }
  }
  return message;
}

nav_msgs::OccupancyGrid toOccupancyGrid(const core::EvidenceGrid& grid,
                                        const core::Pose2d& frame_from_grid,
                                        const std_msgs::Header& header, double prior) {
  const double half_width = grid.geometry().halfWidth();
  nav_msgs::OccupancyGrid message;
  message.header = header;
  message.info.map_load_time = header.stamp;
  message.info.resolution = static_cast<float>(grid.geometry().cell_size);
  message.info.width = core::kGridSize;
  message.info.height = core::kGridSize;
  // The origin of a message is the outer corner of its first cell.
  message.info.origin = toPose(frame_from_grid * core::Pose2d{-half_width, -half_width, 0.0});
  const CellValues values(prior);
  message.data.reserve(grid.cells().size());
  for (const std::int8_t evidence : grid.cells()) message.data.push_back(values.of(evidence));
  return message;
}

Recognition toMessage(const core::PlaceMemory::Answer& answer, const std_msgs::Header& header,
                      const ros::Duration& match_duration) {
  const core::Recognition& found = answer.recognition;
  Recognition message;
  message.header = header;
  message.verdict = toMessage(found.verdict);
  for (std::size_t i = 0; i < found.matches.size(); ++i) {
    const core::PlaceMatch& match = found.matches[i];
    PlaceMatch& added = message.matches.emplace_back();
    added.id = match.id;
    added.label = answer.labels[i];
    added.score = match.score;
    added.transform = toPose2D(match.place_from_scan);
    added.probability = match.probability;
  }
  message.pose = toPoseWithCovariance(found.map_from_robot, found.covariance);
  message.match_duration = match_duration;
  return message;
}

const std::string& scanFrame(const config::Parameters& parameters) {
  return parameters.odom_frame.empty() ? parameters.map_frame : parameters.odom_frame;
}

}  // namespace place_memory::node
