#ifndef PLACE_MEMORY_RVIZ_PANEL_STATE_H
#define PLACE_MEMORY_RVIZ_PANEL_STATE_H

#include <actionlib_msgs/GoalStatusArray.h>
#include <place_memory/MapChange.h>
#include <place_memory/MapEvent.h>
#include <place_memory/PlaceBelief.h>
#include <place_memory/PlaceGraph.h>
#include <place_memory/Recognition.h>
#include <visualization_msgs/InteractiveMarkerFeedback.h>

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "rviz/goal_progress.h"
#include "rviz/panel_view.h"
#include "rviz/place_list.h"

namespace place_memory::panel {

/// The node has so long to say something of a goal.
constexpr std::chrono::seconds kGoalPatience(5);
/// The result of a goal that is over may come so much later. It may have been sent before the
/// subscriber's connection stood: then it never comes.
constexpr std::chrono::seconds kResultPatience(1);

/// What the messages of one node say, for whoever shows it.
class PanelState {
 public:
  using Time = std::chrono::steady_clock::time_point;

  explicit PanelState(const std::string& node) { view_.node = node; }

  /// A node that is gone, or another one by the same name, ends what was under way.
  void setPresence(const Presence& presence);
  /// A ROS master has answered, when it was asked last.
  bool hasMaster() const;

  /// True where the whole map is to be asked for now; setGraph() or failGraph() is the answer.
  bool beginGraph();
  void setGraph(const PlaceGraph& graph);
  void failGraph(const std::string& message);
  void addChange(const MapChange& change);

  void setRecognition(const Recognition& recognition);
  void setBelief(const PlaceBelief& belief);
  /// Its sentence is said; a problem are doubts, being lost, and what cannot be kept.
  void addEvent(const MapEvent& event);
  /// A person has clicked a place in rviz, or chosen of its menu.
  void hearClick(const visualization_msgs::InteractiveMarkerFeedback& feedback);
  void setMode(const std::string& mode) { view_.mode = mode; }

  void beginCall(const std::string& service) { view_.calls.insert(service); }
  /// `problem`: what is said is not what was asked for.
  void endCall(const std::string& service, const std::string& message, bool problem);

  void sendGoal(const std::string& action, const std::string& id, Time now);
  /// What the node says, again and again, of the goals that it knows.
  void hearStatuses(const std::string& action, const actionlib_msgs::GoalStatusArray& statuses,
                    Time now);
  void hearProgress(const std::string& action, const std::string& id, const GoalProgress& progress,
                    Time now);
  void endGoal(const std::string& action, const std::string& id, const std::string& message,
               bool problem);
  /// Gives up the goals of which the node has said nothing for too long, and ends those that are
  /// over though no result came.
  void giveUpGoals(Time now);

  void say(const std::string& sentence, bool problem) { view_.note = {sentence, problem}; }

  PanelView view() const;

 private:
  void breakOff(const std::string& reason);
  /// Where the goal is to be shown no longer.
  std::optional<Note> lastWord(const std::string& action, const RunningGoal& goal, Time now) const;

  PanelView view_;  // without the places
  PlaceList places_;
  std::map<std::string, std::string> ended_;  // newest goal of each action that ended
  std::uint64_t newest_version_ = 0;          // of the map, as the newest change has it
  bool wants_graph_ = true;
  std::string graph_problem_;  ///< that was said last; the map is asked for again by itself
};

}  // namespace place_memory::panel

#endif  // PLACE_MEMORY_RVIZ_PANEL_STATE_H
