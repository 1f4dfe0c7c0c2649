#include "node/answer/place_services.h"

#include <ros/console.h>
#include <ros/init.h>
#include <ros/time.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "node/conversions.h"
#include "node/node_names.h"

namespace place_memory::node {
namespace {

using Reason = core::PlaceMemoryError::Reason;

// Two clients who ask at the same time are matched at the same time.
constexpr std::uint32_t kMatchThreads = 2;

// Pi as people write it, such as 3.142, stands for pi.
constexpr double kPiTolerance = 1e-3;

constexpr char kNoScanMessage[] = "there is no scan: call the action ~scan first";
constexpr char kNoTimeMessage[] =
    "use_sim_time is set, but no time has come on /clock yet: start what publishes it";

// The status of each service for a refusal. What a service cannot run into is as good as a store
// that failed: the map is as it was.
template <class Response>
std::uint8_t toStatus(Reason /*reason*/) {
  return Response::STORE_FAILED;
}

template <>
std::uint8_t toStatus<LearnPlace::Response>(Reason reason) {
  switch (reason) {
    case Reason::kLabelTaken:
      return LearnPlace::Response::LABEL_TAKEN;
    case Reason::kInvalidLabel:
      return LearnPlace::Response::INVALID_LABEL;
    case Reason::kInvalidScan:
    case Reason::kWrongCells:
    case Reason::kAlreadyLearned:
      return LearnPlace::Response::INVALID_SCAN;
    default:
      return LearnPlace::Response::STORE_FAILED;
  }
}

template <>
std::uint8_t toStatus<RenamePlace::Response>(Reason reason) {
  switch (reason) {
    case Reason::kLabelTaken:
      return RenamePlace::Response::LABEL_TAKEN;
    case Reason::kInvalidLabel:
      return RenamePlace::Response::INVALID_LABEL;
    case Reason::kUnknownPlace:
      return RenamePlace::Response::UNKNOWN_PLACE;
    default:
      return RenamePlace::Response::STORE_FAILED;
  }
}

template <>
std::uint8_t toStatus<RemovePlace::Response>(Reason reason) {
  return reason == Reason::kUnknownPlace ? RemovePlace::Response::UNKNOWN_PLACE
                                         : RemovePlace::Response::STORE_FAILED;
}

// Makes a change of the map; where the memory refuses it, that is the answer.
template <class Response, class Change>
void change(Response& response, const Change& make_change) {
  try {
    make_change();
  } catch (const core::PlaceMemoryError& error) {
    response.status = toStatus<Response>(error.reason());
    response.message = error.what();
  }
}

// The newest scan; nullptr where there is none, which is then the answer.
template <class Response>
std::shared_ptr<const core::Scan> takeScan(const NewestScan& newest, Response& response) {
  if (!ros::Time::isValid()) {
    response.status = Response::NO_TIME;
    response.message = kNoTimeMessage;
    return nullptr;
  }
  std::shared_ptr<const core::Scan> scan = newest.get();
  if (!scan) {
    response.status = Response::NO_SCAN;
    response.message = kNoScanMessage;
  }
  return scan;
}

std::string quoted(const std::string& label) { return '"' + label + '"'; }

std::string placesInWords(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " place" : " places");
}

std::string percent(double probability) {
  return std::to_string(std::lround(100.0 * probability)) + " %";
}

std::string inWords(const core::PlaceMemory::Answer& answer) {
  const core::Recognition& found = answer.recognition;
  if (found.matches.empty()) return "not recognised: no place was learned yet";
  const std::string best = quoted(answer.labels.front()) + " with probability " +
                           percent(found.matches.front().probability);
  switch (found.verdict) {
    case core::Verdict::kRecognized:
      return "recognised " + best;
    case core::Verdict::kAmbiguous:
      return "ambiguous: the best of " + placesInWords(found.matches.size()) + " is " + best;
    case core::Verdict::kUnknown:
      break;
  }
  return "not recognised: the best of " + placesInWords(found.matches.size()) + " is " + best;
}

}  // namespace

PlaceServices::PlaceServices(const ros::NodeHandle& private_node, const Context& context)
    : context_(context),
      match_spinner_(kMatchThreads, &match_queue_),
      edit_spinner_(1, &edit_queue_) {
  ros::NodeHandle match_node(private_node);
  match_node.setCallbackQueue(&match_queue_);
  advertise(match_node, kRecognizePlaceService, &PlaceServices::recognize);

  ros::NodeHandle edit_node(private_node);
  edit_node.setCallbackQueue(&edit_queue_);
  advertise(edit_node, kLearnPlaceService, &PlaceServices::learn);
  advertise(edit_node, kListPlacesService, &PlaceServices::list);
  advertise(edit_node, kRenamePlaceService, &PlaceServices::rename);
  advertise(edit_node, kRemovePlaceService, &PlaceServices::remove);
  advertise(edit_node, kClearService, &PlaceServices::clear);

  match_spinner_.start();
  edit_spinner_.start();
}

PlaceServices::~PlaceServices() {
  cancelled_ = true;
  match_spinner_.stop();
  edit_spinner_.stop();
}

template <class Request, class Response>
void PlaceServices::advertise(ros::NodeHandle& node, const char* name,
                              void (PlaceServices::*answer)(const Request&, Response&)) {
  using Callback = boost::function<bool(Request&, Response&)>;
  const Callback callback = [this, answer](Request& request, Response& response) {
    (this->*answer)(request, response);
    return true;
  };
  servers_.push_back(node.advertiseService(name, callback));
}

void PlaceServices::learn(const LearnPlace::Request& request, LearnPlace::Response& response) {
  const std::shared_ptr<const core::Scan> scan = takeScan(context_.scan, response);
  if (!scan) return;
  change(response, [&] {
    const core::PlaceMemory::Learned learned = context_.memory.learn(*scan, request.label);
    const core::Place& place = learned.place;
    context_.publisher.publishLearned(place.id);
    response.place_id = place.id;
    response.label = place.label;
    response.message = "learned " + quoted(place.label);
    if (learned.apart) response.message += ", " + learned.message;
    if (!context_.store_problem.empty()) {
      response.message += ", in memory only: " + context_.store_problem;
    }
  });
}

void PlaceServices::recognize(const RecognizePlace::Request& request,
                              RecognizePlace::Response& response) {
  const double asked = request.heading_window == 0.0 ? context_.parameters.match.heading_window
                                                     : request.heading_window;
  const double window = std::min(asked, core::kPi);
  // Written so that NaN fails.
  if (!(asked >= 0.0 && asked <= core::kPi + kPiTolerance)) {
    response.status = RecognizePlace::Response::INVALID_WINDOW;
    response.message = "heading_window must lie in [0, pi] radians";
    return;
  }
  const std::shared_ptr<const core::Scan> scan = takeScan(context_.scan, response);
  if (!scan) return;
  const auto is_cancelled = [this] { return cancelled_ || !ros::ok(); };
  try {
    const auto start = std::chrono::steady_clock::now();
    const core::PlaceMemory::Answer answer = context_.memory.recognize(*scan, window, is_cancelled);
    const std::chrono::duration<double> duration = std::chrono::steady_clock::now() - start;
    response.recognition =
        toMessage(answer, makeHeader(context_.parameters.map_frame, toRosTime(scan->end)),
                  ros::Duration(duration.count()));
    response.message = inWords(answer);
    tellAdaptation(answer);
    if (answer.joined > 0) context_.publisher.publishMap();
    context_.publisher.publishRecognition(*scan, answer, response.recognition);
  } catch (const std::exception& error) {
    response.status =
        is_cancelled() ? RecognizePlace::Response::CANCELED : RecognizePlace::Response::FAILED;
    response.message = error.what();
  }
}

void PlaceServices::tellAdaptation(const core::PlaceMemory::Answer& answer) {
  if (answer.adapted) {
    ROS_INFO("The scan was folded into %s", quoted(answer.labels.front()).c_str());
  }
  if (!answer.adapt_problem.empty()) {
    ROS_WARN("%s is as it was: %s", quoted(answer.labels.front()).c_str(),
             answer.adapt_problem.c_str());
  }
}

void PlaceServices::list(const ListPlaces::Request& /*request*/, ListPlaces::Response& response) {
  for (const core::Place& place : context_.memory.map().places) {
    response.places.push_back(toMessage(place));
  }
  response.message = placesInWords(response.places.size());
}

void PlaceServices::rename(const RenamePlace::Request& request, RenamePlace::Response& response) {
  change(response, [&] {
    context_.memory.rename(request.label, request.new_label);
    context_.publisher.publishMap();
    response.message = "renamed " + quoted(request.label) + " to " + quoted(request.new_label);
  });
}

void PlaceServices::remove(const RemovePlace::Request& request, RemovePlace::Response& response) {
  change(response, [&] {
    context_.memory.remove(request.label);
    context_.publisher.publishMap();
    response.message = "removed " + quoted(request.label);
  });
}

void PlaceServices::clear(const Clear::Request& /*request*/, Clear::Response& response) {
  change(response, [&] {
    const std::size_t count = context_.memory.clear();
    context_.publisher.publishMap();
    response.message = "removed " + placesInWords(count);
  });
}

}  // namespace place_memory::node
