#!/usr/bin/env python3
"""Makes the tables of doc/performance.md out of what scripts/benchmark measured.

usage: benchmark_tables.py FOLDER

Reads benchmark.json, and live.json where it is there, and writes a .md file for each table.
"""

import json
import os
import sys

from benchmark_results import Results

GIB = 2.0 ** 30
# Cycles that one evaluation takes at the least: with AVX-512 four counts of bits for each of 64 rows,
# two a cycle, over the eight places in a vector. AVX2 has tables for that, popcnt one row at a time.
FLOORS = {"avx512": 16, "avx2": 45, "popcnt": 150}
# Most that may be needed while the robot drives [s].
DRIVING_TARGETS = {"belief/100000": 5e-3, "relaxation/10000": 0.4, "loop/500": 0.02,
                   "drive/compass": 0.015, "drive/no_compass": 0.02}


def size_words(places):
    return "{:,}".format(places).replace(",", " ")


def time_words(seconds):
    if seconds is None:
        return ""
    for unit, factor in (("s", 1.0), ("ms", 1e3), ("us", 1e6)):
        if seconds * factor >= 1.0:
            return "%.3g %s" % (seconds * factor, unit)
    return "%.3g ns" % (seconds * 1e9)


def share_words(share):
    return "" if share is None else "%.3f" % share


def number_words(number):
    return "" if number is None else "%.3g" % number


def ratio_words(ratio):
    return "" if ratio is None else "%.0f x" % ratio


def table(head, rows):
    """Of the rows of which at least one column but the first says something."""
    rows = [[str(cell) for cell in row] for row in rows if any(row[1:])]
    widths = [max(len(row[i]) for row in [head] + rows) for i in range(len(head))]

    def line(cells):
        return "| " + " | ".join(cell.ljust(width) for cell, width in zip(cells, widths)) + " |"
    rule = "|" + "|".join("-" * (width + 2) for width in widths) + "|"
    return "\n".join([line(head), rule] + [line(row) for row in rows]) + "\n"


def ratio(results, heading, size):
    """How many times faster than the yardstick."""
    yardstick = results.get("yardstick/%s/%d" % (heading, size))
    own = results.get("recognition/%s/%d" % (heading, size))
    return yardstick / own if yardstick and own else None


def targets(results, live):
    def row(what, target, value, words, met):
        return [what, target, "" if value is None else words(value),
                "" if value is None else ("yes" if met(value) else "no")]
    rows = []
    for path, floor in FLOORS.items():
        rows.append(row("cycles an evaluation, " + path, "<= %d (floor %d)" % (2 * floor, floor),
                        results.get("evaluation/" + path, "cycles"), lambda v: "%.1f" % v,
                        lambda v, floor=floor: v <= 2 * floor))
    for heading, size, times in (("local", 47, 60), ("any", 47, 150), ("local", 1000, 250)):
        rows.append(row("%s places, %s" % (size_words(size), heading), ">= %d x yardstick" % times,
                        ratio(results, heading, size), ratio_words,
                        lambda v, times=times: v >= times))
    for heading, seconds in (("local", 0.6), ("any", 3.0)):
        rows.append(row("1 000 000 places, " + heading, "<= %g s" % seconds,
                        results.get("recognition/%s/1000000" % heading), time_words,
                        lambda v, seconds=seconds: v <= seconds))
    for heading in ("local", "any"):
        for size in results.sizes("full_search/%s/" % heading):
            name = "full_search/%s/%d" % (heading, size)
            rows.append(row("same best place as full search, %s places, %s, %d queries"
                            % (size_words(size), heading, results.get(name, "queries")), ">= 0.995",
                            results.get(name, "agree"), share_words, lambda v: v >= 0.995))
    resident = results.get("index/1000000", "resident_per_place")
    rows.append(row("resident memory, 1 000 000 places", "<= 1.5 GiB",
                    resident and resident * 1e6 / GIB, lambda v: "%.2f GiB" % v,
                    lambda v: v <= 1.5))
    for name, most in DRIVING_TARGETS.items():
        rows.append(row(driving_words(name), "<= " + time_words(most), driving_seconds(results, name),
                        time_words, lambda v, most=most: v <= most))
    rows.append(row("end of scan to answer, live node, 1 000 places, median", "<= 5 ms",
                    live.get("scan_end_to_answer_ms", {}).get("median"), lambda v: "%.1f ms" % v,
                    lambda v: v <= 5.0))
    return table(["what", "target", "measured", "met"], rows)


def recognition(results):
    rows = []
    for heading in ("local", "any"):
        for size in results.sizes("recognition/%s/" % heading):
            end = "/%s/%d" % (heading, size)
            own = results.get("recognition" + end)
            rows.append([
                heading, size_words(size), time_words(own),
                time_words(results.get("recognition" + end, "cpu_seconds")), time_words(own / size),
                number_words(results.get("recognition" + end, "evaluations_per_place")),
                time_words(results.get("yardstick" + end)),
                ratio_words(ratio(results, heading, size)),
                share_words(results.get("recognition" + end, "top1")),
                share_words(results.get("yardstick" + end, "top1")),
                share_words(results.get("recognition" + end, "recognized")),
                share_words(results.get("recognition" + end, "sure_and_wrong")),
                "%d" % results.get("recognition" + end, "queries")])
    return table(["heading", "places", "a scan", "its CPU time", "a place", "evaluations a place",
                  "yardstick", "ratio", "top-1", "yardstick's", "recognized", "sure and wrong", "queries"], rows)


def full_search(results):
    rows = []
    for heading in ("local", "any"):
        for size in results.sizes("full_search/%s/" % heading):
            name = "full_search/%s/%d" % (heading, size)
            rows.append([heading, size_words(size), time_words(results.get(name)),
                         share_words(results.get(name, "top1")),
                         share_words(results.get("recognition/%s/%d" % (heading, size), "top1")),
                         share_words(results.get(name, "agree")),
                         "%d" % results.get(name, "queries")])
    return table(["heading", "places", "a full search", "its top-1", "the default's top-1",
                  "same best place", "queries"], rows)


def parts(results):
    def cpu(name):
        return results.get(name, "cpu_seconds")

    rows = []
    for name in results.names("evaluation/"):
        kernel = name.split("/")[1]
        what = "of a single place" if kernel == "one" else kernel + " kernel"
        rows.append(["one evaluation, " + what, time_words(cpu(name)),
                     "%.1f" % results.get(name, "cycles")])
    for name, what in (("preparation/local", "query planes, heading window of 45 degrees"),
                       ("preparation/any", "query planes, any heading"),
                       ("grid", "evidence grid of a scan of 16 sonars")):
        rows.append([what, time_words(cpu(name)), ""])
    readings = results.get("grid", "readings")
    rows.append(["the same, a reading", time_words(readings and cpu("grid") / readings), ""])
    return table(["part", "CPU time", "cycles"], rows)


def store(results):
    rows = []
    for size in results.sizes("index/"):
        resident = results.get("index/%d" % size, "resident_per_place")
        name = "store/%d" % size
        file_size = results.get(name, "file_per_place")
        memory = results.get(name, "resident_per_place")
        rows.append([size_words(size), "%.0f bytes" % resident,
                     "%.0f bytes" % memory if memory else "",
                     "%.0f bytes" % file_size if file_size else "",
                     time_words(results.get(name)),
                     time_words(results.get(name, "writing_seconds"))])
    return table(["places", "matching, a place", "with labels and links", "in the store",
                  "start", "writing them all at once"], rows)


def driving_words(name):
    what, which = name.split("/")
    if what == "drive":
        return "a metre of drive, mapped, " + ("no compass" if which == "no_compass" else "compass")
    words = {"belief": "a scan's update of the belief, %s places",
             "relaxation": "relaxation of %s places after a loop",
             "loop": "a loop of %s places"}
    return words[what] % size_words(int(which))


def driving_seconds(results, name):
    """Of a drive, CPU time a metre."""
    what = "cpu_seconds_per_metre" if name.startswith("drive/") else "seconds"
    return results.get(name, what)


def driving(results):
    rows = []
    for beginning in ("belief/", "relaxation/", "loop/", "drive/"):
        for name in results.names(beginning):
            steps = results.get(name, "steps")
            rows.append([driving_words(name), time_words(driving_seconds(results, name)),
                         "%.0f" % steps if steps else ""])
    return table(["what", "time", "steps"], rows)


def strangers(results):
    rows = []
    for name in results.names("strangers/"):
        for kind in ("simulated", "spliced"):
            counters = [results.get(name, "%s_%s" % (kind, what))
                        for what in ("50", "90", "99", "999", "best_of_1000")]
            rows.append([name.split("/")[1], kind] + ["%.1f" % value for value in counters])
    return table(["heading", "strangers", "median", "90 %", "99 %", "99.9 %",
                  "best of 1000, mean"], rows)


def fused_map(results):
    rows = []
    for size in results.sizes("fused_map/scratch/"):
        scratch = results.get("fused_map/scratch/%d" % size, "cpu_seconds")
        moved = results.get("fused_map/moved/%d" % size, "cpu_seconds")
        rows.append([size_words(size), time_words(scratch), time_words(moved),
                     ratio_words(scratch and moved and scratch / moved),
                     time_words(results.get("fused_map/cells/%d" % size, "cpu_seconds")),
                     number_words(results.get("fused_map/scratch/%d" % size, "cells"))])
    return table(["places", "made from them all", "one place moved", "ratio", "laid out to publish",
                  "cells"], rows)


def live_table(live):
    names = (("scan_end_to_answer_ms", "from the end of a scan to the answer"),
             ("call_kept_connection_ms", "a call, over a connection that is kept"),
             ("call_new_connection_ms", "a call, over a new connection"),
             ("match_duration_ms", "of which the match"))
    rows = [[what, "%.2f ms" % live[name]["median"], "%.2f ms" % live[name]["p95"],
             "%d" % live[name]["calls"]] for name, what in names if name in live]
    return table(["what", "median", "95 %", "calls"], rows)


def cpu_model():
    with open("/proc/cpuinfo") as file:
        for line in file:
            if line.startswith("model name"):
                return line.split(":", 1)[1].strip()
    return "an unnamed processor"


def run(results):
    context = results.context
    load = ", ".join("%.1f" % value for value in context.get("load_avg", []))
    return ("Measured on %d cores of %s, load average at the begin %s, %s.\n"
            % (context["num_cpus"], cpu_model(), load or "unknown", context["date"][:10]))


def main(folder):
    results = Results(os.path.join(folder, "benchmark.json"))
    live = {}
    live_file = os.path.join(folder, "live.json")
    if os.path.exists(live_file):
        with open(live_file) as file:
            live = json.load(file)
    tables = {"run": run(results), "targets": targets(results, live),
              "recognition": recognition(results), "full_search": full_search(results),
              "parts": parts(results), "store": store(results), "strangers": strangers(results),
              "driving": driving(results), "fused_map": fused_map(results),
              "live": live_table(live)}
    for name, text in tables.items():
        with open(os.path.join(folder, name + ".md"), "w") as file:
            file.write(text)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
