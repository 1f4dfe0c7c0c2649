#ifndef PLACE_MEMORY_TEST_RVIZ_PANEL_STATE_FIXTURE_H
#define PLACE_MEMORY_TEST_RVIZ_PANEL_STATE_FIXTURE_H

#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "rviz/panel_state.h"

namespace place_memory::panel {

using std::chrono::seconds;

constexpr char kNode[] = "/robot/place_memory";
const PanelState::Time kNow = PanelState::Time(seconds(1000));

inline Presence there(const std::string& incarnation = "robot:1") {
  Presence presence;
  presence.kind = Presence::Kind::kThere;
  presence.services = {"learn_place", "recognize_place", "rename_place"};
  presence.actions = {"scan", "go_to_place"};
  presence.incarnation = incarnation;
  return presence;
}

inline Presence away() {
  Presence presence;
  presence.kind = Presence::Kind::kAway;
  return presence;
}

class PanelStateTest : public testing::Test {
 protected:
  PanelStateTest() {
    state_.setPresence(there());
    PlaceGraph graph;
    graph.version = 5;
    graph.places.resize(1);
    graph.places[0].id = 1;
    graph.places[0].label = "hall";
    EXPECT_TRUE(state_.beginGraph());
    state_.setGraph(graph);
  }

  std::string why(Command command, bool place_is_chosen = true) const {
    return whyNot(state_.view(), command, place_is_chosen);
  }

  PanelState state_{kNode};
};

}  // namespace place_memory::panel

#endif  // PLACE_MEMORY_TEST_RVIZ_PANEL_STATE_FIXTURE_H
