"""A picture of every learned grid beside the grid of the scan that came later."""
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

PAIRS_A_ROW = 4
BLACK, GREY, WHITE = 0.0, 0.62, 1.0
RIGHT, WRONG = "#137333", "#c5221f"


def shades(grid, prior=50):
    """Black occupied, white empty, grey unsensed; north up."""
    cells = np.array(grid.data, dtype=int).reshape(grid.info.height, grid.info.width)
    picture = np.full(cells.shape, GREY)
    picture[cells > prior] = BLACK
    picture[(cells >= 0) & (cells < prior)] = WHITE
    return picture[::-1]


def draw_grid(axes, grid, title):
    axes.imshow(shades(grid), cmap="gray", vmin=0.0, vmax=1.0, interpolation="nearest")
    axes.set_title(title, fontsize=11, pad=3)
    axes.set_xticks([])
    axes.set_yticks([])


def mark(answer):
    return "✓" if answer.is_right else "✗"


def draw_answers(axes, answers):
    for line, (method, answer) in enumerate(answers.items()):
        axes.text(0.0, -0.05 - 0.13 * line, f"{method}: {answer.label} {mark(answer)} {answer.verdict}",
                  transform=axes.transAxes, va="top", fontsize=10,
                  color=RIGHT if answer.is_right else WRONG)


def write_contact_sheet(path, learned, trials, title):
    """`learned` by label; one pair of grids for each trial, in the order of the places."""
    rows = -(-len(trials) // PAIRS_A_ROW)
    figure = plt.figure(figsize=(4.1 * PAIRS_A_ROW, 2.75 * rows + 1.0))
    outer = figure.add_gridspec(rows, PAIRS_A_ROW, wspace=0.08, hspace=0.12, left=0.015,
                                right=0.985, bottom=0.02, top=1.0 - 0.75 / (2.75 * rows + 1.0))
    figure.suptitle(title, fontsize=14, y=1.0 - 0.15 / (2.75 * rows + 1.0))
    for index, trial in enumerate(trials):
        pair = outer[index // PAIRS_A_ROW, index % PAIRS_A_ROW].subgridspec(1, 2, wspace=0.04)
        left, right = figure.add_subplot(pair[0]), figure.add_subplot(pair[1])
        draw_grid(left, learned[trial.label].grid, f"place {trial.label}, learned")
        draw_grid(right, trial.grid, "two feet off, later")
        draw_answers(right, trial.answers)
    figure.savefig(path, dpi=100)
    plt.close(figure)
