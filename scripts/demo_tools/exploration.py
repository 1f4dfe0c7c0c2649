"""A robot that explores a building, is carried, finds itself, and goes to places while a door
closes."""
import math
import os

from place_memory.msg import (ExploreGoal, ExploreResult, GoToPlaceGoal, GoToPlaceResult,
                              MapEvent)

from demo_tools.driver import Driver
from demo_tools.errors import DemoError
from demo_tools.film import Film
from demo_tools.mapper import Mapper, stand_of
from demo_tools.planar import aligning, compose, crosses, distance, pose_of
from demo_tools.session import say
from demo_tools.stages import Stage, row, write_csv
from demo_tools.truth import Truth
from demo_tools.waiting import wait_until

NODE = "place_memory"
TRIES = 3            # goals of an action, where one ends before it is done
EXPLORE_LIMIT = 900.0  # of real time [s]
GO_LIMIT = 300.0       # likewise
FOUND_LIMIT = 60.0     # likewise, for what the node says of where the robot is
AT_HOME = 1.0        # so near to where it began it is home [m]
NAMED_NEAR = 2.0     # a place has the name of a spot so near [m]
RIGHT = 0.75         # where the robot is known wrongly by more, it is wrong [m]
ASKS_AFTER = 6.0     # way after which somebody asks where the robot is, if it did not notice [m]
# Of the animation's moments, of simulated time [s].
EXPLORE_PACE, LED_PACE, PACE = 10.0, 6.0, 3.0


def is_passed(way, door):
    return any(distance(one, other) < 3.0 and crosses(one, other, door["hinge"], door["latch"])
               for one, other in zip(way, way[1:]))


class Demonstration:
    """Runs on a master where demo_explore.launch has been started."""

    def __init__(self, building, check):
        self._building = building
        self._check_nodes = check
        self.film = None
        self.truth = Truth(self._check)
        self._driver = Driver(self._check)
        self._mapper = Mapper(NODE, self._check)
        self.film = Film(self.truth, self._mapper)
        self._begin = self.truth.pose()
        # As the robot begins; better once there are places.
        self._world_from_map = self._begin
        self.stages = []

    # Whoever waits calls it again and again.
    def _check(self):
        self._check_nodes()
        if self.film:
            self.film.take_if_due()

    def run(self):
        for title, pace, tell in (
                ("explores, with an empty map", EXPLORE_PACE, self._explore),
                ("is led around once", LED_PACE, self._be_led),
                ("is carried, and finds itself", PACE, self._find_itself),
                (f"goes to {self._building['first_goal']}", PACE, self._go),
                (f"goes to {self._building['second_goal']}, and a door closes", PACE,
                 self._go_around)):
            self.film.begin(f"{len(self.stages) + 1}. The robot {title}", pace)
            since, way = self.truth.time(), self.truth.way
            what, error = tell()
            self.stages.append(Stage(title, what, self.truth.time() - since,
                                     self.truth.way - way, error))
            say(row(self.stages[-1]))
        self.film.take()

    def write(self, folder):
        write_csv(os.path.join(folder, "explore.csv"), self.stages)
        self.film.write(os.path.join(folder, "explore.gif"), os.path.join(folder, "explore.png"))

    # --- the stages: each returns what happened, and the error [m] ---

    def _explore(self):
        for tries in range(1, TRIES + 1):
            goal = self._mapper.explore(ExploreGoal(
                most_distance=self._building["most_distance"]))

            def is_over(goal=goal):
                if goal.feedback:
                    self.film.words = (f"It {goal.feedback.message.split(':')[0]}; "
                                       f"{goal.feedback.distance:.0f} m driven")
                return goal.is_over()
            wait_until(is_over, "the exploration", EXPLORE_LIMIT, self._check)
            result = goal.result(GO_LIMIT)
            if result.status in (ExploreResult.DONE, ExploreResult.BOUND_REACHED):
                break
        else:
            raise DemoError(f"exploring: {result.message}")
        graph = self._graph()
        least = self._building["least_places"]
        if len(graph.places) < least:
            raise DemoError(f"exploring made {len(graph.places)} places, not even {least}")
        error = self._align(graph.places)
        loops = self._mapper.count(MapEvent.CLOSED)
        is_home = distance(self.truth.pose(), self._begin) < AT_HOME
        return (f"{len(graph.places)} places, {len(graph.links)} links, {loops} loops closed, "
                f"{'home again' if is_home else 'not home'}"
                f"{'' if tries == 1 else f', in {tries} goals'}", error)

    def _be_led(self):
        """Where somebody drives the robot links learn, too."""
        self.film.words = "Somebody drives it through the doors, to where its links leave gaps"
        self._driver.follow(self._building["led_along"], lambda: False)
        self._mapper.call("set_mode", mode="localize")  # keeps the map as it lies now
        graph = self._graph()
        error = self._align(graph.places)
        self._name(graph.places)
        return f"{len(graph.places)} places, {len(graph.links)} links", error

    def _find_itself(self):
        x, y, yaw = self._building["carried_to"]
        since, way = len(self._mapper.events), self.truth.way
        self.truth.carry(x, y, yaw)
        self.film.words = "It was lifted and put elsewhere; somebody drives it on"
        lost_after = []
        asked = []

        def is_found():
            driven = self.truth.way - way
            if not lost_after and self._mapper.count(MapEvent.LOST, since):
                lost_after.append(driven)
                self.film.words = f"After {driven:.1f} m it notices that it was carried"
            if not lost_after and not asked and driven > ASKS_AFTER:
                asked.append(driven)
                self._mapper.call("relocalize")
            return ((lost_after or asked) and self._mapper.count(MapEvent.FOUND, since) > 0
                    and self._error() is not None)

        if not self._driver.follow(self._building["then_driven"], is_found):
            raise DemoError(f"the robot was carried, and did not find itself in "
                            f"{self.truth.way - way:.0f} m")
        driven = self.truth.way - way
        self.film.words = f"After {driven:.1f} m it knows where it is"
        noticed = (f"noticed after {lost_after[0]:.1f} m" if lost_after else
                   f"asked after {asked[0]:.1f} m")
        return f"{noticed}, known after {driven:.1f} m", self._right_error("finds itself")

    def _go(self):
        return self._go_to(self._building["first_goal"], lambda: None)[0]

    def _go_around(self):
        label = self._building["second_goal"]
        door = self._door_on_the_way(label)
        steps = len(self.truth.track)

        def close():
            self.truth.set_door(door["name"], False)
            self.film.barred = (door["hinge"], door["latch"])
            say(f"  {door['name']} closes")

        (what, error), tried = self._go_to(label, close)
        if not tried:
            raise DemoError(f"{door['name']} was closed, and the robot did not meet it")
        track = self.truth.track[steps:]
        passed = [other["name"] for other in self._building["doors"] if is_passed(track, other)]
        if not passed:
            raise DemoError(f"the robot reached {label}, but through none of the other doors")
        return f"{door['name']} was closed, so by {' and '.join(passed)}; {what}", error

    def _go_to(self, label, meanwhile):
        """`meanwhile` is called once the robot is on its way."""
        self.film.goal = self._stand(label)
        tried, legs, begun = [], 0, []
        for goals in range(1, TRIES + 1):
            result = self._drive_to(label, meanwhile, begun)
            tried += result.tried
            legs += result.legs
            if result.status == GoToPlaceResult.REACHED:
                break
            # What it found blocked for this goal it tries again for the next one.
            if result.status not in (GoToPlaceResult.NO_ROUTE, GoToPlaceResult.BLOCKED):
                break
        if result.status != GoToPlaceResult.REACHED:
            raise DemoError(f"the robot is not at {label}: {result.message}")
        what = (f"reached in {legs} legs" + (f", {len(tried)} found blocked" if tried else "") +
                (f", in {goals} goals" if goals > 1 else ""))
        return (what, self._right_error(f"goes to {label}")), tried

    def _drive_to(self, label, meanwhile, begun):
        goal = self._mapper.go(GoToPlaceGoal(label=label))

        def is_over():
            if goal.feedback:
                if not begun:
                    begun.append(True)
                    meanwhile()
                self.film.words = (f"It {goal.feedback.message}; "
                                   f"legs that are left: {goal.feedback.legs_left}")
            return goal.is_over()

        wait_until(is_over, f"the way to {label}", GO_LIMIT, self._check)
        return goal.result(GO_LIMIT)

    # --- what it needs to know for that ---

    def _align(self, places):
        """How the map lies in the world; returns how far its places are off [m], the root of the
        mean square."""
        pairs = [(stand_of(place)[:2], self.truth.pose_at(place.learned.to_sec())[:2])
                 for place in places]
        self._world_from_map = aligning(pairs)
        left = [distance(compose(self._world_from_map, (x, y, 0.0)), true)
                for (x, y), true in pairs]
        return math.sqrt(sum(error * error for error in left) / len(left))

    def _graph(self):
        return self._mapper.call("get_graph").graph

    def _in_world(self, place):
        return compose(self._world_from_map, stand_of(place))

    def _nearest(self, places, spot):
        return min(places, key=lambda place: distance(self._in_world(place), spot))

    def _name(self, places):
        for name, spot in self._building["names"].items():
            nearest = self._nearest(places, spot)
            off = distance(self._in_world(nearest), spot)
            if off > NAMED_NEAR:
                raise DemoError(f"no place is near {name}: the nearest is {off:.1f} m off")
            self._mapper.call("rename_place", label=nearest.label, new_label=name)

    def _stand(self, label):
        return next(stand_of(place) for place in self._graph().places if place.label == label)

    def _door_on_the_way(self, label):
        poses = self._mapper.call("plan_route", goal_label=label).route.path.poses
        way = [compose(self._world_from_map, pose_of(pose.pose)) for pose in poses]
        for door in self._building["doors"]:
            if is_passed([self.truth.pose()] + way, door):
                return door
        raise DemoError(f"the way to {label} leads through none of the doors that could be closed")

    def _error(self):
        """How far from the robot the node has it [m]; None while it does not say."""
        known = self._mapper.pose(self.truth.time())
        if known is None:
            return None
        pose, stamp = known
        return distance(compose(self._world_from_map, pose), self.truth.pose_at(stamp))

    def _right_error(self, what):
        error = wait_until(lambda: [self._error()] if self._error() is not None else None,
                           "where the robot is on the map", FOUND_LIMIT, self._check)[0]
        if error > RIGHT:
            raise DemoError(f"the robot {what}, but is {error:.2f} m from where the map has it")
        return error
