#!/usr/bin/env python3
"""The count of tests must not hide a test that failed without saying so."""

import os
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "..", "scripts"))
import count_tests  # noqa: E402

GTEST = ('<testsuites><testsuite name="A"><testcase name="one" classname="A"/>'
         '<testcase name="two" classname="A">%s</testcase></testsuite></testsuites>')
FAILURE = '<failure message="1 is not 2"/>'
ROSTEST = ('<testsuite><testcase classname="rostest.runner.RosTest" name="testnode">%s</testcase>'
           '</testsuite>')
MISSING = '<testsuite><testcase name="test_ran"><failure/></testcase></testsuite>'


class CountTests(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def write(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w") as file:
            file.write(text)
        return path

    def counted(self, junit_file, failures=()):
        return count_tests.count({"test": junit_file}, set(failures))

    def test_every_case_of_a_gtest_counts(self):
        self.assertEqual(self.counted(self.write("gtest-a.xml", GTEST % "")), (2, 0))

    def test_a_failed_case_counts_once(self):
        results = self.write("gtest-a.xml", GTEST % FAILURE)
        self.assertEqual(self.counted(results, ["test"]), (1, 1))

    def test_a_skipped_case_has_not_passed(self):
        self.assertEqual(self.counted(self.write("gtest-a.xml", GTEST % "<skipped/>")), (1, 0))

    def test_a_leak_after_the_last_case_is_a_failure(self):
        self.assertEqual(self.counted(self.write("gtest-a.xml", GTEST % ""), ["test"]), (2, 1))

    def test_a_crash_is_a_failure(self):
        self.assertEqual(self.counted(self.write("gtest-a.xml", MISSING), ["test"]), (0, 1))

    def test_a_missing_result_is_a_failure(self):
        self.assertEqual(self.counted(os.path.join(self.folder, "none.xml")), (0, 1))

    def test_a_torn_result_is_a_failure(self):
        self.assertEqual(self.counted(self.write("gtest-a.xml", "<testsuites>")), (0, 1))

    def test_a_test_without_cases_is_a_failure(self):
        self.assertEqual(self.counted(self.write("gtest-a.xml", "<testsuites/>")), (0, 1))

    def test_a_rostest_counts_the_cases_of_its_test_node(self):
        self.write("rosunit-node.xml", GTEST % "")
        self.assertEqual(self.counted(self.write("rostest-a.xml", ROSTEST % "")), (2, 0))

    def test_a_failure_in_a_test_node_counts_once(self):
        self.write("rosunit-node.xml", GTEST % FAILURE)
        results = self.write("rostest-a.xml", ROSTEST % "")
        self.assertEqual(self.counted(results, ["test"]), (1, 1))

    def test_a_test_node_that_never_reported_is_a_failure(self):
        results = self.write("rostest-a.xml", ROSTEST % FAILURE)
        self.assertEqual(self.counted(results, ["test"]), (0, 1))

    def test_a_check_without_a_result_file_is_one_case(self):
        self.assertEqual(self.counted(None), (1, 0))
        self.assertEqual(self.counted(None, ["test"]), (0, 1))


if __name__ == "__main__":
    unittest.main()
