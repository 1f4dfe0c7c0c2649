#include "node/answer/route_services.h"

#include <ros/console.h>
#include <ros/time.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include "node/answer/answer_words.h"
#include "node/answer/guarded_service.h"
#include "node/answer/route_messages.h"
#include "node/base/ros_time.h"
#include "node/names/node_names.h"
#include "support/text.h"

namespace place_memory::node {
namespace {

using Status = core::RouteAnswer::Status;

std::uint8_t toStatus(Status status) {
  switch (status) {
    case Status::kFound:
      return PlanRoute::Response::OK;
    case Status::kNoRoute:
      return PlanRoute::Response::NO_ROUTE;
    case Status::kNotLocalized:
      return PlanRoute::Response::NOT_LOCALIZED;
    case Status::kUnknownStart:
      return PlanRoute::Response::UNKNOWN_START;
    case Status::kUnknownGoal:
      return PlanRoute::Response::UNKNOWN_GOAL;
  }
  return PlanRoute::Response::FAILED;
}

std::string oddsInWords(double odds) {
  if (odds == 0.0) return "forbidden";
  return "odds of getting through " + std::to_string(std::lround(100.0 * odds)) + " %";
}

}  // namespace

RouteServices::RouteServices(const ros::NodeHandle& private_node, core::PlaceMemory& memory,
                             Belief belief, const config::Parameters& parameters)
    : memory_(memory), belief_(std::move(belief)), parameters_(parameters), spinner_(1, &queue_) {
  ros::NodeHandle node(private_node);
  node.setCallbackQueue(&queue_);
  servers_.push_back(advertiseGuarded(node, kPlanRouteService, this, &RouteServices::plan));
  servers_.push_back(advertiseGuarded(node, kReportTraversalService, this, &RouteServices::report));
  servers_.push_back(advertiseGuarded(node, kSetLinkService, this, &RouteServices::setLink));
  using Callback = boost::function<bool(nav_msgs::GetPlan::Request&, nav_msgs::GetPlan::Response&)>;
  const Callback make_plan = [this](nav_msgs::GetPlan::Request& request,
                                    nav_msgs::GetPlan::Response& response) {
    try {
      makePlan(request, response);
    } catch (const std::exception& error) {
      ROS_ERROR("make_plan: %s", error.what());
    }
    return true;
  };
  servers_.push_back(node.advertiseService(kMakePlanService, make_plan));
  spinner_.start();
}

RouteServices::~RouteServices() { spinner_.stop(); }

std::optional<core::Pose2d> RouteServices::poseIn(const geometry_msgs::PoseStamped& pose) const {
  const std::string frame = support::withoutLeadingSlashes(pose.header.frame_id);
  if (!frame.empty() && frame != parameters_.map_frame) return std::nullopt;
  const core::Pose2d spot{pose.pose.position.x, pose.pose.position.y, 0.0};
  return spot.isFinite() ? std::optional<core::Pose2d>(spot) : std::nullopt;
}

core::PlaceId RouteServices::idOf(core::PlaceId id, const std::string& label) const {
  const std::optional<core::Place> place =
      id != core::kNoPlace ? memory_.place(id) : memory_.place(label);
  if (place) return place->id;
  throw core::PlaceMemoryError(core::PlaceMemoryError::Reason::kUnknownPlace,
                               id != core::kNoPlace ? "there is no place " + std::to_string(id)
                               : label.empty() ? "neither an id nor a label of a place is given"
                                               : "there is no place with the label that is given");
}

double RouteServices::oddsOf(core::PlaceId from, core::PlaceId to) const {
  const auto [forward, backward] = memory_.linkOdds(std::min(from, to), std::max(from, to));
  return from < to ? forward : backward;
}

void RouteServices::plan(const PlanRoute::Request& request, PlanRoute::Response& response) {
  core::RouteQuery query;
  if (request.start_id != 0 || !request.start_label.empty()) {
    query.start = core::RouteEnd{request.start_id, request.start_label, std::nullopt};
  }
  query.goal = {request.goal_id, request.goal_label, std::nullopt};
  if (request.goal_id == 0 && request.goal_label.empty()) {
    query.goal.pose = poseIn(request.goal_pose);
    if (!query.goal.pose) {
      response.status = PlanRoute::Response::INVALID_POSE;
      response.message =
          "goal_pose must be finite, and in the frame \"" + parameters_.map_frame + "\"";
      return;
    }
  }
  if (!query.start) query.starts = belief_();
  query.second = request.second != 0;
  const core::RoutePlan plan = memory_.plan(query);
  response.status = toStatus(plan.answer.status);
  if (plan.answer.status != Status::kFound) {
    response.message = plan.answer.reason;
    return;
  }
  response.route = toMessage(plan.answer.best, plan.best, parameters_.map_frame);
  response.message = inWords(plan.answer.best, plan.best);
  response.expected_cost = plan.answer.expected_cost;
  response.stranded = plan.answer.stranded;
  if (plan.answer.second) {
    response.second = toMessage(*plan.answer.second, plan.second, parameters_.map_frame);
    response.shared_links = static_cast<std::uint32_t>(plan.answer.shared_links);
  } else if (query.second && plan.best.size() > 1) {
    response.message += "; there is no other route";
  }
}

void RouteServices::report(const ReportTraversal::Request& request,
                           ReportTraversal::Response& response) {
  if (!ros::Time::isValid()) {
    response.status = ReportTraversal::Response::NO_TIME;
    response.message = kNoTimeMessage;
    return;
  }
  core::Traversal traversal;
  traversal.from = idOf(request.from_id, request.from_label);
  traversal.to = idOf(request.to_id, request.to_label);
  traversal.succeeded = request.succeeded != 0;
  traversal.end = request.end.isZero() ? rosNow() : toNanoseconds(request.end);
  traversal.begin = request.begin.isZero() ? traversal.end : toNanoseconds(request.begin);
  traversal.source = request.source;
  memory_.reportTraversal(traversal);
  response.odds = oddsOf(traversal.from, traversal.to);
  response.message = "noted; " + oddsInWords(response.odds);
}

void RouteServices::setLink(const SetLink::Request& request, SetLink::Response& response) {
  static constexpr core::LinkOrder kOrders[] = {core::LinkOrder::kBlock, core::LinkOrder::kUnblock,
                                                core::LinkOrder::kForbid, core::LinkOrder::kToll};
  if (request.action > SetLink::Request::COST) {
    response.status = SetLink::Response::INVALID;
    response.message = "action must be BLOCK, UNBLOCK, FORBID or COST";
    return;
  }
  const core::PlaceId from = idOf(request.from_id, request.from_label);
  const core::PlaceId to = idOf(request.to_id, request.to_label);
  memory_.setLink(from, to, kOrders[request.action], request.cost, request.one_way == 0);
  response.odds = oddsOf(from, to);
  response.message = "noted; " + oddsInWords(response.odds);
}

void RouteServices::makePlan(const nav_msgs::GetPlan::Request& request,
                             nav_msgs::GetPlan::Response& response) {
  response.plan.header.frame_id = parameters_.map_frame;
  const std::optional<core::Pose2d> goal = poseIn(request.goal);
  const bool has_start = !request.start.header.frame_id.empty();
  const std::optional<core::Pose2d> start = poseIn(request.start);
  if (!goal || !start) {
    ROS_WARN("make_plan: start and goal must be finite, and in the frame \"%s\"",
             parameters_.map_frame.c_str());
    return;
  }
  core::RouteQuery query;
  if (has_start) query.start = core::RouteEnd{core::kNoPlace, "", start};
  if (!has_start) query.starts = belief_();
  query.goal.pose = goal;
  query.second = false;
  const core::RoutePlan plan = memory_.plan(query);
  if (plan.answer.status != Status::kFound) {
    ROS_WARN("make_plan: %s", plan.answer.reason.c_str());
    return;
  }
  response.plan = toPath(plan.best, parameters_.map_frame);
  // Beyond the last place the goal itself.
  response.plan.poses.push_back(request.goal);
  response.plan.poses.back().header = response.plan.header;
}

}  // namespace place_memory::node
