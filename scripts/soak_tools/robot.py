"""A robot that goes round a room for ever: what it says, and where it truly is at any time."""

import math
import os
import sys
import time

import rospy
from geometry_msgs.msg import TransformStamped
from sensor_msgs.msg import Imu, Range
from tf2_msgs.msg import TFMessage

sys.path.append(os.path.join(os.path.dirname(__file__), "..", "..", "test", "rostest"))
import sonar_room  # noqa: E402: from the folder that is named above

ROOM = sonar_room.Room(12.0, 8.0, [(0.0, 0.0, 2.0, 0.6), (4.6, 2.9, 0.8, 0.8), (-4.8, -2.6, 1.2, 0.5),
                                   (1.5, 3.4, 1.6, 0.5), (-2.2, -3.4, 0.7, 0.7)])
SEMI_AXES = (3.8, 2.2)  # of the way [m]
STEPS = 360  # of the way, at which ranges are reckoned beforehand
CYCLE = 6.0  # stands for the first half of it, and drives in the second [s]
TURN = 0.28  # driven in a cycle [rad of the way]
ODOMETRY_RATE = 50.0  # at the most [Hz]


def angle_at(seconds):
    """Along the way."""
    cycles, rest = divmod(seconds, CYCLE)
    driving = max(0.0, rest - 0.5 * CYCLE) / (0.5 * CYCLE)
    return TURN * (cycles + driving)


def pose_on_way(angle):
    x, y = SEMI_AXES[0] * math.cos(angle), SEMI_AXES[1] * math.sin(angle)
    return x, y, math.atan2(SEMI_AXES[1] * math.cos(angle), -SEMI_AXES[0] * math.sin(angle))


def pose_at(seconds):
    """(x, y, yaw) so long after it started. Odometry is exact, and map and odom are the same."""
    return pose_on_way(angle_at(seconds))


def transform(parent, child, pose, stamp):
    message = TransformStamped()
    message.header.stamp = stamp
    message.header.frame_id = parent
    message.child_frame_id = child
    message.transform.translation.x, message.transform.translation.y = pose[:2]
    message.transform.rotation.z = math.sin(0.5 * pose[2])
    message.transform.rotation.w = math.cos(0.5 * pose[2])
    return message


def range_message(sensor):
    message = Range()
    message.header.frame_id = "sonar_%d" % sensor
    message.radiation_type = Range.ULTRASOUND
    message.field_of_view = sonar_room.FIELD_OF_VIEW
    message.min_range = sonar_room.MIN_RANGE
    message.max_range = sonar_room.MAX_RANGE
    return message


def run(start, edit, rate):
    """The process of the robot, until ROS ends. `start`: of its way, as time.time() [s]; `edit` may
    hold, shared with other processes, the time until which every range is NaN; `rate`: of each of
    its topics [Hz]."""
    rospy.init_node("soak_robot", disable_signals=True)
    table = [[ROOM.ping(pose_on_way(2.0 * math.pi * i / STEPS), sensor)
              for sensor in range(sonar_room.SENSORS)] for i in range(STEPS)]
    topics = [rospy.Publisher("sonar_%d" % i, Range, queue_size=50, tcp_nodelay=True)
              for i in range(sonar_room.SENSORS)]
    heading = rospy.Publisher("heading", Imu, queue_size=50)
    tf = rospy.Publisher("/tf", TFMessage, queue_size=50)
    static = rospy.Publisher("/tf_static", TFMessage, queue_size=1, latch=True)
    static.publish(TFMessage([transform("base_link", "sonar_%d" % i, sonar_room.sensor_pose(i),
                                        rospy.Time.now()) for i in range(sonar_room.SENSORS)]))
    messages = [range_message(i) for i in range(sonar_room.SENSORS)]
    ticks_between_odometry = max(1, round(rate / ODOMETRY_RATE))
    tick = 0
    begin = time.monotonic()
    while not rospy.is_shutdown():
        stamp = rospy.Time.now()
        angle = angle_at(stamp.to_sec() - start)
        if tick % ticks_between_odometry == 0:
            pose = pose_on_way(angle)
            tf.publish(TFMessage([transform("odom", "base_link", pose, stamp)]))
            compass = Imu()
            compass.header.stamp = stamp
            compass.header.frame_id = "base_link"
            compass.orientation.z, compass.orientation.w = math.sin(0.5 * pose[2]), math.cos(0.5 * pose[2])
            heading.publish(compass)
        ranges = table[int(angle / (2.0 * math.pi) * STEPS) % STEPS]
        is_blind = stamp.to_sec() < edit.value
        for topic, message, distance in zip(topics, messages, ranges):
            message.header.stamp = stamp
            message.range = math.nan if is_blind else distance
            topic.publish(message)
        tick += 1
        time.sleep(max(0.0, begin + tick / rate - time.monotonic()))
