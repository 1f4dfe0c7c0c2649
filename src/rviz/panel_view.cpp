#include "rviz/panel_view.h"

#include "rviz/verdict_words.h"

namespace place_memory::panel {
std::string presenceInWords(const PanelView& view) {
  switch (view.presence.kind) {
    case Presence::Kind::kUnknown:
      return "looking for " + view.node;
    case Presence::Kind::kNoMaster:
      return "no ROS master answers";
    case Presence::Kind::kAway:
      return view.node + " does not run, or cannot be reached";
    case Presence::Kind::kThere:
      break;
  }
  return counted(view.places ? view.places->size() : 0, "place");
}

std::string whyNot(const PanelView& view, Command command, bool place_is_chosen) {
  if (view.presence.kind != Presence::Kind::kThere) return presenceInWords(view);
  const auto [kind, name] = interfaceOf(command);
  const bool is_action = kind == Interface::Kind::kAction;
  const auto& offered = is_action ? view.presence.actions : view.presence.services;
  if (offered.count(name) == 0) {
    return view.node + " does not offer ~" + name + (is_action ? ", an action" : ", a service");
  }
  if (view.calls.count(name) == 1) return "waiting for the answer of ~" + name;
  if (view.goals.count(name) == 1) return "~" + name + " is under way";
  if (command == Command::kExplore && !view.mode.empty() && view.mode != "map") {
    return "it explores in mode map alone; the mode is " + view.mode;
  }
  if (needsPlace(command) && !place_is_chosen) return "choose a place in the list";
  return "";
}

}  // namespace place_memory::panel
