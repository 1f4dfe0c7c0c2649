"""The processes beside the demonstration: roslaunch, and Xvfb where there is no display."""
import os
import signal
import subprocess
import tempfile

from demo_tools.errors import DemoError
from demo_tools.waiting import wait_until

STOP_LIMIT = 20.0  # [s]


class Process:
    """A child in a process group of its own, which is gone when the context is left."""

    def __init__(self, command, log, **options):
        self._name = os.path.basename(command[0])
        self._log = log
        with open(log, "w", encoding="utf-8") as output:
            self._child = subprocess.Popen(command, stdout=output, stderr=subprocess.STDOUT,
                                           start_new_session=True, **options)

    def check(self):
        """DemoError, with the end of its log, if the process has ended."""
        status = self._child.poll()
        if status is not None:
            with open(self._log, encoding="utf-8", errors="replace") as log:
                tail = "".join(log.readlines()[-15:])
            raise DemoError(f"{self._name} ended with status {status}; {self._log} ends with\n{tail}")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for how in (signal.SIGINT, signal.SIGTERM, signal.SIGKILL):
            if self._child.poll() is not None:
                return
            os.killpg(self._child.pid, how)
            try:
                self._child.wait(STOP_LIMIT)
            except subprocess.TimeoutExpired:
                pass


class VirtualDisplay(Process):
    """An X server that draws into memory, on a free display."""

    def __init__(self, folder, width, height):
        with tempfile.TemporaryFile("w+") as number:
            descriptor = number.fileno()
            super().__init__(["Xvfb", "-displayfd", str(descriptor), "-screen", "0",
                              f"{width}x{height}x24", "-nolisten", "tcp"],
                             os.path.join(folder, "xvfb.log"), pass_fds=[descriptor])

            def written():
                number.seek(0)
                text = number.read()
                return text.strip() if text.endswith("\n") else None

            self.display = ":" + wait_until(written, "the virtual display", 30.0, self.check)
