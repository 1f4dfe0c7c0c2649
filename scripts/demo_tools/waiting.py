"""Waiting for what other processes do, never longer than a limit of real time."""
import time

from demo_tools.errors import DemoError

POLL = 0.02  # [s]


def wait_until(condition, what, limit, check=lambda: None):
    """Returns the first true value of condition().

    `check` raises where waiting has become pointless. DemoError naming `what` after `limit` seconds.
    """
    end = time.monotonic() + limit
    while True:
        value = condition()
        if value:
            return value
        check()
        if time.monotonic() > end:
            raise DemoError(f"{what}: not within {limit:.0f} s")
        time.sleep(POLL)
