"""The report of a run: a text, and pictures of memory, latencies and error."""

import os

from soak_tools.watch import LONG_LIFE, WARM_UP, quantile


def summary(watch):
    lines = ["%-18s %8s %8s %8s %8s" % ("call", "number", "p50 ms", "p99 ms", "max ms")]
    for name, took in sorted(watch.latencies.items()):
        seconds = [entry[1] for entry in took]
        lines.append("%-18s %8d %8.1f %8.1f %8.1f" % (
            name, len(seconds), 1e3 * quantile(seconds, 0.5), 1e3 * quantile(seconds, 0.99),
            1e3 * max(seconds)))
    errors = [entry[1] for entry in watch.errors()]
    half = len(errors) // 2
    lines += [
        "",
        "ran %.1f minutes, %d faults, node started %d times, up to %d places" % (
            watch.now() / 60.0, watch.counts["faults"],
            max([entry[1] for entry in watch.memory], default=0),
            max([entry[3] for entry in watch.memory], default=0)),
        "tf map -> odom: %d, pauses p99 %.2f s, longest %.2f s" % (
            len(watch.pauses), quantile(watch.pauses, 0.99), max(watch.pauses, default=0.0)),
        "~pose: %d, error p50 %.3f m, p99 %.3f m; p50 of the first half %.3f m, of the second %.3f m" % (
            len(errors), quantile(errors, 0.5), quantile(errors, 0.99),
            quantile(errors[:half], 0.5), quantile(errors[half:], 0.5)),
    ]
    growths = watch.growths()
    for seconds, grown in growths:
        lines.append("memory beyond the places learned: %+.2f MB in %.0f s" % (grown / 1e6, seconds))
    if not growths:
        lines.append("memory was not compared: no start of the node lived for %.0f s" %
                     (WARM_UP + LONG_LIFE))
    lines += ["%s: %d" % entry for entry in sorted(watch.counts.items())]
    lines += ["", "%d problems" % len(watch.problems)] + watch.problems[:50]
    return "\n".join(lines) + "\n"


def draw(watch, path):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    figure, (memory, latency, error) = plt.subplots(3, 1, figsize=(9, 10), sharex=True,
                                                    constrained_layout=True)
    when = [entry[0] / 60.0 for entry in watch.memory]
    memory.plot(when, [entry[2] / 1e6 for entry in watch.memory], color="tab:blue")
    memory.set_ylabel("memory of the node [MB]")
    places = memory.twinx()
    places.plot(when, [entry[3] for entry in watch.memory], color="tab:orange")
    places.set_ylabel("places", color="tab:orange")
    for name, took in sorted(watch.latencies.items()):
        latency.plot([entry[0] / 60.0 for entry in took], [1e3 * entry[1] for entry in took], ".",
                     markersize=2, label=name)
    latency.set_yscale("log")
    latency.set_ylabel("answered after [ms]")
    latency.legend(fontsize=7, markerscale=4)
    errors = watch.errors()
    error.plot([entry[0] / 60.0 for entry in errors], [entry[1] for entry in errors], ".",
               markersize=2)
    error.set_yscale("log")
    error.set_ylabel("error of ~pose [m]")
    error.set_xlabel("minutes")
    figure.savefig(path, dpi=80)


def write(watch, folder, with_pictures):
    text = summary(watch)
    with open(os.path.join(folder, "report.txt"), "w") as file:
        file.write(text)
    if with_pictures:
        draw(watch, os.path.join(folder, "soak.png"))
    return text
