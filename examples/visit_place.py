#!/usr/bin/env python3
"""Scans, learns the place or tells which one it is, and goes to another one from there.

    visit_place.py learn LABEL | recognize | go LABEL [_node:=/place_memory]
"""
import sys

import actionlib
import rospy
from place_memory import msg, srv


def main():
    words = rospy.myargv()[1:]
    rospy.init_node("visit_place", anonymous=True)
    node = rospy.get_param("~node", "/place_memory")

    scan = actionlib.SimpleActionClient(node + "/scan", msg.ScanPlaceAction)
    scan.wait_for_server()
    scan.send_goal_and_wait(msg.ScanPlaceGoal(turn=rospy.get_param("~turn", 0)))
    scanned = scan.get_result()
    if scanned.status != msg.ScanPlaceResult.SUCCEEDED:
        sys.exit(scanned.message)

    if words[0] == "learn":
        learn = rospy.ServiceProxy(node + "/learn_place", srv.LearnPlace)
        print(learn(label=words[1], scan_id=scanned.scan_id).message)
    else:
        recognize = rospy.ServiceProxy(node + "/recognize_place", srv.RecognizePlace)
        answer = recognize(scan_id=scanned.scan_id)
        print(answer.message)
        for match in answer.recognition.matches[:3]:
            print("%5.2f %s" % (match.probability, match.label))
    if words[0] == "go":
        going = actionlib.SimpleActionClient(node + "/go_to_place", msg.GoToPlaceAction)
        going.wait_for_server()
        going.send_goal_and_wait(msg.GoToPlaceGoal(label=words[1]))
        gone = going.get_result()
        print(gone.message)
        sys.exit(gone.status)


if __name__ == "__main__":
    main()
