"""Changes of the map that undo what others did: a load, an undo."""

import contextlib
import threading


class Upheavals:
    """Thread-safe."""

    def __init__(self):
        self._lock = threading.Lock()
        self._under_way = 0
        self._ended = 0

    @contextlib.contextmanager
    def one(self):
        with self._lock:
            self._under_way += 1
        try:
            yield
        finally:
            with self._lock:
                self._under_way -= 1
                self._ended += 1

    def epoch(self):
        """Differs before and after an upheaval; None while there is one."""
        with self._lock:
            return None if self._under_way else self._ended
