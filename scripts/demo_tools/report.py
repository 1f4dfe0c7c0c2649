"""The table of the demonstration, on the terminal and as CSV."""
import csv
import math
import textwrap

FEET = 1.0 / 0.3048


def number(value, form):
    return "-" if math.isnan(value) else form.format(value)


def answer_cells(answer):
    return (f"{answer.label:>5} {'yes' if answer.is_right else 'NO':>5} {answer.verdict:>10} "
            f"{answer.probability:>5.2f} {number(answer.error, '{:.2f}'):>6} {answer.match_ms:>6.1f}")


def heading(methods):
    titles = "".join(f" | {method:^42}" for method in methods)
    columns = "".join(f" | {'match':>5} {'right':>5} {'verdict':>10} {'prob.':>5} {'err[m]':>6} "
                      f"{'ms':>6}" for _ in methods)
    return f"{'':>5} {'compass':>8}{titles}\n{'place':>5} {'deg':>8}{columns}"


def legend(confidence, equally_near):
    """How the table is to be read, for a memory with that confidence; `equally_near` in metres."""
    sentences = [
        "place: the one two feet beside which the robot stood.",
        f"right: the match is the place nearest to the robot, or one that is less than "
        f"{equally_near:.2f} m further off; halfway between two places either of them is right.",
        f"verdict: recognized where the probability of the match is at least {confidence:g} "
        f"(match/confidence). A right match is ambiguous where another place fits nearly as well, and "
        f"unknown where so little of the scan agrees with the place, as after doors and chairs were "
        f"moved, that the robot may be at none of them."]
    return "\n".join(textwrap.fill(text, 100, subsequent_indent="  ") for text in sentences)


def row(trial, learned):
    turned = math.degrees(trial.compass_error - learned.compass_error)
    answers = "".join(f" | {answer_cells(answer)}" for answer in trial.answers.values())
    return f"{trial.label:>5} {turned:>+8.1f}{answers}"


def mean(values):
    return sum(values) / len(values) if values else math.nan


def total(method, trials):
    answers = [trial.answers[method] for trial in trials]
    right = [answer for answer in answers if answer.is_right]
    sure = [answer for answer in answers if answer.verdict == "recognized"]
    error = mean([answer.error for answer in right])
    return (f"{method}: {len(right)} of {len(answers)} places right "
            f"({100.0 * len(right) / len(answers):.0f} %), "
            f"{len(sure)} called recognized, {sum(not answer.is_right for answer in sure)} of them "
            "wrong, "
            f"mean position error {number(error, '{:.2f}')} m "
            f"({number(error * FEET, '{:.1f}')} ft), "
            f"mean match time {mean([answer.match_ms for answer in answers]):.1f} ms")


def write_csv(path, trials, learned):
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(["place", "true_x", "true_y", "compass_change", "method", "match", "right",
                         "verdict", "probability", "position_error", "match_ms"])
        for trial in trials:
            turned = trial.compass_error - learned[trial.label].compass_error
            for method, answer in trial.answers.items():
                writer.writerow([trial.label, f"{trial.pose[0]:.3f}", f"{trial.pose[1]:.3f}",
                                 f"{turned:.4f}", method, answer.label,
                                 int(answer.is_right), answer.verdict,
                                 f"{answer.probability:.4f}",
                                 "" if math.isnan(answer.error) else f"{answer.error:.3f}",
                                 f"{answer.match_ms:.2f}"])
