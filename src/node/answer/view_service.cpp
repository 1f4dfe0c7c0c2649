#include "node/answer/view_service.h"

#include <cmath>
#include <cstdio>
#include <optional>

#include "node/answer/answer_words.h"
#include "node/answer/guarded_service.h"
#include "node/names/node_names.h"

namespace place_memory::node {
namespace {

using Response = SuggestView::Response;
using Status = core::ViewAdvice::Status;

std::string percent(double probability) {
  return std::to_string(std::lround(100.0 * probability)) + " %";
}

std::string bearingInWords(double bearing) {
  const long degrees = std::lround(std::abs(bearing) * 180.0 / core::kPi);
  if (degrees == 0) return "straight ahead";
  return std::to_string(degrees) +
         (bearing > 0.0 ? " degrees to the left" : " degrees to the right");
}

std::string metres(double distance) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f m", distance);
  return text;
}

/// What is to be done, and what that is expected to bring.
std::string inWords(const Response& response) {
  std::string words;
  if (response.view == Response::TURN) {
    words = "turn, and scan what lies " + bearingInWords(response.turn);
  } else {
    words = "drive " + metres(response.distance) + ", " + bearingInWords(response.turn) +
            (response.way.size() > 1 ? ", and on" : "") + ", to where " +
            quoted(response.labels.back()) + " is if the robot is at " +
            quoted(response.labels.front()) + ", and scan there";
  }
  return words + ": of " + std::to_string(response.candidates) +
         " spots where it may be the likeliest one has " + percent(response.probability) +
         " now, and " + percent(response.expected_probability) + " then, on an average";
}

}  // namespace

ViewService::ViewService(const ros::NodeHandle& private_node, const core::PlaceMemory& memory,
                         const ViewAsker& asker)
    : memory_(memory), asker_(asker), spinner_(1, &queue_) {
  ros::NodeHandle node(private_node);
  node.setCallbackQueue(&queue_);
  server_ = advertiseGuarded(node, kSuggestViewService, this, &ViewService::suggest);
  spinner_.start();
}

ViewService::~ViewService() { spinner_.stop(); }

std::string ViewService::labelOf(core::PlaceId id) const {
  const std::optional<core::Place> place = memory_.place(id);
  return place ? place->label : "place " + std::to_string(id);
}

void ViewService::suggest(const SuggestView::Request& /*request*/, Response& response) {
  if (memory_.size() == 0) {
    response.status = Response::EMPTY_MAP;
    response.message = "the map has no place: learn some, or drive in mode map";
    return;
  }
  const ViewAsker::Asked asked = asker_.ask();
  response.candidates = static_cast<std::uint32_t>(asked.advice.candidates.size());
  if (!asked.advice.candidates.empty()) {
    response.probability = asked.advice.candidates.front().probability;
    response.expected_probability = response.probability;
  }
  switch (asked.advice.status) {
    case Status::kFound:
      fill(asked, response);
      response.message = inWords(response);
      return;
    case Status::kSure:
      response.status = Response::NOT_NEEDED;
      response.message = "it is sure where the robot is: no view is needed";
      return;
    case Status::kNoView:
      response.status = Response::NO_VIEW;
      response.message =
          response.candidates == 1
              ? "it may be at one spot of the map alone, or at none: scan again, or drive on"
              : "no view that can be reached parts the " + std::to_string(response.candidates) +
                    " spots where the robot may be, as the map has them: drive some metres, and "
                    "scan again";
      return;
    case Status::kNoCandidates:
      break;
  }
  response.status = Response::NO_SCAN;
  response.message =
      "nothing that was heard speaks for any place yet: scan and recognize a place, or drive some "
      "metres in mode localize";
}

void ViewService::fill(const ViewAsker::Asked& asked, Response& response) const {
  const core::View& view = *asked.advice.view;
  const core::PoseCandidate& likeliest = asked.advice.candidates.front();
  response.view = view.kind == core::View::Kind::kTurn ? Response::TURN : Response::DRIVE;
  response.turn = view.bearing;
  response.heading_in_odom = core::wrapAngle(asked.odom_from_base.yaw + view.bearing);
  response.heading_in_map = core::wrapAngle(likeliest.map_from_base.yaw + view.bearing);
  for (const core::Pose2d& spot : view.spots) {
    const core::Pose2d in_odom = asked.odom_from_base * spot;
    geometry_msgs::Point point;
    point.x = in_odom.x;
    point.y = in_odom.y;
    response.way.push_back(point);
  }
  if (!view.spots.empty()) {
    response.distance = std::hypot(view.spots.front().x, view.spots.front().y);
  }
  for (const core::PlaceId id : view.places) {
    response.ids.push_back(id);
    response.labels.push_back(labelOf(id));
  }
  response.time = view.time;
  response.expected_probability = view.probability;
  response.information = view.information;
}

}  // namespace place_memory::node
