"""The API keys as they are now: their file is read again when it changes, so that no restart is needed to replace one.

A file that cannot be used changes nothing: the keys that were read before stay in use, and the log says why.
"""

import logging
import time
from collections.abc import Callable

from ...errors import InputError
from ...settings import Settings
from .keys import ApiKeys

LOOK_EVERY_S = 1.0

_LOGGER = logging.getLogger(__name__)


class KeyRing:
    """The keys of the settings and of their file."""

    def __init__(self, settings: Settings, clock: Callable[[], float] = time.monotonic) -> None:
        """Raises InputError `setting_wrong`."""
        self._settings, self._clock = settings, clock
        self._changed = self._stamp()
        self._keys = ApiKeys.of(settings)
        self._looked_s = clock()

    @property
    def current(self) -> ApiKeys:
        """The keys that are in use; those that have expired are among them, and let nobody in."""
        if self._clock() - self._looked_s >= LOOK_EVERY_S:
            self._looked_s = self._clock()
            self._look()
        return self._keys

    def _look(self) -> None:
        changed = self._stamp()
        if changed == self._changed:
            return
        self._changed = changed
        try:
            self._keys = ApiKeys.of(self._settings)
        except InputError as error:
            _LOGGER.error("%s; the keys that were there before stay in use", error.message)
        else:
            _LOGGER.info("API keys read again; there are %d", len(self._keys.keys))

    def _stamp(self) -> tuple[int, ...]:
        """What tells one state of the file from another; links, as of Kubernetes' secrets, are followed."""
        try:
            found = self._settings.api_keys_file.stat() if self._settings.api_keys_file else None
        except OSError:  # told by whoever reads it
            return ()
        return () if found is None else (found.st_mtime_ns, found.st_size, found.st_ino)
