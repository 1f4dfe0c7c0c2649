#!/usr/bin/env python3
"""Writes into doc/node.md what the code itself says of the node: parameters, services, actions,
messages.

usage: node_reference.py [--check]

With --check nothing is written: status 1, and what to do, where the page is not what the code says,
or leaves out a topic, service or action of src/node/names/node_names.h.
"""

import os
import re
import sys
import tempfile

import insert_tables

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
PAGE = os.path.join(ROOT, "doc", "node.md")
NAMES = os.path.join(ROOT, "src", "node", "names", "node_names.h")
PARAMETERS = os.path.join(ROOT, "config", "place_memory.yaml")
NAME = re.compile(r'constexpr char k\w+?(Topic|Service|Action)\[\] = "([\w/]+)";')
PARAMETER = re.compile(r"^(?P<indent> *)(?P<name>\w+):(?P<value>[^#]*?) *(?:# ?(?P<words>.*))?$")
COMMENT = re.compile(r"^ +# ?(?P<words>.*)$")
OTHER_NAMES = {"scan": "ScanPlace"}  # of the type; of all others it is that of the interface
FOREIGN = {"make_plan": "nav_msgs/GetPlan", "static_map": "nav_msgs/GetMap"}


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def names_of(kind):
    """Below the node's name, in the order of the code."""
    return [name for found, name in NAME.findall(read(NAMES)) if found == kind]


def type_of(name):
    return OTHER_NAMES.get(name) or "".join(word.capitalize() for word in name.split("_"))


def parameters():
    """(section, name, default, words) of each parameter, and (section, None, None, words) of each
    section."""
    rows, section = [], ""
    for line in read(PARAMETERS).splitlines():
        match = PARAMETER.match(line)
        more = COMMENT.match(line)
        if match:
            name, value, words = (match.group(part) for part in ("name", "value", "words"))
            if not match.group("indent"):
                section = ""
            if not value.strip():
                section = name
                rows.append([section, None, None, words or ""])
            else:
                rows.append([section, name, value.strip(), words or ""])
        elif more and rows:
            rows[-1][3] += " " + more.group("words").strip()
    return rows


def cell(text):
    return text.replace("|", "\\|").replace("<", "&lt;")


def parameter_tables():
    lines, table_is_open = [], False
    for section, name, default, words in parameters():
        if name is None:
            lines += ["", f"**`{section}`**: {words}"]
            table_is_open = False
            continue
        if not table_is_open:
            lines += ["", "| parameter | default | meaning |", "|---|---|---|"]
            table_is_open = True
        path = f"{section}/{name}" if section else name
        lines.append(f"| `{path}` | `{default}` | {cell(words)} |")
    return lines[1:]


def interface(name, folder, extension):
    """A heading, what the file says first, and its fields."""
    type_name = type_of(name)
    path = os.path.join(ROOT, folder, type_name + extension)
    if not os.path.exists(path):
        foreign = FOREIGN.get(name)
        if foreign is None:
            sys.exit(f"node_reference: there is no {folder}/{type_name}{extension} for ~{name}")
        return [f"### `~{name}` ({foreign})", ""]
    lines = read(path).splitlines()
    head = []
    while lines and lines[0].startswith("#"):
        head.append(lines.pop(0).lstrip("# "))
    while lines and not lines[0].strip():
        lines.pop(0)
    return [f"### `~{name}` (place_memory/{type_name})", "", *head, "", "```", *lines, "```", ""]


def interfaces(kind, folder, extension):
    lines = []
    for name in names_of(kind):
        lines += interface(name, folder, extension)
    return lines[:-1]


def messages():
    lines = []
    for file in sorted(os.listdir(os.path.join(ROOT, "msg"))):
        text = read(os.path.join(ROOT, "msg", file)).strip()
        lines += [f"### place_memory/{file[:-len('.msg')]}", "", "```", *text.splitlines(), "```", ""]
    return lines[:-1]


TABLES = {
    "parameters": parameter_tables,
    "services": lambda: interfaces("Service", "srv", ".srv"),
    "actions": lambda: interfaces("Action", "action", ".action"),
    "messages": messages,
}


def page_of_today(page):
    with tempfile.TemporaryDirectory() as folder:
        for name, table in TABLES.items():
            with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                file.write("\n".join(table()) + "\n")
        return "\n".join(insert_tables.inserted(page.splitlines(), folder)) + "\n"


def left_out(page):
    """Topics of the node that the page does not name. Of the others it has what is generated."""
    return [name for name in names_of("Topic") if not re.search(rf"`~?{name}`", page)]


def main(arguments):
    if arguments not in ([], ["--check"]):
        sys.exit(__doc__)
    page = read(PAGE)
    new = page_of_today(page)
    missing = left_out(new)
    if missing:
        sys.exit("node_reference: doc/node.md does not say what these topics are: " +
                 ", ".join(missing))
    if arguments and new != page:
        sys.exit("node_reference: doc/node.md is not what the code says: run scripts/node_reference.py")
    if not arguments:
        with open(PAGE, "w", encoding="utf-8") as file:
            file.write(new)


if __name__ == "__main__":
    main(sys.argv[1:])
