"""Notices that authored files were saved, by looking at their times every so often.

No library and no system service: this also works in containers and on network folders, and some eighty files cost a
millisecond.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TypeAlias

LOOK_EVERY_S = 0.5
AUTHORED = frozenset({".rules", ".yaml", ".gesture"})

Stamps: TypeAlias = Mapping[Path, tuple[int, int]]
"""When each file was last written, in nanoseconds, and its bytes."""


def saves(paths: Sequence[Path], wait: Callable[[], bool]) -> Iterator[None]:
    """Yields whenever authored files among or in `paths` have changed, come or gone, and nobody is writing any more.

    `wait` waits until the next look; it returns False to end.
    """
    known = _stamps(paths)
    while wait():
        found = _stamps(paths)
        if found == known:
            continue
        while found != known:
            known = found
            if not wait():
                return
            found = _stamps(paths)
        yield


def _stamps(paths: Sequence[Path]) -> Stamps:
    stamps: dict[Path, tuple[int, int]] = {}
    for path in paths:
        for file in path.rglob("*") if path.is_dir() else (path,):
            if file.suffix in AUTHORED:
                try:
                    state = file.stat()
                except OSError:  # gone since it was listed
                    continue
                stamps[file] = state.st_mtime_ns, state.st_size
    return stamps
