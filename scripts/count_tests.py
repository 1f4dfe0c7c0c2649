#!/usr/bin/env python3
"""Counts the test cases that a run of ctest in a catkin build directory left behind.

usage: count_tests.py BUILD_DIRECTORY [CTEST OPTION]...

Prints `N passed, N failed`. Exits 1 where a test failed or none ran. A ctest test that failed
without any case saying so (a crash, a leak, a timeout) counts as one failure, and so does one that
reports no case at all. A check that writes no JUnit file is a case of its own.
"""

import json
import os
import subprocess
import sys
import xml.etree.ElementTree as ElementTree


def listed_tests(build, options):
    """The tests that ctest runs under these options: {name: its JUnit file or None}."""
    answer = subprocess.run(["ctest", "--show-only=json-v1"] + options, cwd=build, check=True,
                            stdout=subprocess.PIPE)
    tests = {}
    for test in json.loads(answer.stdout)["tests"]:
        files = [word for word in test.get("command", []) if word.endswith(".xml")]
        tests[test["name"]] = files[0] if files else None
    return tests


def failed_tests(build):
    """The names that ctest noted down as failed in its last run."""
    log = os.path.join(build, "Testing", "Temporary", "LastTestsFailed.log")
    if not os.path.exists(log):
        return set()
    with open(log) as lines:
        return {line.strip().split(":", 1)[1] for line in lines if ":" in line}


def cases(junit_file):
    """The passed and failed cases of a JUnit file; those of a rostest are in files of its nodes."""
    try:
        found = list(ElementTree.parse(junit_file).getroot().iter("testcase"))
    except (OSError, ElementTree.ParseError):
        return 0, 0
    passed = failed = 0
    for case in found:
        inner = os.path.join(os.path.dirname(junit_file),
                             "rosunit-%s.xml" % case.get("name", "")[len("test"):])
        if case.find("failure") is not None or case.find("error") is not None:
            failed += 1
        elif case.get("classname") == "rostest.runner.RosTest" and os.path.exists(inner):
            counts = cases(inner)
            passed += counts[0]
            failed += counts[1]
        elif case.find("skipped") is None:
            passed += 1
    return passed, failed


def count(tests, failures):
    passed = failed = 0
    for name, junit_file in tests.items():
        good, bad = cases(junit_file) if junit_file else (int(name not in failures), 0)
        if bad == 0 and (name in failures or good == 0):
            bad = 1
        passed += good
        failed += bad
        if bad:
            print("failed: %s" % name)
    return passed, failed


def main():
    build, options = sys.argv[1], sys.argv[2:]
    passed, failed = count(listed_tests(build, options), failed_tests(build))
    print("%d passed, %d failed" % (passed, failed))
    return 0 if passed > 0 and failed == 0 else 1


if __name__ == "__main__":
    sys.exit(main())
