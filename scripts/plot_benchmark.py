#!/usr/bin/env python3
"""Draws how the cost of a recognition grows with the number of places.

usage: plot_benchmark.py BENCHMARK_JSON IMAGE
"""

import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

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
    for beginning, (title, colour, marker) in CURVES.items():
        sizes = results.sizes(beginning)
        if sizes:
            axes.loglog(sizes, [value(results.get(beginning + str(size)), size) for size in sizes],
                        color=colour, marker=marker, label=title)
    axes.set_xlabel("places")
    axes.grid(alpha=0.3)


def main(source, image):
    results = Results(source)
    figure, (whole, each) = plt.subplots(1, 2, figsize=(10, 4), constrained_layout=True)
    draw(whole, results, lambda seconds, size: seconds)
    whole.set_ylabel("a scan [s]")
    draw(each, results, lambda seconds, size: 1e6 * seconds / size)
    each.set_ylabel("a place [us]")
    whole.legend(fontsize=8)
    figure.savefig(image, dpi=80)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
