"""A place memory node that maps and drives: its actions, services, and the newest it says."""
import rospy
from geometry_msgs.msg import PoseWithCovarianceStamped
from nav_msgs.msg import OccupancyGrid
from place_memory.msg import (ExploreAction, GoToPlaceAction, MapEvent, PlaceBelief,
                              PlaceGraph)
from place_memory.srv import GetGraph, PlanRoute, Relocalize, RenamePlace, SetMode

from demo_tools.calls import Goal, action, expect, service
from demo_tools.planar import compose, pose_of

LOST = 0.5   # probability from which the robot is drawn as lost
FRESH = 3.0  # a pose that is older is not where the robot is [s]


def location_of(place):
    return place.location.x, place.location.y, place.location.theta


def stand_of(place):
    """Where the robot stood that learned it, in the map."""
    return compose(location_of(place), (place.robot.x, place.robot.y, place.robot.theta))


class Mapper:
    """All it says of poses is in the map's frame."""

    def __init__(self, name, check):
        self._name = name
        self._check = check
        self.map = None      # nav_msgs/OccupancyGrid
        self.graph = PlaceGraph()
        self.events = []     # place_memory/MapEvent
        self._belief = None
        self._pose = None
        self._subscribers = [
            rospy.Subscriber(f"{name}/map", OccupancyGrid, self._on_map),
            rospy.Subscriber(f"{name}/place_graph", PlaceGraph, self._on_graph),
            rospy.Subscriber(f"{name}/belief", PlaceBelief, self._on_belief),
            rospy.Subscriber(f"{name}/pose", PoseWithCovarianceStamped, self._on_pose),
            rospy.Subscriber(f"{name}/events", MapEvent, self.events.append)]
        self._explore = action(f"{name}/explore", ExploreAction, check)
        self._go = action(f"{name}/go_to_place", GoToPlaceAction, check)
        self._services = {
            service_name: service(f"{name}/{service_name}", kind, check)
            for service_name, kind in (("get_graph", GetGraph), ("plan_route", PlanRoute),
                                       ("relocalize", Relocalize), ("rename_place", RenamePlace),
                                       ("set_mode", SetMode))}

    def _on_map(self, message):
        self.map = message

    def _on_graph(self, message):
        self.graph = message

    def _on_belief(self, message):
        self._belief = message

    def _on_pose(self, message):
        self._pose = message

    def call(self, service_name, **request):
        """What it answers; DemoError where that is not OK."""
        return expect(self._services[service_name](**request), f"{self._name}/{service_name}")

    def explore(self, goal):
        return Goal(self._explore, goal, f"{self._name}/explore", self._check)

    def go(self, goal):
        return Goal(self._go, goal, f"{self._name}/go_to_place", self._check)

    def pose(self, now):
        """Where it has the robot, and the stamp of that [s]; None while that is not known."""
        message = self._pose
        if message is None or now - message.header.stamp.to_sec() > FRESH or self.is_lost():
            return None
        return pose_of(message.pose.pose), message.header.stamp.to_sec()

    def is_lost(self):
        return self._belief is not None and self._belief.p_lost > LOST

    def believed(self):
        """Ids of the places at which the robot may be, and the probability of each."""
        belief = self._belief
        return list(zip(belief.ids, belief.probabilities)) if belief is not None else []

    def count(self, kind, since=0):
        return sum(event.kind == kind for event in self.events[since:])
