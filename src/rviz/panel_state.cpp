#include "rviz/panel_state.h"

#include <actionlib_msgs/GoalStatus.h>

#include <algorithm>
#include <boost/lexical_cast/try_lexical_convert.hpp>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "node/names/node_names.h"
#include "rviz/verdict_words.h"

namespace place_memory::panel {
namespace {

using actionlib_msgs::GoalStatus;

constexpr std::size_t kShownMatches = 5;

bool isOver(const GoalStatus& goal) {
  switch (goal.status) {
    case GoalStatus::PENDING:
    case GoalStatus::ACTIVE:
    case GoalStatus::PREEMPTING:
    case GoalStatus::RECALLING:
      return false;
    default:
      return true;
  }
}

}  // namespace

void PanelState::setPresence(const Presence& presence) {
  using Kind = Presence::Kind;
  const Presence before = view_.presence;
  view_.presence = presence;
  if (before.kind == Kind::kThere && presence.kind != Kind::kThere) {
    breakOff(presenceInWords(view_));
  } else if (presence.kind == Kind::kThere && presence.incarnation != before.incarnation) {
    if (before.kind == Kind::kThere) breakOff(view_.node + " was started anew");
    // Its map may be another one, with versions that begin anew.
    places_.forget();
    wants_graph_ = true;
  }
}

bool PanelState::hasMaster() const {
  const Presence::Kind kind = view_.presence.kind;
  return kind == Presence::Kind::kThere || kind == Presence::Kind::kAway;
}

void PanelState::breakOff(const std::string& reason) {
  if (!view_.goals.empty()) say(view_.goals.begin()->first + " ended: " + reason, true);
  view_.goals.clear();
  view_.belief.clear();
  view_.off_map.reset();
  view_.lost.reset();
  view_.mode.clear();
}

bool PanelState::beginGraph() {
  const bool is_there = view_.presence.kind == Presence::Kind::kThere;
  if (!wants_graph_ || !is_there) return false;
  return view_.calls.insert(node::kGetGraphService).second;
}

void PanelState::setGraph(const PlaceGraph& graph) {
  view_.calls.erase(node::kGetGraphService);
  places_.reset(graph);
  if (view_.note.text == graph_problem_) view_.note = {};
  wants_graph_ = graph.version < newest_version_;  // it was overtaken on its way
}

void PanelState::failGraph(const std::string& message) {
  view_.calls.erase(node::kGetGraphService);
  graph_problem_ = message;
  say(message, true);
}

void PanelState::addChange(const MapChange& change) {
  newest_version_ = change.version;
  if (!places_.apply(change)) wants_graph_ = true;
}

void PanelState::setRecognition(const Recognition& recognition) {
  view_.verdict = verdictInWords(recognition);
  view_.matches.clear();
  for (const PlaceMatch& match : recognition.matches) {
    if (view_.matches.size() == kShownMatches) break;
    view_.matches.push_back({match.label, match.probability});
  }
}

void PanelState::setBelief(const PlaceBelief& belief) {
  view_.belief.clear();
  const std::size_t known = std::min(belief.labels.size(), belief.probabilities.size());
  for (std::size_t i = 0; i < std::min(known, kShownMatches); ++i) {
    view_.belief.push_back({belief.labels[i], belief.probabilities[i]});
  }
  view_.off_map = belief.off_map;
  view_.lost = belief.p_lost;
}

void PanelState::addEvent(const MapEvent& event) {
  switch (event.kind) {
    case MapEvent::DOUBT:
    case MapEvent::TAKEN_BACK:
    case MapEvent::LOST:
    case MapEvent::TROUBLE:
      return say(event.sentence, true);
    default:
      return say(event.sentence, false);
  }
}

void PanelState::hearClick(const visualization_msgs::InteractiveMarkerFeedback& feedback) {
  const bool is_choice = feedback.event_type == feedback.MENU_SELECT;
  if (!is_choice && feedback.event_type != feedback.BUTTON_CLICK) return;
  const auto& name = feedback.marker_name;
  const std::size_t prefix = std::string(node::kPlaceHandle).size();
  std::int64_t id = 0;
  if (name.compare(0, prefix, node::kPlaceHandle) != 0 ||
      !boost::conversion::try_lexical_convert(name.substr(prefix), id)) {
    return;
  }
  const bool renames =
      is_choice && node::PlaceEntry{feedback.menu_entry_id} == node::PlaceEntry::kRename;
  view_.chosen = {view_.chosen.count + 1, id, renames};
}

void PanelState::endCall(const std::string& service, const std::string& message, bool problem) {
  view_.calls.erase(service);
  say(message, problem);
}

void PanelState::sendGoal(const std::string& action, const std::string& id, Time now) {
  RunningGoal goal;
  goal.id = id;
  goal.message = "asked for";
  goal.sent = now;
  view_.goals[action] = goal;
}

void PanelState::hearStatuses(const std::string& action,
                              const actionlib_msgs::GoalStatusArray& statuses, Time now) {
  const auto found = view_.goals.find(action);
  if (found == view_.goals.end()) return;
  RunningGoal& goal = found->second;
  const auto& list = statuses.status_list;
  const auto status = std::find_if(list.begin(), list.end(), [&](const GoalStatus& listed) {
    return listed.goal_id.id == goal.id;
  });
  const bool is_listed = status != list.end();
  goal.answered = goal.answered || is_listed;
  goal.listed = goal.listed || is_listed;
  // A list from before the goal may come late.
  if (!goal.listed || (is_listed && !isOver(*status))) return;
  if (!goal.over) goal.over = now;
  if (is_listed) {
    goal.end = {action + ": " + status->text, status->status != GoalStatus::SUCCEEDED};
  }
}

void PanelState::hearProgress(const std::string& action, const std::string& id,
                              const GoalProgress& progress, Time now) {
  if (ended_[action] == id) return;  // it comes by another topic than the result
  RunningGoal& goal = view_.goals[action];
  if (goal.id != id) {
    goal = {};
    goal.id = id;
    goal.sent = now;
  }
  goal.answered = true;
  goal.message = progress.message;
  goal.fraction = progress.fraction;
  if (!progress.time_left) return;
  // What is done of the longest time that was ever left: a detour does not run the bar backwards.
  goal.longest_left = std::max(goal.longest_left, *progress.time_left);
  const bool is_known = goal.longest_left > 0.0;
  goal.fraction = is_known ? 1.0 - *progress.time_left / goal.longest_left : 1.0;
}

void PanelState::endGoal(const std::string& action, const std::string& id,
                         const std::string& message, bool problem) {
  ended_[action] = id;
  const auto found = view_.goals.find(action);
  // Of a goal that a newer one has overtaken nothing needs to be said.
  if (found != view_.goals.end() && found->second.id != id) return;
  if (found != view_.goals.end()) view_.goals.erase(found);
  say(message, problem);
}

void PanelState::giveUpGoals(Time now) {
  for (auto goal = view_.goals.begin(); goal != view_.goals.end();) {
    const std::optional<Note> word = lastWord(goal->first, goal->second, now);
    if (!word) {
      ++goal;
      continue;
    }
    view_.note = *word;
    if (goal->second.over) ended_[goal->first] = goal->second.id;
    goal = view_.goals.erase(goal);
  }
}

std::optional<Note> PanelState::lastWord(const std::string& action, const RunningGoal& goal,
                                         Time now) const {
  if (goal.over && now - *goal.over >= kResultPatience) {
    return goal.end.value_or(Note{"~" + action + " is over; its result was not heard", true});
  }
  if (goal.answered || now - goal.sent < kGoalPatience) return std::nullopt;
  return Note{view_.node + " has not answered to ~" + action + " within " +
                  std::to_string(kGoalPatience.count()) + " s",
              true};
}

PanelView PanelState::view() const {
  PanelView view = view_;
  view.places = places_.rows();
  return view;
}

}  // namespace place_memory::panel
