"""The table of the demonstration that explores, on the terminal and as CSV."""
import csv
from dataclasses import astuple, dataclass, fields


@dataclass
class Stage:
    """A row of the table."""
    stage: str
    what: str
    seconds: float  # simulated
    metres: float   # driven
    error: float    # of where the robot, or each place, is on the map [m]


HEADING = f"{'the robot':<44} {'time':>8} {'way':>9} {'error':>8}  what happened"
LEGEND = """time: simulated. error: how far the robot is from where the map has it; after exploring, how far
  each place is from where it was made, the map laid onto the building as well as it goes."""


def row(stage):
    return (f"{stage.stage:<44} {stage.seconds:>6.0f} s {stage.metres:>7.1f} m "
            f"{stage.error:>6.2f} m  {stage.what}")


def write_csv(path, stages):
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow([field.name for field in fields(Stage)])
        for stage in stages:
            writer.writerow([value if isinstance(value, str) else f"{value:.3f}"
                             for value in astuple(stage)])
