"""A place memory node: its action, services and grids."""
import rospy
from actionlib_msgs.msg import GoalStatus
from nav_msgs.msg import OccupancyGrid
from place_memory.msg import Recognition, ScanPlaceAction, ScanPlaceGoal, ScanPlaceResult
from place_memory.srv import LearnPlace, LearnPlaceResponse, RecognizePlace, RecognizePlaceResponse

from demo_tools.calls import START_LIMIT, action, service
from demo_tools.errors import DemoError
from demo_tools.waiting import wait_until

SCAN_LIMIT = 90.0   # of real time [s]

# Of simulated time, which outruns a node on a busy machine.
SCAN_TIMEOUT = rospy.Duration(600.0)

VERDICTS = {Recognition.UNKNOWN: "unknown", Recognition.AMBIGUOUS: "ambiguous",
            Recognition.RECOGNIZED: "recognized"}


class Memory:
    """One node; every call waits for its answer and ends in DemoError where it is no success."""

    def __init__(self, name, check):
        self._name = name
        self._check = check
        self._grid = None
        self._subscriber = rospy.Subscriber(f"{name}/scan_grid", OccupancyGrid, self._on_grid)
        self._scan = action(f"{name}/scan", ScanPlaceAction, check)
        self._learn = service(f"{name}/learn_place", LearnPlace, check)
        self._recognize = service(f"{name}/recognize_place", RecognizePlace, check)

    def _on_grid(self, grid):
        self._grid = grid

    def begin_scan(self):
        """Asks for a scan while something else turns the robot. Returns, once the node has taken
        the goal, a function that waits for the scan's end and returns its grid."""
        handle = self._scan.send_goal(ScanPlaceGoal(turn=ScanPlaceGoal.TURN_LISTEN,
                                                    timeout=SCAN_TIMEOUT))
        wait_until(lambda: handle.get_goal_status() != GoalStatus.PENDING,
                   f"the start of {self._name}/scan", START_LIMIT, self._check)

        def finish():
            result = wait_until(handle.get_result, f"{self._name}/scan", SCAN_LIMIT,
                                self._check)
            if result.status != ScanPlaceResult.SUCCEEDED:
                raise DemoError(f"{self._name}/scan: {result.message}")
            return wait_until(lambda: self._grid_of(result), f"{self._name}/scan_grid",
                              START_LIMIT, self._check)

        return finish

    def _grid_of(self, result):
        grid = self._grid
        return grid if grid is not None and grid.header.stamp == result.end else None

    def learn(self, label):
        answer = self._learn(label=label)
        if answer.status != LearnPlaceResponse.OK:
            raise DemoError(f"{self._name}/learn_place: {answer.message}")

    def recognize(self):
        answer = self._recognize()
        if answer.status != RecognizePlaceResponse.OK:
            raise DemoError(f"{self._name}/recognize_place: {answer.message}")
        if not answer.recognition.matches:
            raise DemoError(f"{self._name}/recognize_place: no place was learned")
        return answer.recognition
