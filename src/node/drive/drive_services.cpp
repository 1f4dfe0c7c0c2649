#include "node/drive/drive_services.h"

#include <ros/console.h>
#include <ros/this_node.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>

#include "node/drive/closure_words.h"
#include "node/drive/drive_publisher.h"
#include "node/input/planar.h"
#include "node/input/transform_filter.h"
#include "node/names/node_names.h"
#include "support/text.h"

namespace place_memory::node {
namespace {

std::optional<config::Mode> modeOf(const std::string& name) {
  for (const auto mode : {config::Mode::kOff, config::Mode::kMap, config::Mode::kLocalize}) {
    if (name == nameOf(mode)) return mode;
  }
  return std::nullopt;
}

std::string inWords(config::Mode mode) {
  switch (mode) {
    case config::Mode::kMap:
      return "the mode is map: a map is made while the robot drives";
    case config::Mode::kLocalize:
      return "the mode is localize: where the robot is on the map is told while it drives";
    case config::Mode::kOff:
      break;
  }
  return "the mode is off";
}

}  // namespace

DriveServices::DriveServices(const ros::NodeHandle& names, const ros::NodeHandle& private_names,
                             MapDriver& driver, const core::PlaceMemory& memory,
                             const config::Parameters& parameters)
    : driver_(driver), memory_(memory), parameters_(parameters) {
  ros::NodeHandle relative(names), own(private_names);
  relative.setCallbackQueue(&queue_);
  own.setCallbackQueue(&queue_);
  const boost::function<bool(SetMode::Request&, SetMode::Response&)> set_mode =
      [this](SetMode::Request& request, SetMode::Response& response) {
        onSetMode(request, response);
        return true;
      };
  servers_.push_back(own.advertiseService(kSetModeService, set_mode));
  const boost::function<bool(Relocalize::Request&, Relocalize::Response&)> relocalize =
      [this](Relocalize::Request& /*request*/, Relocalize::Response& response) {
        onRelocalize(response);
        return true;
      };
  servers_.push_back(own.advertiseService(kRelocalizeService, relocalize));
  const boost::function<bool(JudgeClosure::Request&, JudgeClosure::Response&)> judge_closure =
      [this](JudgeClosure::Request& request, JudgeClosure::Response& response) {
        onJudgeClosure(request, response);
        return true;
      };
  servers_.push_back(own.advertiseService(kJudgeClosureService, judge_closure));
  initialpose_ = relative.subscribe(kInitialPoseTopic, 1, &DriveServices::onInitialPose, this);
}

DriveServices::~DriveServices() { spinner_.stop(); }

void DriveServices::begin() {
  if (parameters_.mode != config::Mode::kOff) {
    const SetMode::Response response = setMode(parameters_.mode);
    if (response.status == SetMode::Response::OK) {
      ROS_INFO("%s", response.message.c_str());
    } else {
      ROS_ERROR("The mode stays off: %s", response.message.c_str());
    }
  }
  spinner_.start();
}

SetMode::Response DriveServices::setMode(config::Mode mode) {
  SetMode::Response response;
  if (mode != config::Mode::kOff && parameters_.odom_frame.empty()) {
    response.status = SetMode::Response::NO_ODOMETRY;
    response.message = "odom_frame is empty: nothing says how the robot drives; name the frame";
    return response;
  }
  try {
    response.message = inWords(mode);
    if (driver_.setMode(mode)) return response;
    response.status = SetMode::Response::NO_PLACES;
    response.message =
        "the map has no place whose readings are known, by which a robot could be localized: make "
        "some in mode map, or name another store";
  } catch (const core::PlaceMemoryError& error) {
    response.status = SetMode::Response::STORE_FAILED;
    response.message = error.what();
  } catch (const std::exception& error) {
    response.status = SetMode::Response::FAILED;
    response.message =
        std::string("the map cannot be taken up: ") + error.what() + "; name another store";
  }
  return response;
}

void DriveServices::onSetMode(const SetMode::Request& request, SetMode::Response& response) {
  const auto mode = modeOf(request.mode);
  if (!mode) {
    response.status = SetMode::Response::UNKNOWN_MODE;
    response.message = "the mode must be off, map or localize";
    return;
  }
  response = setMode(*mode);
  ROS_INFO("%s", response.message.c_str());
}

void DriveServices::onRelocalize(Relocalize::Response& response) {
  try {
    if (memory_.size() == 0) {
      response.status = Relocalize::Response::NO_PLACES;
      response.message = "the map has no place: make some in mode map, or learn some";
    } else if (!driver_.relocalize()) {
      response.status = Relocalize::Response::OFF;
      response.message = "the mode is off: call ~set_mode with map or localize first";
    } else {
      response.message =
          "what was known of where the robot is is forgotten: drive some metres, or scan";
    }
  } catch (const std::exception& error) {
    response.status = Relocalize::Response::FAILED;
    response.message = error.what();
  }
}

void DriveServices::judge(core::PlaceId place, bool confirm, JudgeClosure::Response& response) {
  const auto word = driver_.judgeClosure(place, confirm);
  if (!word) {
    response.status = JudgeClosure::Response::OFF;
    response.message = "the mode is off: call ~set_mode with map or localize first";
    return;
  }
  const ClosureReply reply = replyTo(*word, confirm);
  response.status = reply.status;
  response.message = reply.message;
}

void DriveServices::onJudgeClosure(const JudgeClosure::Request& request,
                                   JudgeClosure::Response& response) {
  try {
    const auto place = request.id != 0 ? memory_.place(request.id) : memory_.place(request.label);
    if (request.action > JudgeClosure::Request::CUT) {
      response.status = JudgeClosure::Response::INVALID;
      response.message = "action must be LIST, CONFIRM or CUT";
    } else if (request.action != JudgeClosure::Request::LIST && !place) {
      response.status = JudgeClosure::Response::UNKNOWN_PLACE;
      response.message = "there is no such place: ~list_places tells which there are";
    } else if (request.action != JudgeClosure::Request::LIST) {
      judge(place->id, request.action == JudgeClosure::Request::CONFIRM, response);
    }
    for (const core::ClosureQuestion& question : driver_.closureQuestions()) {
      response.waiting.push_back(toMessage(question, memory_));
    }
    if (request.action == JudgeClosure::Request::LIST) {
      response.message = std::to_string(response.waiting.size()) + " candidates of closures wait";
    }
  } catch (const std::exception& error) {
    response.status = JudgeClosure::Response::FAILED;
    response.message = error.what();
  }
}

std::string DriveServices::problemOf(const InitialPose& message) const {
  const std::string frame = support::withoutLeadingSlashes(message.header.frame_id);
  if (frame != parameters_.map_frame) {
    return "its frame is \"" + frame + "\", and must be " + parameters_.map_frame;
  }
  const auto& p = message.pose.pose.position;
  const auto& q = message.pose.pose.orientation;
  const double norm = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  // Written so that NaN fails.
  if (!std::isfinite(p.x + p.y + norm) || !(norm > 0.1)) return "it holds no pose";
  if (std::max(std::abs(p.x), std::abs(p.y)) > kFarthest) return "nothing lies so far away";
  return {};
}

void DriveServices::onInitialPose(const ros::MessageEvent<InitialPose const>& event) {
  if (event.getPublisherName() == ros::this_node::getName()) return;
  const InitialPose& message = *event.getConstMessage();
  std::string problem = problemOf(message);
  if (problem.empty()) {
    geometry_msgs::Transform transform;
    transform.translation.x = message.pose.pose.position.x;
    transform.translation.y = message.pose.pose.position.y;
    transform.rotation = message.pose.pose.orientation;
    if (!driver_.setPose(planar(transform).pose)) {
      problem = "the mode is off (~set_mode), or no odometry has come yet";
    }
  }
  if (!problem.empty()) {
    ROS_WARN("%s is left out: %s", initialpose_.getTopic().c_str(), problem.c_str());
  }
}

}  // namespace place_memory::node
