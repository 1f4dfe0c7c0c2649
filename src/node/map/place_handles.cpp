#include "node/map/place_handles.h"

#include <ros/console.h>
#include <visualization_msgs/InteractiveMarkerControl.h>
#include <visualization_msgs/MenuEntry.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include "node/base/colors.h"
#include "node/map/nearest_places.h"

namespace place_memory::node {
namespace {

using visualization_msgs::InteractiveMarkerControl;
using visualization_msgs::InteractiveMarkerFeedback;
using visualization_msgs::Marker;
using visualization_msgs::MenuEntry;

constexpr double kDiameter = 0.9;  // wider than the spot that is drawn of each place [m]
constexpr double kHeight = 0.02;
constexpr double kLevel = 0.06;  // above all else that is drawn of a place
constexpr float kAlpha = 0.25F;
constexpr double kStep = 5.0;  // of the robot, after which others are nearest [m]

MenuEntry makeEntry(PlaceEntry entry, const std::string& title) {
  MenuEntry menu;
  menu.id = static_cast<std::uint32_t>(entry);
  menu.title = title;
  menu.command_type = MenuEntry::FEEDBACK;
  return menu;
}

std::string handleName(core::PlaceId id) { return kPlaceHandle + std::to_string(id); }

}  // namespace

visualization_msgs::InteractiveMarker toHandle(const core::Place& place,
                                               const std::string& map_frame, bool is_asked) {
  visualization_msgs::InteractiveMarker handle;
  handle.header.frame_id = map_frame;
  handle.name = handleName(place.id);
  handle.description = place.label;
  handle.pose.position.x = place.map_from_place.x;
  handle.pose.position.y = place.map_from_place.y;
  handle.pose.position.z = kLevel;
  handle.pose.orientation.w = 1.0;
  handle.scale = static_cast<float>(kDiameter);
  handle.menu_entries = {makeEntry(PlaceEntry::kRecall, "Recall its grid"),
                         makeEntry(PlaceEntry::kRoute, "Plan a route to it"),
                         makeEntry(PlaceEntry::kRename, "Rename it in the panel")};
  if (is_asked) {
    handle.menu_entries.push_back(makeEntry(PlaceEntry::kConfirm, "The robot is here"));
    handle.menu_entries.push_back(makeEntry(PlaceEntry::kCut, "The robot is not here"));
  }
  Marker disc;
  disc.type = Marker::CYLINDER;
  disc.scale.x = kDiameter;
  disc.scale.y = kDiameter;
  disc.scale.z = kHeight;
  disc.pose.orientation.w = 1.0;
  disc.color = toColor(is_asked ? kLikelyColor : kPlaceColor, kAlpha);
  InteractiveMarkerControl control;
  control.name = "choose";
  control.interaction_mode = InteractiveMarkerControl::BUTTON;
  control.orientation.w = 1.0;
  control.always_visible = 1;
  control.markers = {disc};
  handle.controls = {control};
  return handle;
}

bool PlaceHandles::Shown::operator==(const Shown& other) const {
  return label == other.label && map_from_place.x == other.map_from_place.x &&
         map_from_place.y == other.map_from_place.y && is_asked == other.is_asked;
}

PlaceHandles::PlaceHandles(const ros::NodeHandle& private_node, const core::PlaceMemory& memory,
                           std::size_t count, const std::string& map_frame, OnChoice on_choice)
    : memory_(memory), count_(count), map_frame_(map_frame), on_choice_(std::move(on_choice)) {
  // With a thread of its own: what a click asks for waits for the disk.
  if (count_ == 0) return;
  server_ = std::make_unique<interactive_markers::InteractiveMarkerServer>(
      private_node.resolveName(kPlaceHandlesTopic), "", true);
}

void PlaceHandles::follow(const std::optional<core::Pose2d>& map_from_robot,
                          const std::set<core::PlaceId>& asked) {
  if (!server_) return;
  const core::Pose2d robot = map_from_robot.value_or(around_);
  const bool has_gone = std::hypot(robot.x - around_.x, robot.y - around_.y) >= kStep;
  if (version_ == memory_.version() && !has_gone && asked == asked_) return;
  asked_ = asked;
  show(memory_.map(), robot);
}

/// The nearest, and those that are asked for, which may lie far from where the robot is thought to
/// be.
std::vector<const core::Place*> PlaceHandles::shownOf(const core::MapSnapshot& map,
                                                      const core::Pose2d& map_from_robot) const {
  std::vector<const core::Place*> shown = nearestPlaces(map.places, map_from_robot, count_);
  for (const core::Place& place : map.places) {
    const bool is_shown = std::find(shown.begin(), shown.end(), &place) != shown.end();
    if (asked_.count(place.id) > 0 && !is_shown) shown.push_back(&place);
  }
  return shown;
}

void PlaceHandles::show(const core::MapSnapshot& map, const core::Pose2d& map_from_robot) {
  std::map<core::PlaceId, Shown> wanted;
  for (const core::Place* place : shownOf(map, map_from_robot)) {
    const Shown shown{place->label, place->map_from_place, asked_.count(place->id) > 0};
    wanted.emplace(place->id, shown);
    const auto before = shown_.find(place->id);
    if (before != shown_.end() && before->second == shown) continue;
    server_->insert(toHandle(*place, map_frame_, shown.is_asked),
                    [this](const visualization_msgs::InteractiveMarkerFeedbackConstPtr& feedback) {
                      onFeedback(*feedback);
                    });
  }
  for (const auto& [id, shown] : shown_) {
    if (wanted.count(id) == 0) server_->erase(handleName(id));
  }
  server_->applyChanges();
  shown_ = std::move(wanted);
  version_ = map.version;
  around_ = map_from_robot;
}

void PlaceHandles::onFeedback(const InteractiveMarkerFeedback& feedback) const {
  const bool is_click = feedback.event_type == InteractiveMarkerFeedback::BUTTON_CLICK;
  if (!is_click && feedback.event_type != InteractiveMarkerFeedback::MENU_SELECT) return;
  try {
    const core::PlaceId id =
        std::stoll(feedback.marker_name.substr(std::string(kPlaceHandle).size()));
    on_choice_(id, is_click ? PlaceEntry::kRecall : PlaceEntry{feedback.menu_entry_id});
  } catch (const std::exception& error) {
    ROS_WARN("A click on \"%s\" had no effect: %s", feedback.marker_name.c_str(), error.what());
  }
}

}  // namespace place_memory::node
