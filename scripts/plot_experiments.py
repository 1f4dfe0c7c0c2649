#!/usr/bin/env python3
"""Draws what place_memory_experiments wrote: curves, reliability, grids and maps.

usage: plot_experiments.py RESULTS_DIRECTORY IMAGE_DIRECTORY

Draws every plot for which RESULTS_DIRECTORY holds the numbers.
"""

import csv
import glob
import json
import os
import sys
import textwrap

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

METHODS = {  # name: title, colour, marker
    "nearest_neighbour": ("nearest neighbour (paper)", "tab:red", "s"),
    "hill_climbing": ("hill climbing (paper)", "tab:orange", "^"),
    "default": ("default", "tab:blue", "o"),
    "default_laser": ("default, laser", "tab:green", "D"),
}
CURVES = {**METHODS, "default_adapting": ("default, places adapt", "tab:purple", "v")}
SWEEPS = {  # name: axis, whether it is logarithmic, the value that the experiments have
    "shift": ("position shift along the hallway [m]", False, 0.61),
    "heading_error": ("heading error, up to [degrees]", False, 30.0),
    "cell_size": ("cell size [m]", True, 0.142875),
    "places": ("places learned", True, None),
    "sonars": ("sonars", False, 16),
    "readings_lost": ("share of the readings lost", False, 0.0),
}
# Figure 3 of the paper: accuracy with 0 to 3 new chairs, two feet away.
PAPER_CHAIRS = {"nearest_neighbour": [0.8, 0.6, 0.2, 0.2], "hill_climbing": [1.0, 0.8, 0.8, 0.8]}


def rows_of(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def save(figure, folder, name):
    figure.savefig(os.path.join(folder, name + ".png"), dpi=80)
    plt.close(figure)


def draw_curve(axes, rows, method):
    """Accuracy over x, with 95 % intervals."""
    points = sorted((float(row["x"]), float(row["accuracy"]), float(row["low"]),
                     float(row["high"])) for row in rows if row["method"] == method)
    if not points:
        return
    x, accuracy, low, high = np.array(points).T
    title, colour, marker = CURVES[method]
    axes.errorbar(x, accuracy, [np.maximum(accuracy - low, 0), np.maximum(high - accuracy, 0)],
                  color=colour, marker=marker, capsize=2, label=title)


def finish_accuracy(axes, label):
    axes.set_xlabel(label)
    axes.set_ylabel("accuracy")
    axes.set_ylim(-0.02, 1.04)
    axes.grid(alpha=0.3)


def legend_above(axes, columns):
    axes.legend(fontsize=8, ncol=columns, loc="lower center", bbox_to_anchor=(0.5, 1.0))


def plot_chairs(rows, folder):
    rows = [row for row in rows if row["experiment"] == "chairs"]
    if not rows:
        return
    figure, axes = plt.subplots(figsize=(6, 4), constrained_layout=True)
    for method in METHODS:
        draw_curve(axes, rows, method)
    for method, accuracies in PAPER_CHAIRS.items():
        title, colour, marker = METHODS[method]
        axes.plot(range(4), accuracies, color=colour, marker=marker, linestyle=":",
                  markerfacecolor="none", label="the paper's " + title.replace(" (paper)", ""))
    finish_accuracy(axes, "chairs added, seen from two feet away")
    legend_above(axes, 3)
    save(figure, folder, "figure_3")


def plot_sweeps(rows, folder):
    """Every curve but that of the chairs."""
    names = [name for name in SWEEPS if any(row["experiment"] == name for row in rows)]
    if not names:
        return
    lines = (len(names) + 2) // 3
    figure, grid = plt.subplots(lines, 3, figsize=(14, 4 * lines), constrained_layout=True,
                                squeeze=False)
    for axes, name in zip(grid.flat, names):
        label, logarithmic, usual = SWEEPS[name]
        for method in METHODS:
            draw_curve(axes, [row for row in rows if row["experiment"] == name], method)
        if logarithmic:
            axes.set_xscale("log")
            ticks = sorted({float(row["x"]) for row in rows if row["experiment"] == name})
            axes.set_xticks(ticks, [f"{tick:.2g}" if tick < 1 else f"{tick:.0f}" for tick in ticks])
            axes.minorticks_off()
        if usual is not None:
            axes.axvline(usual, color="grey", linestyle="--", linewidth=1)
        finish_accuracy(axes, label)
    for axes in list(grid.flat)[len(names):]:
        axes.axis("off")
    grid.flat[min(3, len(names) - 1)].legend(fontsize=8, loc="lower left")
    save(figure, folder, "sweeps")


def plot_rearrangements(rows, folder):
    """Accuracy of each method after each rearrangement of the office."""
    figure, axes = plt.subplots(figsize=(7, 4), constrained_layout=True)
    for method in CURVES:
        points = [{"x": row["round"], **row} for row in rows if row["round"] != "all"]
        draw_curve(axes, points, method)
    finish_accuracy(axes, "rearrangements since the places were learned")
    legend_above(axes, 3)
    save(figure, folder, "rearrangements")


def plot_experiments(rows, folder):
    """Accuracy of each method in each of the paper's experiments, and what the paper reports."""
    rows = [row for row in rows if row["experiment"] in "12345"]
    cases = list(dict.fromkeys((row["experiment"], row["case"]) for row in rows))
    if not cases:
        return
    figure, axes = plt.subplots(figsize=(12, 4.5), constrained_layout=True)
    for i, (method, (title, colour, _)) in enumerate(METHODS.items()):
        own = {(row["experiment"], row["case"]): row for row in rows if row["method"] == method}
        places = [c + 0.2 * (i - 1.5) for c, case in enumerate(cases) if case in own]
        found = [own[case] for case in cases if case in own]
        accuracy = np.array([float(row["accuracy"]) for row in found])
        errors = [np.maximum(accuracy - [float(row["low"]) for row in found], 0),
                  np.maximum([float(row["high"]) for row in found] - accuracy, 0)]
        axes.bar(places, accuracy, 0.2, color=colour, label=title, alpha=0.8)
        axes.errorbar(places, accuracy, errors, linestyle="none", color="black", linewidth=1)
        told = [(x, float(row["paper"])) for x, row in zip(places, found) if row["paper"]]
        if told:
            axes.plot(*zip(*told), linestyle="none", marker="_", markersize=12, markeredgewidth=3,
                      color="black", label="_" if i else "what the paper reports")
    axes.set_xticks(range(len(cases)), [textwrap.fill(f"{number}: {case}", 12)
                                        for number, case in cases], fontsize=8)
    axes.set_ylabel("accuracy")
    axes.set_ylim(0, 1.04)
    legend_above(axes, 5)
    save(figure, folder, "experiments")


def plot_reliability(rows, folder):
    figure, (axes, counts) = plt.subplots(2, 1, figsize=(5, 6), constrained_layout=True, sharex=True,
                                          gridspec_kw={"height_ratios": [3, 1]})
    axes.plot([0, 1], [0, 1], color="grey", linestyle="--", linewidth=1)
    for method, (title, colour, marker) in METHODS.items():
        bins = [(float(row["mean_probability"]), int(row["right"]), int(row["answers"]))
                for row in rows if row["method"] == method and int(row["answers"]) > 0]
        if not bins:
            continue
        probability, right, answers = np.array(bins).T
        share = right / answers
        spread = 1.96 * np.sqrt(np.maximum(share * (1 - share), 0.25 / answers) / answers)
        axes.errorbar(probability, share, spread, color=colour, marker=marker, capsize=2, label=title)
        counts.plot(probability, answers, color=colour, marker=marker)
    axes.set_ylabel("share that is right")
    axes.set_ylim(-0.02, 1.02)
    axes.legend(fontsize=8)
    counts.set_xlabel("probability of the best match")
    counts.set_ylabel("answers")
    counts.set_yscale("log")
    save(figure, folder, "reliability")


def draw_panel(axes, panel):
    evidence = np.array(panel["evidence"])
    shade = np.where(evidence > 0, 0.0, np.where(evidence < 0, 1.0, 0.72))
    half = 0.5 * len(evidence) * panel["cell_size"]
    axes.imshow(shade, cmap="gray", vmin=0, vmax=1, origin="lower", interpolation="nearest",
                extent=(-half, half, -half, half))
    axes.plot(0, 0, marker="+", color="tab:blue")
    for x, y in panel["circled"]:
        axes.add_patch(plt.Circle((x, y), 0.55, fill=False, color="tab:red", linewidth=1.5))
    axes.set_title(textwrap.fill(panel["title"], 34), fontsize=9)
    axes.set_xticks([-4, -2, 0, 2, 4])
    axes.set_yticks([-4, -2, 0, 2, 4])
    axes.tick_params(labelsize=7)


def plot_grids(drawing, folder):
    panels = drawing["panels"]
    figure, grid = plt.subplots(1, len(panels), figsize=(3.4 * len(panels), 4.1), squeeze=False,
                                constrained_layout=True)
    for axes, panel in zip(grid[0], panels):
        draw_panel(axes, panel)
    figure.suptitle(textwrap.fill(drawing["caption"], 45 * len(panels)), fontsize=10)
    save(figure, folder, drawing["name"])


def plot_map(drawing, folder):
    x = np.array([place["x"] for place in drawing["places"]])
    y = np.array([place["y"] for place in drawing["places"]])
    wide, high = max(np.ptp(x), 1.0), max(np.ptp(y), 1.0)
    figure, axes = plt.subplots(figsize=(10, min(max(10 * high / wide, 2.5), 8)),
                                constrained_layout=True)
    for a, b in drawing["links"]:
        axes.plot(x[[a, b]], y[[a, b]], color="grey", linewidth=1, zorder=1)
    axes.scatter(x, y, s=230, color="white", edgecolor="black", zorder=2)
    for place in drawing["places"]:
        axes.text(place["x"], place["y"], place["label"], ha="center", va="center", fontsize=8)
    axes.set_aspect("equal")
    axes.set_xlim(x.min() - 1, x.max() + 1)
    axes.set_ylim(y.min() - 1, y.max() + 1)
    axes.set_xlabel("x [m]")
    axes.set_ylabel("y [m]")
    axes.set_title(drawing["caption"], fontsize=10)
    save(figure, folder, drawing["name"])


def main(results, images):
    os.makedirs(images, exist_ok=True)
    for name, plots in [("summary", [plot_experiments]), ("reliability", [plot_reliability]),
                        ("sweeps", [plot_chairs, plot_sweeps]),
                        ("rearrangements", [plot_rearrangements])]:
        path = os.path.join(results, name + ".csv")
        if not os.path.exists(path):
            continue
        rows = rows_of(path)
        for plot in plots:
            plot(rows, images)
    for path in sorted(glob.glob(os.path.join(results, "figures", "*.json"))):
        with open(path) as file:
            drawing = json.load(file)
        (plot_grids if "panels" in drawing else plot_map)(drawing, images)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
