#!/usr/bin/env python3
"""The page that place_memory_bag --report writes.

usage: place_memory_bag_report_test.py PLACE_MEMORY_BAG [UNITTEST OPTION]...
"""

import html.parser
import unittest

import bag_tool
from bag_tool import NOTHING, SOME


class Outline(html.parser.HTMLParser):
    """Counts elements, checks that they are nested, and finds what a page would load."""

    def __init__(self):
        super().__init__()
        self.open = []
        self.count = {}
        self.links = []

    def handle_starttag(self, tag, attrs):
        self.count[tag] = self.count.get(tag, 0) + 1
        self.links += [value for name, value in attrs if name in ("src", "href")]
        if tag not in ("meta", "br"):
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.count[tag] = self.count.get(tag, 0) + 1
        self.links += [value for name, value in attrs if name in ("src", "href")]

    def handle_endtag(self, tag):
        if self.open.pop() != tag:
            raise AssertionError("</%s> closes another element" % tag)


class ReportTest(bag_tool.BagToolTest):
    def test_the_report_has_a_section_an_event_and_needs_nothing_else(self):
        self.rooms.write_events(self.path("all.csv"))
        with open(self.path("all.csv"), "a") as table:
            table.write("1.0,2.0,learn,beyond,\n")
        page = self.path("report.html")
        answer = self.run_tool("--bag", self.bag, "--events", self.path("all.csv"),
                               "--out", self.out, "--report", page)
        self.assertEqual(answer.returncode, SOME, answer.stderr)
        with open(page, encoding="utf-8") as file:
            text = file.read()
        outline = Outline()
        outline.feed(text)
        outline.close()
        self.assertEqual(outline.open, [])
        rows = self.rows()
        self.assertEqual(outline.count["section"], len(rows))
        learned = sum(row["action"] == "learn" and row["status"] == "ok" for row in rows)
        recognized = sum(row["action"] == "recognize" for row in rows)
        # Of a recognition scan, place and both; the map.
        self.assertEqual(outline.count["svg"], learned + 3 * recognized + 1)
        self.assertEqual([link[:22] for link in outline.links], ["data:image/png;base64,"])
        for row in rows[:-1]:
            self.assertIn("<b>%s</b>" % row["place"], text)
        self.assertIn("it lies before what the bag holds", text)
        answer = self.run_tool("--bag", self.bag, "--events", self.path("all.csv"),
                               "--out", self.path("other.csv"), "--report", "/nowhere/r.html")
        self.assertEqual(answer.returncode, NOTHING)
        self.assertIn("cannot write the report /nowhere/r.html", answer.stderr)


if __name__ == "__main__":
    unittest.main()
