"""Changes of the simulated world, through the simulator's services."""
import rospy
from geometry_msgs.msg import Pose2D
from place_memory.srv import MoveChair, SetDoor

from demo_tools.errors import DemoError


def apply_changes(changes):
    """`changes` as in config/demo/changes.yaml. Returns what was done, in words."""
    set_door = rospy.ServiceProxy("sonar_sim/set_door", SetDoor)
    for door in changes["doors"]:
        _expect(set_door(name=door["name"], open=door["open"]), door["name"])
    move_chair = rospy.ServiceProxy("sonar_sim/move_chair", MoveChair)
    for chair in changes["chairs"]:
        x, y = chair["at"]
        _expect(move_chair(name=chair["name"], pose=Pose2D(x, y, chair["yaw"])), chair["name"])
    return f"{len(changes['doors'])} doors opened or closed, {len(changes['chairs'])} chairs moved"


def _expect(answer, name):
    if answer.status != answer.OK:
        raise DemoError(f"{name}: {answer.message}")
