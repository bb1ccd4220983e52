"""Waits for authored files to be saved, by the operating system's notifications (watchfiles).

Where there are none, as on network folders and in some containers, WATCHFILES_FORCE_POLLING=true makes it poll instead.
"""

from collections.abc import Iterable, Iterator
from itertools import chain
from pathlib import Path
from threading import Event

from watchfiles import watch

from ..authored_folders import AUTHORED, layers, lexicon_folder, rules_folder
from ..files import RULES

QUIET_MS = 200
"""A save is complete when nothing has changed for this long: editors write in steps."""

LONGEST_SAVE_MS = 5_000


def files_in_use() -> tuple[Path, ...]:
    """The folders of authored files, the author's own among them."""
    return rules_folder(RULES), lexicon_folder(), *layers()


def saves(paths: Iterable[Path], stop: Event | None = None) -> Iterator[None]:
    """Yields whenever authored files among or in `paths` have been changed, added or removed and writing is over, until
    `stop` is set. Watching begins before this returns.

    A file is watched through its folder, because many editors save by replacing it. Paths whose folder does not exist
    are ignored.
    """
    watched = [path.resolve() for path in paths]
    folders = {path if path.is_dir() else path.parent for path in watched}

    def is_ours(_change: object, name: str) -> bool:
        changed = Path(name)
        inside = any(changed == path or path in changed.parents for path in watched)
        return inside and changed.suffix in AUTHORED

    existing = [folder for folder in folders if folder.is_dir()]
    if not existing:
        return iter(())
    changes = watch(
        *existing,
        watch_filter=is_ours,
        step=QUIET_MS,
        debounce=LONGEST_SAVE_MS,
        stop_event=stop,
        rust_timeout=QUIET_MS,
        yield_on_timeout=True,
    )
    first = next(changes, set())  # it watches from when it is first asked
    return (None for changed in chain([first], changes) if changed)
