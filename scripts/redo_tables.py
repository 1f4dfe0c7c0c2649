#!/usr/bin/env python3
"""Runs the commands of a document and puts in the tables that they print.

usage: redo_tables.py DOCUMENT FOLDER_OF_PROGRAMS [--only=WORD]

A command is a line that is indented by four spaces and begins with the name of a program of the
folder; its table is the next one in the document, before any other command. Commands whose first
argument is a word in capitals only show how they are called. The folder's path may not be part of
a command. With --only those commands alone that hold the word. Fails, and leaves DOCUMENT as it
is, where a command fails, prints no table, or has none in the document.
"""

import os
import shlex
import subprocess
import sys


def command_of(line, programs):
    """The words of the command on a line; None where there is none."""
    if not line.startswith("    ") or line.startswith("     "):
        return None
    words = shlex.split(line)
    if not words or not os.access(os.path.join(programs, words[0]), os.X_OK):
        return None
    return None if len(words) > 1 and words[1].isupper() else words


def printed(words, programs):
    run = subprocess.run([os.path.join(programs, words[0]), *words[1:]], check=True,
                         stdout=subprocess.PIPE, universal_newlines=True)
    table = run.stdout.splitlines()
    if len(table) < 3 or not all(line.startswith("|") for line in table):
        raise ValueError(f"{' '.join(words)} prints no table")
    return table


def redone(lines, programs, only):
    output, awaited = [], None
    at = 0
    while at < len(lines):
        words = command_of(lines[at], programs)
        if words and awaited:
            raise ValueError(f"no table stands behind {' '.join(awaited)}")
        awaited = words or awaited
        if awaited and lines[at].startswith("|"):
            end = at
            while end < len(lines) and lines[end].startswith("|"):
                end += 1
            output += printed(awaited, programs) if only in " ".join(awaited) else lines[at:end]
            awaited, at = None, end
            continue
        output.append(lines[at])
        at += 1
    if awaited:
        raise ValueError(f"no table stands behind {' '.join(awaited)}")
    return output


def main(document, programs, only):
    with open(document) as file:
        lines = file.read().splitlines()
    try:
        output = redone(lines, programs, only)
    except (ValueError, OSError, subprocess.CalledProcessError) as error:
        sys.exit(f"redo_tables: {error}")
    with open(document, "w") as file:
        file.write("\n".join(output) + "\n")


if __name__ == "__main__":
    arguments = [word for word in sys.argv[1:] if not word.startswith("--only=")]
    chosen = [word[len("--only="):] for word in sys.argv[1:] if word.startswith("--only=")]
    if len(arguments) != 2:
        sys.exit(__doc__)
    main(*arguments, chosen[0] if chosen else "")
