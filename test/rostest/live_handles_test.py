#!/usr/bin/env python3
"""The places in rviz that answer to the mouse: interactive markers beside a live node."""

import os

import rospy
from nav_msgs.msg import OccupancyGrid, Path
from visualization_msgs.msg import InteractiveMarkerFeedback, InteractiveMarkerInit, InteractiveMarkerUpdate

import live_test
import sonar_room
from panel import Panel

RECALL, ROUTE, RENAME = 1, 2, 3


class LiveHandlesTest(live_test.LiveTestCase):
    def start(self, **parameters):
        self.start_node(scan__headings=1, markers__clickable=2, **parameters)
        self.handles = self.node.name + "/place_handles"
        self.clicks = rospy.Publisher(self.handles + "/feedback", InteractiveMarkerFeedback,
                                      queue_size=10)
        self.addCleanup(self.clicks.unregister)
        self.hold(lambda: self.clicks.get_num_connections() > 0, "the node to hear clicks")

    def shown(self):
        """Handles by name, as rviz gets them who comes now."""
        init = rospy.wait_for_message(self.handles + "/update_full", InteractiveMarkerInit,
                                      live_test.PATIENCE)
        return {marker.name: marker for marker in init.markers}

    def heard(self, topic, message_type):
        """Messages of a topic, which grow as they come."""
        messages = []
        subscriber = rospy.Subscriber(self.node.name + "/" + topic, message_type, messages.append)
        self.addCleanup(subscriber.unregister)
        return messages

    def click(self, place, entry=None):
        name = "place %d" % place
        if entry is None:
            return self.clicks.publish(marker_name=name, control_name="choose", event_type=(
                InteractiveMarkerFeedback.BUTTON_CLICK))
        return self.clicks.publish(marker_name=name, control_name="choose", menu_entry_id=entry,
                                   event_type=InteractiveMarkerFeedback.MENU_SELECT)

    def learn_two(self):
        self.learn("hall", sonar_room.HALL)
        self.learn("study", sonar_room.STUDY)
        self.hold(lambda: len(self.shown()) == 2, "both places")
        return {marker.description: int(name.split()[1]) for name, marker in self.shown().items()}

    def test_a_click_recalls_the_grid_of_the_place_where_it_lies(self):
        self.start()
        ids = self.learn_two()
        grids = self.heard("matched_grid", OccupancyGrid)
        self.click(ids["hall"])
        self.hold(lambda: any(100 in grid.data or max(grid.data) > 50 for grid in grids), "its grid")
        self.assertEqual(grids[-1].header.frame_id, "map")

    def test_the_menu_plans_a_route(self):
        self.start()
        ids = self.learn_two()
        paths = self.heard("route", Path)
        self.click(ids["hall"], ROUTE)
        self.hold(lambda: paths, "a route")
        self.assertEqual(paths[-1].header.frame_id, "map")
        self.assertEqual(len(paths[-1].poses), 2)  # from the study, where the robot is

    def test_the_panel_renames_the_place_that_is_chosen_in_its_menu(self):
        self.start()
        ids = self.learn_two()
        panel = Panel(os.path.join(self.folder, "panel.log"))
        self.addCleanup(panel.close)
        panel.ask("node", self.node.name)
        self.hold(lambda: "study" in panel.shows("places"), "the panel to know the places")
        self.hold(lambda: self.clicks.get_num_connections() > 1, "the panel to hear clicks")
        self.click(ids["study"], RENAME)
        self.hold(lambda: panel.ask("edits") == "study", "an editor to be open")
        panel.ask("edit", "library")
        self.hold(lambda: self.labels() == ["hall", "library"], "the new name")
        self.hold(lambda: {handle.description for handle in self.shown().values()}
                  == {"hall", "library"}, "the handle to follow")

    def test_places_that_go_lose_their_handles(self):
        self.start()
        ids = self.learn_two()
        gone = []
        subscriber = rospy.Subscriber(self.handles + "/update", InteractiveMarkerUpdate,
                                      lambda update: gone.extend(update.erases))
        self.addCleanup(subscriber.unregister)
        self.hold(lambda: subscriber.get_num_connections() > 0, "updates")
        self.node.call("remove_place", label="hall")
        self.hold(lambda: gone == ["place %d" % ids["hall"]], "the handle to go")

    def test_a_click_on_what_is_no_place_harms_nothing(self):
        self.start()
        ids = self.learn_two()
        paths = self.heard("route", Path)
        self.click(4711)
        self.clicks.publish(marker_name="nonsense", event_type=InteractiveMarkerFeedback.MENU_SELECT,
                            menu_entry_id=99)
        self.click(ids["hall"], 99)
        self.click(ids["hall"], ROUTE)
        self.hold(lambda: paths, "the route that is asked for after them")

    def test_without_the_parameter_there_are_none(self):
        self.start_node(scan__headings=1)
        published = {topic for topic, _ in rospy.get_published_topics(self.node.name)}
        self.assertFalse([topic for topic in published if "place_handles" in topic])


if __name__ == "__main__":
    live_test.main("live_handles_test", LiveHandlesTest)
