#include "rviz/panel_state.h"

#include <gtest/gtest.h>

#include <string>

#include "rviz/panel_state_fixture.h"

namespace place_memory::panel {
namespace {

TEST_F(PanelStateTest, WhatTheNodeOffersCanBeAskedFor) {
  EXPECT_EQ(why(Command::kScan), "");
  EXPECT_EQ(why(Command::kLearn), "");
}

TEST_F(PanelStateTest, WhatItDoesNotOfferIsNamed) {
  EXPECT_EQ(why(Command::kSave), "/robot/place_memory does not offer ~save, a service");
  EXPECT_EQ(why(Command::kExplore), "/robot/place_memory does not offer ~explore, an action");
}

TEST_F(PanelStateTest, ANodeThatIsAwayIsTheReasonForAll) {
  state_.setPresence(away());
  EXPECT_NE(why(Command::kScan).find("/robot/place_memory does not run"), std::string::npos);
  EXPECT_EQ(why(Command::kSave), why(Command::kScan));
  state_.setPresence(there());
  EXPECT_EQ(why(Command::kScan), "");
}

TEST_F(PanelStateTest, WithoutAMasterThatIsTheReason) {
  Presence presence;
  presence.kind = Presence::Kind::kNoMaster;
  state_.setPresence(presence);
  EXPECT_EQ(why(Command::kScan), "no ROS master answers");
}

TEST_F(PanelStateTest, APlaceMustBeChosenToBeRenamed) {
  EXPECT_EQ(why(Command::kRename, false), "choose a place in the list");
  EXPECT_EQ(why(Command::kRename, true), "");
}

TEST_F(PanelStateTest, APlaceMustBeChosenToBeGoneTo) {
  EXPECT_EQ(why(Command::kGoTo, false), "choose a place in the list");
  EXPECT_EQ(why(Command::kGoTo, true), "");
}

TEST_F(PanelStateTest, ItExploresInModeMapAlone) {
  Presence presence = there();
  presence.actions.insert("explore");
  state_.setPresence(presence);
  state_.setMode("localize");
  EXPECT_EQ(why(Command::kExplore), "it explores in mode map alone; the mode is localize");
  state_.setMode("map");
  EXPECT_EQ(why(Command::kExplore), "");
}

TEST_F(PanelStateTest, OneAnswerIsWaitedForAtATime) {
  state_.beginCall("learn_place");
  EXPECT_EQ(why(Command::kLearn), "waiting for the answer of ~learn_place");
  EXPECT_EQ(why(Command::kRecognize), "");
  state_.endCall("learn_place", "no scan was finished yet", true);
  EXPECT_EQ(why(Command::kLearn), "");
  EXPECT_EQ(state_.view().note.text, "no scan was finished yet");
  EXPECT_TRUE(state_.view().note.is_problem);
}

TEST_F(PanelStateTest, ANodeThatIsStartedAnewIsAskedForItsMap) {
  EXPECT_FALSE(state_.beginGraph());
  state_.setPresence(there("robot:2"));
  EXPECT_TRUE(state_.view().places->empty());
  EXPECT_TRUE(state_.beginGraph());
  EXPECT_FALSE(state_.beginGraph()) << "it was asked for already";
}

TEST_F(PanelStateTest, AMapThatCouldNotBeHadIsNoProblemOnceItComes) {
  state_.setPresence(there("robot:2"));
  ASSERT_TRUE(state_.beginGraph());
  state_.failGraph("~get_graph cannot be reached");
  EXPECT_EQ(state_.view().note.text, "~get_graph cannot be reached");
  ASSERT_TRUE(state_.beginGraph());
  state_.setGraph({});
  EXPECT_EQ(state_.view().note.text, "");
}

TEST_F(PanelStateTest, TheMapIsNotAskedForWhileTheNodeIsAway) {
  state_.setPresence(there("robot:2"));
  state_.setPresence(away());
  EXPECT_FALSE(state_.beginGraph());
}

TEST_F(PanelStateTest, AMapThatWasOvertakenOnItsWayIsAskedForAgain) {
  MapChange change;
  change.version = 9;
  state_.addChange(change);
  EXPECT_TRUE(state_.beginGraph());
  PlaceGraph graph;
  graph.version = 8;
  state_.setGraph(graph);
  EXPECT_TRUE(state_.beginGraph());
  graph.version = 9;
  state_.setGraph(graph);
  EXPECT_FALSE(state_.beginGraph());
}

Recognition makeRecognition(std::uint8_t verdict, int matches) {
  Recognition recognition;
  recognition.verdict = verdict;
  for (int i = 0; i < matches; ++i) {
    PlaceMatch match;
    match.label = "place " + std::to_string(i);
    match.probability = 0.5 / (1 + i);
    recognition.matches.push_back(match);
  }
  return recognition;
}

TEST_F(PanelStateTest, TheForemostMatchesAreShown) {
  state_.setRecognition(makeRecognition(Recognition::RECOGNIZED, 20));
  const PanelView view = state_.view();
  EXPECT_EQ(view.verdict, "Recognized: \"place 0\" with 50 %.");
  ASSERT_EQ(view.matches.size(), 5U);
  EXPECT_EQ(view.matches[1].label, "place 1");
  EXPECT_EQ(view.matches[1].probability, 0.25);
}

TEST_F(PanelStateTest, AnAnswerThatNamesNoPlaceSaysWhyNot) {
  state_.setRecognition(makeRecognition(Recognition::UNKNOWN, 0));
  EXPECT_EQ(state_.view().verdict, "Not recognized: no place was learned yet.");
  state_.setRecognition(makeRecognition(Recognition::UNKNOWN, 3));
  EXPECT_EQ(state_.view().verdict,
            "Not recognized: no place is sure to fit; the best of 3 is \"place 0\" with 50 %.");
  state_.setRecognition(makeRecognition(Recognition::AMBIGUOUS, 3));
  EXPECT_EQ(state_.view().verdict,
            "Ambiguous: some places look alike from here, \"place 0\" with 50 %, \"place 1\" with "
            "25 %. A scan from another spot may part them.");
}

TEST_F(PanelStateTest, TheBeliefIsOfARobotThatDrives) {
  EXPECT_FALSE(state_.view().lost.has_value());
  PlaceBelief belief;
  for (int i = 0; i < 8; ++i) {
    belief.labels.push_back("place " + std::to_string(i));
    belief.probabilities.push_back(0.4 / (1 + i));
  }
  belief.off_map = 0.1;
  belief.p_lost = 0.25;
  state_.setBelief(belief);
  EXPECT_EQ(state_.view().belief.size(), 5U);
  EXPECT_EQ(state_.view().belief[1].probability, 0.2);
  EXPECT_EQ(state_.view().lost, 0.25);
  EXPECT_EQ(state_.view().off_map, 0.1);
  state_.setPresence(away());
  EXPECT_FALSE(state_.view().lost.has_value()) << "nobody says so any more";
}

TEST_F(PanelStateTest, ABeliefThatIsCutShortIsSurvived) {
  PlaceBelief belief;
  belief.labels = {"hall", "lab"};
  belief.probabilities = {0.5};
  state_.setBelief(belief);
  EXPECT_EQ(state_.view().belief.size(), 1U);
}

TEST_F(PanelStateTest, APlaceIsChosenByAClick) {
  visualization_msgs::InteractiveMarkerFeedback click;
  click.marker_name = "place 12";
  click.event_type = click.BUTTON_CLICK;
  state_.hearClick(click);
  EXPECT_EQ(state_.view().chosen.count, 1U);
  EXPECT_EQ(state_.view().chosen.id, 12);
  EXPECT_FALSE(state_.view().chosen.is_to_be_renamed);
  click.event_type = click.MENU_SELECT;
  click.menu_entry_id = 3;
  state_.hearClick(click);
  EXPECT_EQ(state_.view().chosen.count, 2U);
  EXPECT_TRUE(state_.view().chosen.is_to_be_renamed);
}

TEST_F(PanelStateTest, WhatIsNoClickOnAPlaceChoosesNone) {
  visualization_msgs::InteractiveMarkerFeedback click;
  for (const char* name : {"", "place ", "place x", "waypoint 3", "place 99999999999999999999"}) {
    click.event_type = click.BUTTON_CLICK;
    click.marker_name = name;
    state_.hearClick(click);
  }
  click.marker_name = "place 1";
  click.event_type = click.POSE_UPDATE;
  state_.hearClick(click);
  EXPECT_EQ(state_.view().chosen.count, 0U);
}

TEST_F(PanelStateTest, EventsAreSaid) {
  MapEvent event;
  event.kind = MapEvent::CLOSED;
  event.sentence = "a loop was closed";
  state_.addEvent(event);
  EXPECT_EQ(state_.view().note.text, "a loop was closed");
  EXPECT_FALSE(state_.view().note.is_problem);
  event.kind = MapEvent::LOST;
  state_.addEvent(event);
  EXPECT_TRUE(state_.view().note.is_problem);
}

}  // namespace
}  // namespace place_memory::panel
