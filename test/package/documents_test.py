#!/usr/bin/env python3
"""The documents agree with the code: the node's reference is what the code says, the words that
troubleshooting quotes are those of the code, and links lead somewhere."""

import glob
import os
import re
import subprocess
import sys
import unittest

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
PAGES = sorted(glob.glob(os.path.join(ROOT, "*.md")) + glob.glob(os.path.join(ROOT, "doc", "*.md")))
LITERAL = re.compile(r'"((?:[^"\\\n]|\\.)*)"')
LINK = re.compile(r"\]\(([^)\s]+)\)")


def read(*path):
    with open(os.path.join(ROOT, *path), encoding="utf-8") as file:
        return file.read()


def words_of_the_code():
    """All string literals, those that follow each other joined."""
    words = []
    for file in glob.glob(os.path.join(ROOT, "src", "**", "*.[ch]*"), recursive=True):
        text = re.sub(r'"\s*\n\s*"', "", read(file))
        words += [literal.replace('\\"', '"') for literal in LITERAL.findall(text)]
    return "\n".join(words)


def quotes_of(page):
    """What stands in code letters in the first column of its tables."""
    for row in re.findall(r"(?m)^\| (.+?) \|", page):
        yield from re.findall(r"`([^`]+)`", row)


def anchor(heading):
    """As GitHub makes it."""
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def anchors_of(page):
    return {anchor(heading) for heading in re.findall(r"(?m)^#+ (.+)$", page)}


class DocumentsTest(unittest.TestCase):
    def test_the_reference_is_what_the_code_says(self):
        check = subprocess.run([sys.executable, "-B", os.path.join(ROOT, "scripts/node_reference.py"),
                                "--check"], stderr=subprocess.PIPE, encoding="utf-8")
        self.assertEqual(check.returncode, 0, check.stderr)

    def test_troubleshooting_quotes_the_code(self):
        code = words_of_the_code()
        quotes = list(quotes_of(read("doc", "troubleshooting.md")))
        self.assertGreater(len(quotes), 30)
        for quote in quotes:
            with self.subTest(quote=quote):
                self.assertTrue(quote.strip() in code, "the code says so nowhere")

    def test_links_lead_somewhere(self):
        for page in PAGES:
            for link in LINK.findall(read(page)):
                if "://" in link:
                    continue
                with self.subTest(page=os.path.relpath(page, ROOT), link=link):
                    path, _, part = link.partition("#")
                    target = os.path.normpath(os.path.join(os.path.dirname(page), path))
                    target = target if path else page
                    self.assertTrue(os.path.exists(target))
                    if part:
                        self.assertIn(part, anchors_of(read(target)))


if __name__ == "__main__":
    unittest.main()
