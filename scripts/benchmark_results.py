"""Results of place_memory_benchmark, as its JSON file holds them."""

import json
import re

SECONDS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}
# What Google Benchmark adds to a name: how it was run.
SUFFIXES = re.compile(r"/(iterations:|repeats:|process_time|real_time).*")


class Results:
    """Measurements by the names of benchmarks, as "recognition/local/1000": `seconds` and
    `cpu_seconds` an iteration, and every counter. Where a benchmark was repeated, medians."""

    def __init__(self, path):
        with open(path) as file:
            content = json.load(file)
        self.context = content["context"]
        self._rows = {}
        for row in content["benchmarks"]:
            if row["run_type"] == "aggregate" and row["aggregate_name"] != "median":
                continue
            if row.get("error_occurred"):
                continue
            name = SUFFIXES.sub("", row["run_name"])
            if name in self._rows and row["run_type"] != "aggregate":
                continue
            unit = SECONDS[row["time_unit"]]
            self._rows[name] = dict(row, seconds=unit * row["real_time"],
                                    cpu_seconds=unit * row["cpu_time"])

    def get(self, name, what="seconds"):
        """None where it was not measured."""
        return self._rows.get(name, {}).get(what)

    def names(self, beginning):
        """In the order in which they ran."""
        return [name for name in self._rows if name.startswith(beginning)]

    def sizes(self, beginning):
        """The numbers of places that were measured, rising."""
        return sorted(int(name[len(beginning):]) for name in self.names(beginning))
