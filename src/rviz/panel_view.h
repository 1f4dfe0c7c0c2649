#ifndef PLACE_MEMORY_RVIZ_PANEL_VIEW_H
#define PLACE_MEMORY_RVIZ_PANEL_VIEW_H

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "rviz/command.h"
#include "rviz/place_list.h"
#include "rviz/presence.h"

namespace place_memory::panel {

struct LabelledProbability {
  std::string label;
  double probability = 0.0;

  bool operator==(const LabelledProbability& other) const {
    return label == other.label && probability == other.probability;
  }
};

/// A sentence for the person at the screen.
struct Note {
  std::string text;
  bool is_problem = false;
};

/// A goal of an action that is under way, whoever asked for it.
struct RunningGoal {
  std::string id;
  std::optional<double> fraction;  ///< that is done, in [0, 1]; nothing: that is not known
  double longest_left = 0.0;       ///< of the times that it was said to take still [s]
  std::string message;
  bool answered = false;                       ///< the node has said something of it
  bool listed = false;                         ///< among the goals that the node knows
  std::chrono::steady_clock::time_point sent;  ///< or first heard of
  /// Since then the node says that it does not run, and its result has not come.
  std::optional<std::chrono::steady_clock::time_point> over;
  std::optional<Note> end;  ///< what the node says of that
};

/// A place that was chosen elsewhere than in the list.
struct ChosenPlace {
  std::uint64_t count = 0;  ///< of choices: another one each time
  std::int64_t id = 0;
  bool is_to_be_renamed = false;
};

/// All that the panel shows.
struct PanelView {
  std::string node;
  Presence presence;
  std::map<std::string, RunningGoal> goals;  ///< by action
  std::set<std::string> calls;               ///< services whose answer has not come yet
  std::string verdict;                       ///< newest answer, in words
  std::vector<LabelledProbability> matches;  ///< its foremost
  std::vector<LabelledProbability> belief;   ///< likewise
  std::optional<double> off_map;             ///< probability of being at none of the places
  std::optional<double> lost;                ///< probability that the robot is lost
  std::string mode;                          ///< empty: not known
  std::shared_ptr<const PlaceRows> places;
  ChosenPlace chosen;
  Note note;
};

/// In a sentence, how the node is there or not.
std::string presenceInWords(const PanelView& view);

/// Why a command cannot be given now; empty: it can.
std::string whyNot(const PanelView& view, Command command, bool place_is_chosen);

}  // namespace place_memory::panel

#endif  // PLACE_MEMORY_RVIZ_PANEL_VIEW_H
