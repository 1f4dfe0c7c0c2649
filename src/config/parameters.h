#ifndef PLACE_MEMORY_CONFIG_PARAMETERS_H
#define PLACE_MEMORY_CONFIG_PARAMETERS_H

#include <string>
#include <vector>

#include "place_memory/core/adaptation_options.h"
#include "place_memory/core/grid_geometry.h"
#include "place_memory/core/link_learning.h"
#include "place_memory/core/pose2d.h"
#include "place_memory/core/recognizer_options.h"
#include "place_memory/core/sonar_model.h"

namespace place_memory::config {

/// Who turns the robot during a scan.
enum class Turn {
  kListen,  ///< something else, or nothing
  kCmdVel,  ///< the node, through cmd_vel
};

/// The least ScanOptions::step [rad].
constexpr double kLeastStep = 0.001;

/// How a scan is taken (paper 3.1.4). config/place_memory.yaml says more of each.
struct ScanOptions {
  int headings = 0;                ///< 0: planned by the sensors
  double step = core::kPi / 90.0;  ///< [rad]
  Turn turn = Turn::kListen;
  double turn_rate = 0.2;        ///< [rad/s]
  double least_turn_rate = 0.0;  ///< [rad/s]; 0: found out
  double timeout = 60.0;         ///< [s]
  int min_readings = 8;
  double tf_timeout = 0.5;       ///< [s]
  double heading_timeout = 1.0;  ///< [s]
  double max_age = 600.0;        ///< of a scan that is learned or recognized [s]
  bool over_range_is_no_echo = false;
  bool zero_range_is_no_echo = false;  ///< 0 where min_range is above 0
};

/// What drivers say where no echo came, beside +inf (REP 117).
struct NoEchoOptions {
  bool top = true;   ///< max_range, a value that repeats at the top of the range, or FLT_MAX
  bool zero = true;  ///< 0 from a sensor with min_range 0, -1, or a negative value that repeats
};

/// How the compass counts.
struct HeadingOptions {
  double yaw_offset = 0.0;   ///< added to the yaw [rad], counter-clockwise
  bool reversed = false;     ///< it counts against the sense that its message type says
  double declination = 0.0;  ///< of magnetic north from true north [rad], east is positive
};

/// Sonars of which a driver says nothing but points, one cloud for the whole ring.
struct CloudOptions {
  double max_range = 5.0;            ///< [m]
  double field_of_view = 0.35;       ///< [rad]
  std::vector<core::Pose2d> mounts;  ///< of the sensors, in the cloud's frame; empty: inferred
};

/// Laser scans, taken as a fan of cones.
struct LaserOptions {
  int cones = 72;
};

/// How a scan is matched against the learned places (paper 4).
struct MatchOptions {
  std::string preset = "evidence";     ///< evidence, paper, or the path of a preset file
  core::RecognizerOptions recognizer;  ///< with what that preset holds
};

/// The building's map (nav_msgs/OccupancyGrid).
struct MapOptions {
  double resolution = 0.05;    ///< side of a cell [m]
  int max_cells = 16'000'000;  ///< of the box that is mapped
  double occupied = 0.65;      ///< probability from which a cell is occupied
  double empty = 0.4;          ///< up to which it is empty; what lies between is unknown
  double pause = 1.0;          ///< between two maps [s], at least
};

/// What the node does with readings that come while the robot drives.
enum class Mode {
  kOff,       ///< nothing
  kMap,       ///< it makes a map and corrects it
  kLocalize,  ///< it tells where the robot is on a map that stays
};

/// When the transform map_frame -> odom_frame follows what is found out.
enum class Correct {
  kAlways,
  kWhenLost,   ///< when it became known anew where the robot is
  kOnRequest,  ///< when it is known after ~relocalize or initialpose
};

/// Who drives the robot to a place.
enum class DriveBy {
  kCmdVel,    ///< the node, through cmd_vel
  kMoveBase,  ///< a server of MoveBaseAction
};

/// Of a robot that drives along with the map, or is driven.
struct DriveOptions {
  Correct correct = Correct::kAlways;
  double largest_jump = 0.5;  ///< a correction that moves the robot further is an event [m]
  bool initialpose = false;   ///< published when it became known where the robot is
  DriveBy by = DriveBy::kCmdVel;
  double speed = 0.3;       ///< at most [m/s]
  double turn_rate = 0.6;   ///< at most [rad/s]
  double radius = 0.3;      ///< of the robot [m]
  double clearance = 0.15;  ///< that it keeps to what is heard ahead [m]
  double patience = 5.0;    ///< with what stands in the way [s]
  double timeout = 10.0;    ///< of a server that is silent [s]
};

/// What is drawn for rviz.
struct MarkerOptions {
  int labels = 100;
  int clickable = 0;  ///< places nearest to the robot that answer to the mouse
};

/// Everything that can be set, with its default. config/place_memory.yaml documents every one.
struct Parameters {
  std::string odom_frame = "odom";  ///< empty: no odometry
  std::string base_frame = "base_link";
  std::string map_frame = "map";
  Mode mode = Mode::kOff;
  bool tf_broadcast = false;         ///< map_frame -> odom_frame
  double tf_rate = 10.0;             ///< [Hz]
  double transform_tolerance = 0.2;  ///< [s]
  std::vector<std::string> sonar_topics = {"sonar"};
  std::string heading_topic = "heading";  ///< empty: no compass, odometry's yaw is used
  std::string odom_topic;  ///< of nav_msgs/Odometry where nothing broadcasts tf; empty: none
  std::string store;       ///< path; empty: in memory only
  /// Below it lie the files that services write and read; empty: there are none.
  std::string store_directory;
  double time_jump_tolerance = 1.0;  ///< [s]

  core::GridGeometry grid;
  core::SonarModelOptions sonar;
  NoEchoOptions no_echo;
  HeadingOptions heading;
  CloudOptions cloud;
  LaserOptions laser;
  ScanOptions scan;
  MatchOptions match;
  core::AdaptationOptions places;
  MapOptions map;
  core::LinkLearningOptions routes;
  DriveOptions drive;
  MarkerOptions markers;
};

}  // namespace place_memory::config

#endif  // PLACE_MEMORY_CONFIG_PARAMETERS_H
