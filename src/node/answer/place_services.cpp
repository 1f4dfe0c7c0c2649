#include "node/answer/place_services.h"

#include <ros/console.h>
#include <ros/init.h>
#include <ros/time.h>

#include <algorithm>
#include <chrono>
#include <exception>

#include "node/answer/answer_words.h"
#include "node/answer/guarded_service.h"
#include "node/answer/service_status.h"
#include "node/base/conversions.h"
#include "node/base/ros_time.h"
#include "node/map/map_messages.h"
#include "node/names/node_names.h"

namespace place_memory::node {
namespace {

// Two clients who ask at the same time are matched at the same time.
constexpr std::uint32_t kMatchThreads = 2;

// Pi as people write it, such as 3.142, stands for pi.
constexpr double kPiTolerance = 1e-3;

// The scan that a client asks for, and what should be known of it; without a scan the response is
// the answer.
template <class Response>
ScanChoice takeScan(const KeptScans& scans, std::uint64_t id, Response& response) {
  if (!ros::Time::isValid()) {
    response.status = Response::NO_TIME;
    response.message = kNoTimeMessage;
    return {};
  }
  ScanChoice choice = scans.choose(id, rosNow());
  response.status = toStatus<Response>(choice.problem);
  response.message = choice.message;
  return choice;
}

}  // namespace

PlaceServices::PlaceServices(const ros::NodeHandle& private_node, const Context& context)
    : context_(context),
      match_spinner_(kMatchThreads, &match_queue_),
      edit_spinner_(1, &edit_queue_) {
  ros::NodeHandle match_node(private_node);
  match_node.setCallbackQueue(&match_queue_);
  servers_.push_back(
      advertiseGuarded(match_node, kRecognizePlaceService, this, &PlaceServices::recognize));

  ros::NodeHandle edit_node(private_node);
  edit_node.setCallbackQueue(&edit_queue_);
  servers_.push_back(advertiseGuarded(edit_node, kLearnPlaceService, this, &PlaceServices::learn));
  servers_.push_back(advertiseGuarded(edit_node, kListPlacesService, this, &PlaceServices::list));
  servers_.push_back(
      advertiseGuarded(edit_node, kRenamePlaceService, this, &PlaceServices::rename));
  servers_.push_back(
      advertiseGuarded(edit_node, kRemovePlaceService, this, &PlaceServices::remove));
  servers_.push_back(advertiseGuarded(edit_node, kClearService, this, &PlaceServices::clear));
  servers_.push_back(advertiseGuarded(edit_node, kGetGraphService, this, &PlaceServices::getGraph));

  match_spinner_.start();
  edit_spinner_.start();
}

PlaceServices::~PlaceServices() {
  cancelled_ = true;
  match_spinner_.stop();
  edit_spinner_.stop();
}

void PlaceServices::learn(const LearnPlace::Request& request, LearnPlace::Response& response) {
  const ScanChoice choice = takeScan(context_.scans, request.scan_id, response);
  if (!choice.scan) return;
  const core::PlaceMemory::Learned learned =
      context_.driver.learn(*choice.scan, request.label, request.force != 0);
  context_.publisher.overtake();
  response.place_id = learned.place.id;
  response.label = learned.place.label;
  response.session = learned.place.session;
  response.apart = static_cast<std::uint8_t>(learned.apart);
  response.message = "learned " + quoted(learned.place.label);
  if (learned.apart) response.message += "; " + learned.message;
  if (!context_.store_problem.empty()) {
    response.message += ", in memory only: " + context_.store_problem;
  }
  if (!choice.message.empty()) response.message += "; " + choice.message;
  ROS_INFO("Scan %lu: %s", static_cast<unsigned long>(choice.scan->id), response.message.c_str());
}

void PlaceServices::recognize(const RecognizePlace::Request& request,
                              RecognizePlace::Response& response) {
  const double asked = request.heading_window;
  // Written so that NaN fails.
  if (!(asked >= 0.0 && asked <= core::kPi + kPiTolerance)) {
    response.status = RecognizePlace::Response::INVALID_WINDOW;
    response.message = "heading_window must lie in [0, pi] radians";
    return;
  }
  const ScanChoice choice = takeScan(context_.scans, request.scan_id, response);
  if (!choice.scan) return;
  match(*choice.scan,
        asked == 0.0 ? std::nullopt : std::optional<double>(std::min(asked, core::kPi)), response);
  if (!choice.message.empty()) response.message += "; " + choice.message;
}

void PlaceServices::match(const core::Scan& scan, std::optional<double> window,
                          RecognizePlace::Response& response) {
  const auto is_cancelled = [this] { return cancelled_ || !ros::ok(); };
  const auto start = std::chrono::steady_clock::now();
  try {
    const core::PlaceMemory::Answer answer = context_.memory.recognize(scan, window, is_cancelled);
    const std::chrono::duration<double> duration = std::chrono::steady_clock::now() - start;
    response.recognition =
        toMessage(answer, makeHeader(context_.parameters.map_frame, toRosTime(scan.end)),
                  ros::Duration(duration.count()));
    response.message = inWords(answer);
    // Nobody else says how far odometry's yaw is off; the parameter is pi then.
    if (context_.parameters.heading_topic.empty()) {
      response.message += window.value_or(core::kPi) == core::kPi
                              ? "; without a compass any heading was tried"
                              : "; headings near odometry's yaw were tried";
    }
    if (const auto belief = context_.driver.belief()) {
      response.belief = context_.drive_publisher.toMessage(*belief, scan.end);
    }
    context_.publisher.publish(scan, answer, response.recognition);
    if (answer.recognition.verdict == core::Verdict::kRecognized) {
      const core::PlaceMatch& best = answer.recognition.matches.front();
      context_.examiner.add(scan, best.id, best.place_from_scan);
    }
    ROS_INFO("Scan %lu: %s", static_cast<unsigned long>(scan.id), response.message.c_str());
  } catch (const std::exception& error) {
    if (!is_cancelled()) throw;
    response.status = RecognizePlace::Response::CANCELED;
    response.message = error.what();
  }
}

void PlaceServices::list(const ListPlaces::Request& /*request*/, ListPlaces::Response& response) {
  const core::MapSnapshot map = context_.memory.map();
  response.places.reserve(map.places.size());
  for (const core::Place& place : map.places) response.places.push_back(toMessage(place));
  response.message = placesInWords(response.places.size());
}

void PlaceServices::getGraph(const GetGraph::Request& /*request*/, GetGraph::Response& response) {
  response.graph = toMessage(context_.memory.map(), context_.parameters.map_frame);
  response.message = placesInWords(response.graph.places.size()) + ", " +
                     std::to_string(response.graph.links.size()) + " links";
}

void PlaceServices::rename(const RenamePlace::Request& request, RenamePlace::Response& response) {
  context_.driver.rename(request.label, request.new_label);
  context_.publisher.publishCurrentPlace();
  response.message = "renamed " + quoted(request.label) + " to " + quoted(request.new_label);
}

void PlaceServices::remove(const RemovePlace::Request& request, RemovePlace::Response& response) {
  context_.driver.remove(request.label);
  context_.publisher.publishCurrentPlace();
  response.message = "removed " + quoted(request.label);
}

void PlaceServices::clear(const Clear::Request& /*request*/, Clear::Response& response) {
  const std::size_t count = context_.driver.clear();
  context_.publisher.overtake();
  response.message = "removed " + placesInWords(count);
}

}  // namespace place_memory::node
