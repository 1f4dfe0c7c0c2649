#include "node/scan/scan_server.h"

#include <ros/console.h>

#include <algorithm>
#include <utility>

#include "node/base/conversions.h"
#include "node/base/ros_time.h"
#include "node/input/input_message.h"
#include "node/input/transform_filter.h"
#include "node/names/node_names.h"
#include "node/scan/scan_topics.h"

namespace place_memory::node {
namespace {

const ros::WallDuration kUpdatePeriod(0.05);
const ros::WallDuration kFeedbackPeriod(0.2);
const ros::WallDuration kPartialPeriod(0.5);
constexpr double kPartialShare = 20.0;  // partial grids take one part of so many of the time

// The time the last messages need to get out of the process.
const ros::WallDuration kLastMessages(0.1);

constexpr std::uint32_t kQueueLength = 500;
const ros::WallDuration kWarningPeriod(5.0);

std::string whoSaysTheTime() {
  return ros::Time::isSimTime() ? "on /clock" : "by the clock of this machine";
}

}  // namespace

ScanServer::ScanServer(const ros::NodeHandle& names, const ros::NodeHandle& private_names,
                       const config::Parameters& parameters, DriveLease& lease,
                       tf2::BufferCore& buffer, TransformInput& transforms, Callbacks callbacks)
    : parameters_(parameters),
      named_parameters_(withResolvedTopics(names, parameters)),
      lease_(lease),
      buffer_(buffer),
      transforms_(transforms),
      callbacks_(std::move(callbacks)),
      intake_parameters_(parameters),
      intake_(
          intake_parameters_,
          [&names](const std::string& topic) { return names.resolveName(topic); }, registry_),
      collector_(named_parameters_, buffer, registry_),
      clock_(toNanoseconds(parameters.time_jump_tolerance)),
      queue_("scans", [this](const std::string& what) { onError(what); }),
      names_(names),
      private_names_(private_names) {
  names_.setCallbackQueue(&queue_);
  private_names_.setCallbackQueue(&queue_);
  server_ = std::make_unique<ActionServer>(
      ros::NodeHandle(private_names_, kScanAction),
      [this](const GoalHandle& goal) { onGoal(goal); },
      [this](const GoalHandle& goal) { onCancel(goal); });
  subscribe();
  timer_ = names_.createSteadyTimer(kUpdatePeriod, &ScanServer::update, this);
  server_->start();
  spinner_ = std::make_unique<ros::AsyncSpinner>(1, &queue_);
  spinner_->start();
  sayTopics(names_, parameters_);
}

ScanServer::~ScanServer() { stop(); }

void ScanServer::subscribe() {
  for (const auto& [topic, role] : intake_.topics()) {
    const boost::function<void(const RawMessage::ConstPtr&)> take =
        [this, topic = topic](const RawMessage::ConstPtr& message) { onMessage(topic, *message); };
    subscribers_.push_back(names_.subscribe<RawMessage>(topic, kQueueLength, take));
  }
}

void ScanServer::stop() {
  if (!spinner_) return;
  spinner_->stop();
  spinner_.reset();
  timer_.stop();
  subscribers_.clear();
  if (sweep_) {
    fail(ScanStatus::kShutdown, "the node was stopped", rosNow());
    kLastMessages.sleep();
  }
  goal_ = GoalHandle();
  server_.reset();
  queue_.clear();
}

void ScanServer::setNoEcho(const config::NoEchoOptions& options) {
  const std::lock_guard<std::mutex> lock(mutex_);
  intake_parameters_.no_echo = options;
}

InputHealth ScanServer::health() const {
  InputHealth health;
  health.sonar_topics = named_parameters_.sonar_topics;
  health.heading_topic = named_parameters_.heading_topic;
  const std::lock_guard<std::mutex> lock(mutex_);
  health.sensors = collector_.sensorHealth();
  health.compass = collector_.compassHealth();
  health.wrong_types = intake_.wrongTypes();
  return health;
}

void ScanServer::onMessage(const std::string& topic, const RawMessage& message) {
  const std::chrono::nanoseconds now = rosNow();
  const std::lock_guard<std::mutex> lock(mutex_);
  const Taken taken = intake_.take(topic, readMessage(message), now, buffer_);
  if (callbacks_.taken) callbacks_.taken(taken);
  for (const geometry_msgs::TransformStamped& transform : taken.transforms) {
    if (now.count() == 0) break;  // before simulated time runs nobody knows which stamps may be
    const auto problem = addTransform(transform, false, now, buffer_);
    if (problem) collector_.noteProblem(topic, *problem);
  }
  for (const CheckedHeading& heading : taken.headings) collector_.addHeading(heading, now);
  for (const AdaptedReading& reading : taken.readings) collector_.addReading(reading, now);
  for (const Taken::Problem& problem : taken.problems) {
    collector_.noteProblem(problem.input, problem.sentence);
  }
}

void ScanServer::onGoal(const GoalHandle& goal) {
  GoalHandle accepted = goal;
  std::string problem;
  const auto request = readGoal(*accepted.getGoal(), parameters_.scan, problem);
  if (!request) {
    ScanPlaceResult result;
    result.status = ScanPlaceResult::INVALID_GOAL;
    result.message = problem;
    accepted.setRejected(result, problem);
    return;
  }
  std::unique_ptr<DriveLease::Hold> hold;
  if (request->turn == config::Turn::kCmdVel) {
    hold = hold_ ? std::move(hold_) : lease_.take("a scan that turns the robot", problem);
    if (!hold) {
      ScanPlaceResult result;
      result.status = ScanPlaceResult::BUSY;
      result.message = problem;
      accepted.setRejected(result, problem);
      return;
    }
    hold->stop();
  }
  const std::chrono::nanoseconds now = rosNow();
  if (sweep_) fail(ScanStatus::kCanceled, "a newer goal came", now);
  hold_ = std::move(hold);
  goal_ = accepted;
  goal_.setAccepted();
  timeRanBackwards(now);
  clock_.restart(steadyNow());
  sweep_.emplace(*request, named_parameters_, collector_, lease_.topic());
  if (callbacks_.under_way) callbacks_.under_way(true);
}

void ScanServer::onCancel(const GoalHandle& goal) {
  if (!sweep_ || goal != goal_) return;
  fail(ScanStatus::kCanceled, "it was canceled", rosNow());
}

void ScanServer::onError(const std::string& what) {
  if (!sweep_) return;
  fail(ScanStatus::kFailed, "an error in the node: " + what + "; scan again", rosNow());
}

void ScanServer::update(const ros::SteadyTimerEvent& /*event*/) {
  const std::chrono::nanoseconds now = rosNow();
  timeRanBackwards(now);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    collector_.process(now);
  }
  if (sweep_) advance(now);
  if (sweep_) report(now);
  sayProblems();
}

void ScanServer::sayProblems() {
  const std::string transform_problem = transforms_.takeProblem();
  if (!transform_problem.empty()) collector_.noteProblem("tf", transform_problem);
  const ros::SteadyTime steady = ros::SteadyTime::now();
  if (collector_.problems().empty() || steady < next_warning_) return;
  ROS_WARN("%s", collector_.problems().inWords().c_str());
  collector_.problems().clear();
  next_warning_ = steady + kWarningPeriod;
}

void ScanServer::advance(std::chrono::nanoseconds now) {
  if (toSeconds(clock_.standing(steadyNow())) > sweep_->request().timeout) {
    fail(ScanStatus::kNoTime,
         "simulated time stands still: is anything published on /clock? (use_sim_time is set)",
         now);
    return;
  }
  sweep_->setListened(lease_.isListenedTo());
  const Sweep::Step step = sweep_->update(now);
  if (step.rate && hold_) hold_->drive(0.0, *step.rate);
  if (step.outcome) end(*step.outcome, now);
}

bool ScanServer::timeRanBackwards(std::chrono::nanoseconds now) {
  const std::chrono::nanoseconds behind = clock_.observe(now, steadyNow());
  if (behind.count() == 0) return false;
  if (!clock_.jumped(behind)) {
    const std::lock_guard<std::mutex> lock(mutex_);
    collector_.stepBack(behind);
    return false;
  }
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    collector_.forgetTime();
  }
  buffer_.clear();
  const std::string what = "time ran backwards by " + inSeconds(behind) + ' ' + whoSaysTheTime();
  ROS_WARN("%s: transforms of the time before are forgotten, places are kept", what.c_str());
  if (sweep_) fail(ScanStatus::kTimeJump, what + ": scan again", now);
  if (callbacks_.time_jump) callbacks_.time_jump();
  return true;
}

void ScanServer::report(std::chrono::nanoseconds now) {
  const ros::SteadyTime steady = ros::SteadyTime::now();
  if (steady - last_feedback_ >= kFeedbackPeriod) {
    last_feedback_ = steady;
    ScanPlaceFeedback feedback;
    feedback.message = sweep_->plan();
    if (collector_.collecting()) {
      const core::SweepCoverage& coverage = collector_.sweep().coverage();
      feedback.fraction = static_cast<float>(coverage.fraction());
      feedback.headings = static_cast<std::uint32_t>(coverage.headings());
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

void ScanServer::fail(ScanStatus status, const std::string& message, std::chrono::nanoseconds now) {
  end({status, message, nullptr, {}}, now);
}

void ScanServer::end(ScanOutcome outcome, std::chrono::nanoseconds now) {
  hold_.reset();
  const std::string silent = silentTopics(health());
  if (!silent.empty()) outcome.message += "; " + silent;

  ScanPlaceResult result;
  result.status = static_cast<std::uint8_t>(outcome.status);
  result.message = outcome.message;
  result.readings = static_cast<std::uint32_t>(collector_.readings());
  result.rejected = toMessage(collector_.rejected());
  if (collector_.collecting()) {
    result.headings = static_cast<std::uint32_t>(collector_.sweep().coverage().headings());
  }
  result.begin = toRosTime(sweep_->started());
  result.end = toRosTime(now);
  if (outcome.scan) {
    result.scan_id = outcome.scan->id;
    result.echoes = outcome.scan->echoes;
  }
  collector_.drop();
  sweep_.reset();
  sayOutcome(outcome);

  if (outcome.scan && callbacks_.finished) callbacks_.finished(outcome.scan);
  if (callbacks_.under_way) callbacks_.under_way(false);
  if (outcome.scan) {
    goal_.setSucceeded(result, result.message);
  } else if (outcome.status == ScanStatus::kCanceled) {
    goal_.setCanceled(result, result.message);
  } else {
    goal_.setAborted(result, result.message);
  }
}

}  // namespace place_memory::node
