#!/usr/bin/env python3
"""Says how much of the core the tests reach that ran in a build with PLACE_MEMORY_COVERAGE.

usage: coverage_table.py BUILD_DIRECTORY

Prints a row for each group of the core, and one for each file that is lower than asked for. Exits 1
where the core as a whole is.
"""

import collections
import glob
import json
import os
import re
import subprocess
import sys

LEAST = {"lines": 90.0, "branches": 80.0}  # percent


class Counts:
    def __init__(self):
        self.count = collections.Counter()
        self.covered = collections.Counter()

    def add(self, summary):
        for what in LEAST:
            self.count[what] += summary[what]["count"]
            self.covered[what] += summary[what]["covered"]

    def percent(self, what):
        return 100.0 * self.covered[what] / self.count[what] if self.count[what] else 100.0

    def is_low(self):
        return any(self.percent(what) < least for what, least in LEAST.items())


def measured(build):
    """(file, summary) for each file of the core, as llvm-cov counts."""
    profile = os.path.join(build, "core.profdata")
    raw = glob.glob(os.path.join(build, "profiles", "*.profraw"))
    subprocess.run(["llvm-profdata-14", "merge", "-sparse", "-o", profile] + raw, check=True)
    programs = sorted(glob.glob(os.path.join(build, "devel", "lib", "place_memory", "*_test")))
    command = ["llvm-cov-14", "export", "-summary-only", "-instr-profile", profile, programs[0]]
    for program in programs[1:]:
        command += ["-object", program]
    answer = subprocess.run(command, check=True, stdout=subprocess.PIPE)
    for file in json.loads(answer.stdout)["data"][0]["files"]:
        found = re.search(r"(?:src|include/place_memory)/core/.*$", file["filename"])
        if found:
            yield found.group(0), file["summary"]


def row(name, counts):
    return "%-52s %6.1f %% %6.1f %%" % (name, counts.percent("lines"), counts.percent("branches"))


def main():
    groups = collections.defaultdict(Counts)
    files = collections.defaultdict(Counts)
    whole = Counts()
    for name, summary in measured(sys.argv[1]):
        for counts in (groups[os.path.dirname(name)], files[name], whole):
            counts.add(summary)
    print("%-52s %8s %8s" % ("", "lines", "branches"))
    for name, counts in sorted(groups.items()):
        print(row(name, counts))
    print(row("the core", whole))
    low = sorted((name, counts) for name, counts in files.items() if counts.is_low())
    if low:
        print("\nlower than %(lines)g %% of lines or %(branches)g %% of branches:" % LEAST)
    for name, counts in low:
        print(row(name, counts))
    return 1 if whole.is_low() else 0


if __name__ == "__main__":
    sys.exit(main())
