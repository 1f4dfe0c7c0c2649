#include "tools/node_source.h"

#include <actionlib/client/simple_action_client.h>
#include <place_memory/Export.h>
#include <place_memory/GetGraph.h>
#include <place_memory/LearnPlace.h>
#include <place_memory/Merge.h>
#include <place_memory/PlanRoute.h>
#include <place_memory/RecognizePlace.h>
#include <place_memory/ScanPlaceAction.h>
#include <place_memory/Undo.h>
#include <ros/init.h>
#include <ros/master.h>
#include <ros/names.h>
#include <ros/node_handle.h>
#include <ros/service.h>
#include <ros/spinner.h>

#include <algorithm>
#include <cmath>

#include "tools/node_drive.h"

namespace place_memory::tools {
namespace {

const ros::Duration kPatience(5.0);  // until a service or the action is there
const ros::Duration kScanPatience(
    600.0);  // until a scan has ended, by its own time-out at the latest

std::chrono::nanoseconds toCore(const ros::Time& time) {
  return std::chrono::nanoseconds(static_cast<std::int64_t>(time.toNSec()));
}

core::Pose2d toCore(const geometry_msgs::Pose2D& pose) { return {pose.x, pose.y, pose.theta}; }

core::LinkDirection toCore(const Traversals& traversals) {
  core::LinkDirection direction;
  direction.succeeded = traversals.succeeded;
  direction.failed = traversals.failed;
  direction.last = toCore(traversals.last);
  return direction;
}

core::Place toCore(const Place& message) {
  core::Place place;
  place.id = message.id;
  std::copy(message.identity.begin(), message.identity.end(), place.identity.begin());
  place.label = message.label;
  place.map_from_place = toCore(message.location);
  place.learned = toCore(message.learned);
  place.session = message.session;
  place.place_from_robot = toCore(message.robot);
  return place;
}

core::PlaceLink toCore(const PlaceLink& message) {
  core::PlaceLink link;
  link.first = message.first_id;
  link.second = message.second_id;
  link.first_from_second = toCore(message.transform);
  std::copy(message.covariance.begin(), message.covariance.end(), link.covariance.begin());
  link.forward = toCore(message.forward);
  link.backward = toCore(message.backward);
  return link;
}

}  // namespace

NodeSource::NodeSource(const std::string& name) {
  ros::VP_string no_remappings;
  ros::init(no_remappings, "place_memory_command",
            ros::init_options::AnonymousName | ros::init_options::NoSigintHandler |
                ros::init_options::NoRosout);
  if (!ros::master::check()) {
    throw CommandError("no ROS master answers at " + ros::master::getURI(), kNoAnswer);
  }
  std::string error;
  if (!ros::names::validate(name, error)) throw CommandError("--node: " + error);
  ros_ = std::make_unique<ros::NodeHandle>();
  name_ = ros_->resolveName(name);
}

NodeSource::~NodeSource() { ros::shutdown(); }

template <class Service>
typename Service::Response NodeSource::ask(const char* service,
                                           const typename Service::Request& request) {
  const std::string name = name_ + "/" + service;
  if (!ros::service::waitForService(name, kPatience)) {
    throw CommandError(
        "there is no service " + name + ": is the node running, and called " + name_ + "?",
        kNoAnswer);
  }
  typename Service::Response response;
  typename Service::Request asked = request;
  if (!ros::service::call(name, asked, response)) {
    throw CommandError("the node did not answer on " + name, kNoAnswer);
  }
  return response;
}

template <class Service>
typename Service::Response NodeSource::call(const char* service,
                                            const typename Service::Request& request) {
  const typename Service::Response response = ask<Service>(service, request);
  if (response.status != Service::Response::OK) throw CommandError(response.message);
  return response;
}

core::MapSnapshot NodeSource::map() {
  const PlaceGraph graph = call<GetGraph>("get_graph", {}).graph;
  core::MapSnapshot map;
  map.version = graph.version;
  map.stamp = toCore(graph.header.stamp);
  for (const Place& place : graph.places) map.places.push_back(toCore(place));
  for (const PlaceLink& link : graph.links) map.links.push_back(toCore(link));
  return map;
}

core::EvidenceGrid NodeSource::grid(core::PlaceId /*id*/) {
  throw CommandError(
      "grids are read from a store: ask the node for a copy by its service save, and "
      "name that by --store");
}

void NodeSource::scan() {
  actionlib::SimpleActionClient<ScanPlaceAction> client(name_ + "/scan", true);
  if (!client.waitForServer(kPatience)) {
    throw CommandError("there is no action " + name_ + "/scan", kNoAnswer);
  }
  client.sendGoal(ScanPlaceGoal());
  if (!client.waitForResult(kScanPatience)) {
    throw CommandError("the scan has not ended", kNoAnswer);
  }
  const auto result = client.getResult();
  if (result->status != ScanPlaceResult::SUCCEEDED) throw CommandError(result->message);
}

std::string NodeSource::learn(const std::string& label, const ScanChoice& choice) {
  if (choice.scan_now) scan();
  LearnPlace::Request request;
  request.label = label;
  return call<LearnPlace>("learn_place", request).message;
}

Recognized NodeSource::recognize(const ScanChoice& choice) {
  if (choice.scan_now) scan();
  const RecognizePlace::Response response = call<RecognizePlace>("recognize_place", {});
  const Recognition& recognition = response.recognition;
  Recognized result;
  result.verdict = core::nameOf(static_cast<core::Verdict>(recognition.verdict));
  result.message = response.message;
  const auto& pose = recognition.pose.pose;
  result.map_from_robot = {pose.position.x, pose.position.y,
                           2.0 * std::atan2(pose.orientation.z, pose.orientation.w)};
  for (const PlaceMatch& match : recognition.matches) {
    result.matches.push_back(
        {match.label, match.probability, match.score, toCore(match.transform)});
  }
  return result;
}

DrivenGoal NodeSource::go(const std::string& label, const Progress& progress) {
  return driveTo(name_, label, progress);
}

PlannedRoute NodeSource::plan(const std::string& from, const std::string& to) {
  PlanRoute::Request request;
  request.start_label = from;
  request.goal_label = to;
  const auto response = ask<PlanRoute>("plan_route", request);
  PlannedRoute route;
  if (response.status == PlanRoute::Response::FAILED) throw CommandError(response.message);
  if (response.status != PlanRoute::Response::OK) route.problem = response.message;
  route.labels = response.route.labels;
  route.cost = response.route.cost;
  route.odds = response.route.odds;
  return route;
}

std::string NodeSource::exportTo(const std::string& folder) {
  Export::Request request;
  request.path = folder;
  return call<Export>("export", request).message;
}

std::string NodeSource::merge(const std::string& path, std::vector<std::string>& collisions) {
  Merge::Request request;
  request.path = path;
  const Merge::Response response = call<Merge>("merge", request);
  collisions = response.collisions;
  return response.message;
}

std::vector<core::PastChange> NodeSource::undo(std::size_t count, bool look) {
  Undo::Request request;
  request.count = static_cast<std::uint32_t>(count);
  request.look = static_cast<std::uint8_t>(look);
  const Undo::Response response = call<Undo>("undo", request);
  std::vector<core::PastChange> changes;
  for (std::size_t i = 0; i < response.changes.size(); ++i) {
    core::PastChange change;
    change.stamp = toCore(response.stamps[i]);
    change.words = response.changes[i];
    changes.push_back(change);
  }
  return changes;
}

std::vector<core::PastChange> NodeSource::history(std::size_t count) { return undo(count, true); }
std::vector<core::PastChange> NodeSource::undo(std::size_t count) { return undo(count, false); }

}  // namespace place_memory::tools
