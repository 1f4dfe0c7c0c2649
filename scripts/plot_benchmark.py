#!/usr/bin/env python3
"""Draws how the cost of a recognition grows with the number of places.

usage: plot_benchmark.py BENCHMARK_JSON IMAGE
"""

import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.ticker import NullFormatter, ScalarFormatter  # noqa: E402

from benchmark_results import Results  # noqa: E402

CURVES = {  # benchmark: title, colour, marker
    "yardstick/local/": ("yardstick, local", "tab:orange", "^"),
    "yardstick/any/": ("yardstick, any heading", "tab:red", "v"),
    "full_search/local/": ("full search, local", "tab:cyan", "x"),
    "full_search/any/": ("full search, any heading", "tab:purple", "+"),
    "recognition/local/": ("default, local", "tab:blue", "o"),
    "recognition/any/": ("default, any heading", "tab:green", "s"),
}


def draw(axes, results, value):
    """value(name, size): of the benchmark of that name; None where it was not counted."""
    for beginning, (title, colour, marker) in CURVES.items():
        points = [(size, value(beginning + str(size), size)) for size in results.sizes(beginning)]
        points = [point for point in points if point[1] is not None]
        if points:
            axes.loglog(*zip(*points), color=colour, marker=marker, label=title)
    axes.set_xlabel("places")
    axes.grid(alpha=0.3)


def main(source, image):
    results = Results(source)
    figure, (whole, each, effort) = plt.subplots(1, 3, figsize=(13, 4), constrained_layout=True)
    draw(whole, results, lambda name, size: results.get(name))
    whole.set_ylabel("a scan [s]")
    draw(each, results, lambda name, size: 1e6 * results.get(name) / size)
    each.set_ylabel("a place [us]")
    draw(effort, results, lambda name, size: results.get(name, "evaluations_per_place"))
    effort.set_ylabel("evaluations a place")
    # Less than two decades: powers of ten alone would hardly say anything.
    effort.set_yticks([20, 50, 100, 200, 500])
    effort.yaxis.set_major_formatter(ScalarFormatter())
    effort.yaxis.set_minor_formatter(NullFormatter())
    whole.legend(fontsize=8)
    figure.savefig(image, dpi=80)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
