#!/usr/bin/env python3
"""Puts generated tables into a document.

usage: insert_tables.py DOCUMENT RESULTS_DIRECTORY

Between the lines `<!-- begin NAME -->` and `<!-- end NAME -->` of DOCUMENT goes the file NAME of
RESULTS_DIRECTORY. Fails, and leaves DOCUMENT as it is, where a file or an end is missing.
"""

import os
import re
import sys

BEGIN = re.compile(r"<!-- begin (\S+) -->$")


def inserted(lines, results):
    """The lines of the document with the files of today."""
    output, awaited = [], None
    for line in lines:
        if awaited is None:
            output.append(line)
            match = BEGIN.match(line)
            if match:
                awaited = f"<!-- end {match.group(1)} -->"
                with open(os.path.join(results, match.group(1))) as file:
                    output += ["", *file.read().splitlines(), ""]
        elif line == awaited:
            output.append(line)
            awaited = None
    if awaited is not None:
        raise ValueError(f"there is no line {awaited}")
    return output


def main(document, results):
    with open(document) as file:
        lines = file.read().splitlines()
    try:
        output = inserted(lines, results)
    except (OSError, ValueError) as error:
        sys.exit(f"{document}: {error}")
    with open(document, "w") as file:
        file.write("\n".join(output) + "\n")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
