#include "sim_node/sonar_sim.h"

#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/Odometry.h>
#include <ros/callback_queue.h>
#include <rosgraph_msgs/Clock.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "node/base/conversions.h"
#include "sim_node/world_markers.h"

namespace place_memory::sim_node {
namespace {

constexpr char kWorldFrame[] = "world";
constexpr char kMapFrame[] = "map";
constexpr char kOdomFrame[] = "odom";
constexpr char kBaseFrame[] = "base_link";

constexpr double kStep = 0.05;            // of the simulation [s]
constexpr double kCommandTimeout = 0.5;   // the base stops without a newer command [s]
constexpr double kTopSpeed = 1.0;         // [m/s]
constexpr double kTopTurnRate = 1.5;      // [rad/s]
constexpr double kSonarHeight = 0.3;      // [m]
constexpr double kLongestBacklog = 0.25;  // of real time, made up for [s]
constexpr std::uint32_t kQueueLength = 100;

geometry_msgs::TransformStamped toTransform(const std_msgs::Header& header,
                                            const std::string& child, const core::Pose2d& pose,
                                            double height = 0.0) {
  const geometry_msgs::Pose planar = node::toPose(pose);
  geometry_msgs::TransformStamped transform;
  transform.header = header;
  transform.child_frame_id = child;
  transform.transform.translation.x = planar.position.x;
  transform.transform.translation.y = planar.position.y;
  transform.transform.translation.z = height;
  transform.transform.rotation = planar.orientation;
  return transform;
}

nav_msgs::Odometry toOdometry(const std_msgs::Header& header, const core::Pose2d& pose,
                              const geometry_msgs::Twist& twist) {
  nav_msgs::Odometry message;
  message.header = header;
  message.child_frame_id = kBaseFrame;
  message.pose.pose = node::toPose(pose);
  message.twist.twist = twist;
  return message;
}

template <class Response>
void answer(sim::ChangeResult result, const std::string& name, Response& response) {
  switch (result) {
    case sim::ChangeResult::kDone:
      response.status = Response::OK;
      response.message = "done";
      return;
    case sim::ChangeResult::kUnknownName:
      response.status = Response::UNKNOWN_NAME;
      response.message = "the world has no \"" + name + "\"";
      return;
    case sim::ChangeResult::kBlocked:
      response.status = Response::BLOCKED;
      response.message = "the robot stands there, or the pose is not finite";
      return;
  }
}

}  // namespace

SonarSim::SonarSim(const ros::NodeHandle& names, const ros::NodeHandle& private_names,
                   const SimParameters& parameters, bool simulated_time)
    : names_(names),
      private_names_(private_names),
      parameters_(parameters),
      simulated_time_(simulated_time),
      simulation_(parameters.world, parameters.start, parameters.options),
      driver_(names, parameters.driver, kBaseFrame) {
  const core::Pose2d& start = parameters.start;
  if (!simulation_.scene().isFree({start.x, start.y}, parameters.options.base_radius)) {
    throw std::invalid_argument("start: the robot would stand on something there");
  }
  // Simulated time begins now, so that it does not run backwards when the node is started anew;
  // with a speed above 1 it does all the same, to what other nodes take for a bag that loops.
  now_.fromNSec(ros::WallTime::now().toNSec());
  advertise();
  publishStaticTransforms();
  publishWorld();
}

void SonarSim::advertise() {
  if (simulated_time_) clock_ = names_.advertise<rosgraph_msgs::Clock>("/clock", kQueueLength);
  odometry_ = names_.advertise<nav_msgs::Odometry>(parameters_.driver.odom_topic, kQueueLength);
  ground_truth_ = private_names_.advertise<nav_msgs::Odometry>("ground_truth", kQueueLength);
  world_ = private_names_.advertise<visualization_msgs::MarkerArray>("world", 1, true);
  people_ = private_names_.advertise<visualization_msgs::Marker>("people", 1);
  command_subscriber_ =
      names_.subscribe(parameters_.driver.command_topic, 1, &SonarSim::onCommand, this);
  services_.push_back(private_names_.advertiseService("set_door", &SonarSim::onSetDoor, this));
  services_.push_back(private_names_.advertiseService("move_chair", &SonarSim::onMoveChair, this));
  services_.push_back(
      private_names_.advertiseService("carry_robot", &SonarSim::onCarryRobot, this));
}

void SonarSim::publishStaticTransforms() {
  std::vector<geometry_msgs::TransformStamped> transforms;
  transforms.push_back(
      toTransform(node::makeHeader(kWorldFrame, now_), kMapFrame, parameters_.start));
  for (const auto& [frame, mount] : driver_.mounts(parameters_.options.robot.ring)) {
    transforms.push_back(
        toTransform(node::makeHeader(kBaseFrame, now_), frame, mount, kSonarHeight));
  }
  static_transforms_.sendTransform(transforms);
}

void SonarSim::publishWorld() { world_.publish(toMarkers(simulation_.scene(), kWorldFrame)); }

void SonarSim::run() {
  const ros::WallDuration period(kStep / parameters_.speed);
  ros::WallTime due = ros::WallTime::now();
  while (ros::ok()) {
    step();
    due = std::max(due + period, ros::WallTime::now() - ros::WallDuration(kLongestBacklog));
    do {
      const ros::WallDuration left = due - ros::WallTime::now();
      ros::getGlobalCallbackQueue()->callAvailable(std::max(left, ros::WallDuration(0.0)));
    } while (ros::ok() && ros::WallTime::now() < due);
  }
}

void SonarSim::step() {
  now_ = simulated_time_ ? now_ + ros::Duration(kStep) : ros::Time::now();
  if (now_ - commanded_ > ros::Duration(kCommandTimeout)) command_ = geometry_msgs::Twist();
  simulation_.step(kStep, command_.linear.x, command_.angular.z);
  if (simulated_time_) {
    rosgraph_msgs::Clock clock;
    clock.clock = now_;
    clock_.publish(clock);
  }
  publishBase();
  driver_.publishHeading(simulation_, parameters_.options.compass_sigma, now_);
  if (now_ < next_ranges_) return;
  next_ranges_ = now_ + ros::Duration(parameters_.sonar_period - 0.5 * kStep);
  driver_.publishRanges(simulation_, now_);
  people_.publish(toMarker(simulation_.people(), kWorldFrame));
}

void SonarSim::publishBase() {
  const sim::SimulatedBase& base = simulation_.base();
  const std_msgs::Header header = node::makeHeader(kOdomFrame, now_);
  if (parameters_.driver.odom_transform) {
    transforms_.sendTransform(toTransform(header, kBaseFrame, base.odometry()));
  }
  odometry_.publish(toOdometry(header, base.odometry(), command_));
  ground_truth_.publish(toOdometry(node::makeHeader(kWorldFrame, now_), base.truth(), command_));
}

void SonarSim::onCommand(const geometry_msgs::Twist& command) {
  if (!std::isfinite(command.linear.x) || !std::isfinite(command.angular.z)) {
    ROS_WARN_THROTTLE(5.0, "cmd_vel left out: it is not finite");
    return;
  }
  command_ = geometry_msgs::Twist();
  command_.linear.x = std::clamp(command.linear.x, -kTopSpeed, kTopSpeed);
  command_.angular.z = std::clamp(command.angular.z, -kTopTurnRate, kTopTurnRate);
  commanded_ = now_;
}

bool SonarSim::onSetDoor(SetDoor::Request& request, SetDoor::Response& response) {
  answer(simulation_.setDoor(request.name, request.open), request.name, response);
  publishWorld();
  return true;
}

bool SonarSim::onCarryRobot(CarryRobot::Request& request, CarryRobot::Response& response) {
  const bool is_put = simulation_.placeRobot({request.pose.x, request.pose.y, request.pose.theta});
  response.status = is_put ? CarryRobot::Response::OK : CarryRobot::Response::BLOCKED;
  response.message = is_put ? "done" : "something stands there, or the pose is not finite";
  return true;
}

bool SonarSim::onMoveChair(MoveChair::Request& request, MoveChair::Response& response) {
  const core::Pose2d pose{request.pose.x, request.pose.y, request.pose.theta};
  answer(simulation_.moveChair(request.name, pose), request.name, response);
  publishWorld();
  return true;
}

}  // namespace place_memory::sim_node
