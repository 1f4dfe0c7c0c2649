#include "node/scan/scan_server.h"

#include <geometry_msgs/Twist.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "node/input/sensor_placement.h"
#include "node/node_names.h"

namespace place_memory::node {
namespace {

const ros::WallDuration kUpdatePeriod(0.05);
const ros::WallDuration kFeedbackPeriod(0.2);
const ros::WallDuration kPartialPeriod(0.5);
constexpr double kPartialShare = 20.0;  // partial grids take one part of so many of the time

// A sweep is over when all of its headings were sensed and the sensors have been silent for so
// long, and for twice as long as ever before in this scan, though not every one of them spoke at
// the last heading.
constexpr double kSilence = 0.5;  // [s]

// The time the last messages need to get out of the process.
const ros::WallDuration kLastMessages(0.1);

constexpr std::uint32_t kQueueLength = 500;
constexpr double kWarningPeriod = 5.0;  // [s]

}  // namespace

ScanServer::ScanServer(const ros::NodeHandle& names, const ros::NodeHandle& private_names,
                       const config::Parameters& parameters, tf2_ros::Buffer& buffer,
                       Callbacks callbacks)
    : parameters_(parameters),
      buffer_(buffer),
      callbacks_(std::move(callbacks)),
      collector_(parameters, buffer),
      names_(names),
      private_names_(private_names) {
  names_.setCallbackQueue(&queue_);
  private_names_.setCallbackQueue(&queue_);
  command_publisher_ = names_.advertise<geometry_msgs::Twist>(kCommandTopic, 1);

  server_ = std::make_unique<Server>(private_names_, kScanAction, false);
  server_->registerGoalCallback([this](const Server::GoalHandle& goal) { onGoal(goal); });
  server_->registerCancelCallback([this](const Server::GoalHandle& goal) { onCancel(goal); });
  for (const std::string& topic : parameters_.sonar_topics) {
    subscribers_.push_back(names_.subscribe(topic, kQueueLength, &ScanServer::onRange, this));
  }
  subscribers_.push_back(
      names_.subscribe(parameters_.heading_topic, kQueueLength, &ScanServer::onHeading, this));
  timer_ = names_.createSteadyTimer(kUpdatePeriod, &ScanServer::update, this);

  server_->start();
  spinner_ = std::make_unique<ros::AsyncSpinner>(1, &queue_);
  spinner_->start();
}

ScanServer::~ScanServer() { stop(); }

void ScanServer::stop() {
  if (!spinner_) return;
  spinner_->stop();
  spinner_.reset();
  timer_.stop();
  subscribers_.clear();
  if (sweep_) {
    end({ScanStatus::kShutdown, "the node was stopped", nullptr}, ros::Time::now());
    kLastMessages.sleep();
  }
  goal_ = Server::GoalHandle();
  server_.reset();
  queue_.clear();
}

std::map<std::string, SensorHealth> ScanServer::health() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return collector_.health().sensors();
}

void ScanServer::onRange(const sensor_msgs::Range::ConstPtr& message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  collector_.addRange(*message, ros::Time::now());
}

void ScanServer::onHeading(const sensor_msgs::Imu::ConstPtr& message) {
  collector_.addHeading(*message, ros::Time::now());
}

void ScanServer::onGoal(const Server::GoalHandle& goal) {
  if (sweep_) end({ScanStatus::kCanceled, "a newer goal came", nullptr}, ros::Time::now());
  goal_ = goal;
  goal_.setAccepted();
  sweep_.emplace();
  timeRanBackwards(ros::Time::now());
  clock_changed_ = ros::SteadyTime::now();
  std::string problem;
  const auto request = readGoal(*goal_.getGoal(), parameters_.scan, problem);
  if (!request) {
    end({ScanStatus::kInvalidGoal, problem, nullptr}, clock_);
    return;
  }
  sweep_->request = *request;
}

void ScanServer::onCancel(const Server::GoalHandle& goal) {
  if (!sweep_ || goal != goal_) return;
  end({ScanStatus::kCanceled, "it was canceled", nullptr}, ros::Time::now());
}

void ScanServer::update(const ros::SteadyTimerEvent& /*event*/) {
  const ros::Time now = ros::Time::now();
  const bool backwards = timeRanBackwards(now);
  if (sweep_ && backwards) {
    end({ScanStatus::kTimeJump, "time ran backwards: scan again", nullptr}, now);
  }
  if (sweep_ && !clockStands(now)) {
    if (sweep_->started.isZero()) start(now);
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      collector_.process(now);
    }
    if (collector_.failure()) {
      end(collector_.outcome(now), now);
    } else if (now - sweep_->started > ros::Duration(sweep_->request.timeout)) {
      timeOut(now);
    } else if (sweep_->turner) {
      turn(now);
    } else {
      listen(now);
    }
  }
  if (sweep_) report(now);
  const std::string problem = collector_.takeProblem();
  if (!problem.empty()) ROS_WARN_STREAM_THROTTLE(kWarningPeriod, problem);
}

bool ScanServer::timeRanBackwards(const ros::Time& now) {
  const bool clock_did = now < clock_;
  if (now != clock_) clock_changed_ = ros::SteadyTime::now();
  clock_ = now;
  if (clock_did) collector_.forgetTime();
  if (!collector_.takeTimeJump() && !clock_did) return false;
  buffer_.clear();
  ROS_WARN("time ran backwards: transforms of the time before are forgotten, places are kept");
  if (callbacks_.time_jump) callbacks_.time_jump();
  return true;
}

bool ScanServer::clockStands(const ros::Time& now) {
  const ros::WallDuration standing = ros::SteadyTime::now() - clock_changed_;
  if (standing > ros::WallDuration(sweep_->request.timeout)) {
    end({ScanStatus::kNoTime,
         "simulated time stands still: is anything published on /clock? (use_sim_time is set)",
         nullptr},
        now);
    return true;
  }
  return now.isZero();
}

void ScanServer::start(const ros::Time& now) {
  const ScanRequest& request = sweep_->request;
  sweep_->started = sweep_->last_reading = now;
  if (request.turn == config::Turn::kCmdVel) {
    const int headings = core::SweepCoverage(request.headings, request.step).target();
    sweep_->turner.emplace(headings, request.step, parameters_.scan.turn_rate);
  } else {
    collector_.begin(now, request.headings, request.step);
  }
}

void ScanServer::listen(const ros::Time& now) {
  if (collector_.readings() != sweep_->readings) {
    sweep_->readings = collector_.readings();
    sweep_->last_reading = now;
  }
  const double silence = (now - sweep_->last_reading).toSec();
  if (collector_.readings() < static_cast<std::size_t>(parameters_.scan.min_readings)) return;
  const core::SweepCoverage& coverage = collector_.coverage();
  const bool silent = silence > std::max(kSilence, 2.0 * collector_.longestGap());
  if (coverage.done() || (silent && coverage.headings() >= coverage.target())) {
    end(collector_.outcome(now), now);
  }
}

void ScanServer::turn(const ros::Time& now) {
  const std::optional<double> yaw = yawNow(now);
  if (!yaw) {
    const bool may_come = now - sweep_->started <= ros::Duration(parameters_.scan.heading_timeout);
    if (may_come && !moving_) return;
    const bool odometry = !parameters_.odom_frame.empty();
    end({odometry ? ScanStatus::kNoOdometry : ScanStatus::kNoHeading,
         odometry ? "the robot was stopped: no fresh transform from " + parameters_.base_frame +
                        " to " + parameters_.odom_frame
                  : "the robot was stopped: no fresh heading on " + parameters_.heading_topic,
         nullptr},
        now);
    return;
  }
  core::SweepTurner& turner = *sweep_->turner;
  const int completed = collector_.collecting() ? collector_.coverage().completed() : 0;
  command(turner.update(*yaw, completed));
  if (turner.started() && !collector_.collecting()) {
    collector_.begin(now, sweep_->request.headings, sweep_->request.step);
  }
  if (turner.swept()) collector_.close();
  if (turner.done()) end(collector_.outcome(now), now);
}

std::optional<double> ScanServer::yawNow(const ros::Time& now) const {
  ros::Time stamp;
  double yaw = 0.0;
  if (parameters_.odom_frame.empty()) {
    const auto newest = collector_.headings().newest();
    if (!newest) return std::nullopt;
    stamp.fromNSec(static_cast<std::uint64_t>(newest->stamp.count()));
    yaw = newest->yaw;
  } else {
    const auto base = lookupNewest(buffer_, parameters_.odom_frame, parameters_.base_frame, stamp);
    if (!base) return std::nullopt;
    yaw = base->pose.yaw;
  }
  if (now.toSec() - stamp.toSec() > parameters_.scan.heading_timeout) return std::nullopt;
  return yaw;
}

void ScanServer::timeOut(const ros::Time& now) {
  if (moving_) command(0.0);
  const int wanted = sweep_->request.headings;
  const int sensed = collector_.collecting() ? collector_.coverage().headings() : 0;
  ScanOutcome outcome{ScanStatus::kTimeout, "the robot never came to the first heading", nullptr};
  if (collector_.collecting()) outcome = collector_.outcome(now);

  std::ostringstream text;
  text << "not over after " << sweep_->request.timeout << " s: " << sensed << " of " << wanted
       << " headings were sensed; " << outcome.message;
  if (sensed == 1 && wanted > 1 && !sweep_->turner) {
    text << "; nothing turned the robot: let the node do it (turn), or ask for 1 heading";
  }
  const bool only_few =
      outcome.status == ScanStatus::kTooFewReadings && sensed >= collector_.coverage().target();
  const bool said_why = only_few || outcome.status == ScanStatus::kNoHeading ||
                        outcome.status == ScanStatus::kNoOdometry;
  end({said_why ? outcome.status : ScanStatus::kTimeout, text.str(), nullptr}, now);
}

void ScanServer::report(const ros::Time& now) {
  const ros::SteadyTime steady = ros::SteadyTime::now();
  if (steady - last_feedback_ >= kFeedbackPeriod) {
    last_feedback_ = steady;
    ScanPlaceFeedback feedback;
    if (collector_.collecting()) {
      feedback.fraction = static_cast<float>(collector_.coverage().fraction());
      feedback.headings = static_cast<std::uint32_t>(collector_.coverage().headings());
      feedback.readings = static_cast<std::uint32_t>(collector_.readings());
      feedback.rejected = toMessage(collector_.rejected());
    }
    goal_.publishFeedback(feedback);
  }
  if (callbacks_.partial && steady >= next_partial_ && collector_.collecting()) {
    if (const auto scan = collector_.snapshot(now)) callbacks_.partial(*scan);
    // A grid of very many readings takes long, and the robot is steered meanwhile.
    const ros::WallDuration took = ros::SteadyTime::now() - steady;
    next_partial_ = steady + std::max(kPartialPeriod, took * kPartialShare);
  }
}

void ScanServer::end(const ScanOutcome& outcome, const ros::Time& now) {
  if (moving_) command(0.0);
  moving_ = false;

  ScanPlaceResult result;
  result.status = static_cast<std::uint8_t>(outcome.status);
  result.message = outcome.message;
  result.readings = static_cast<std::uint32_t>(collector_.readings());
  result.rejected = toMessage(collector_.rejected());
  if (collector_.collecting()) {
    result.headings = static_cast<std::uint32_t>(collector_.coverage().headings());
  }
  result.begin = sweep_->started;
  result.end = now;
  collector_.drop();
  sweep_.reset();

  if (outcome.scan) {
    if (callbacks_.finished) callbacks_.finished(outcome.scan);
    goal_.setSucceeded(result, result.message);
  } else if (outcome.status == ScanStatus::kCanceled) {
    goal_.setCanceled(result, result.message);
  } else {
    goal_.setAborted(result, result.message);
  }
}

void ScanServer::command(double rate) {
  moving_ = true;
  geometry_msgs::Twist twist;
  twist.angular.z = rate;
  command_publisher_.publish(twist);
}

}  // namespace place_memory::node
