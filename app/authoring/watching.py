"""Notices that authored files were saved; watchfiles tells, by the system's own notifications.

Where there are none, as on network folders and in some containers, WATCHFILES_FORCE_POLLING=true has it look instead.
"""

from collections.abc import Iterable, Iterator
from pathlib import Path
from threading import Event

from watchfiles import watch

from ..loading import AUTHORED
from ..resources import RULES, resource_folder

QUIET_MS = 200
"""A save is over when nothing has changed for so long: editors write in steps."""

LONGEST_SAVE_MS = 5_000


def files_in_use() -> tuple[Path, ...]:
    """The folders of what authors edit."""
    return RULES, resource_folder("lexicon")


def saves(paths: Iterable[Path], stop: Event | None = None) -> Iterator[None]:
    """Yields whenever authored files among or in `paths` have changed, come or gone, and nobody is writing any more,
    until `stop` is set.

    A file is watched by way of its folder, for many editors save by putting another in its place; nothing tells of a
    path whose folder is not there.
    """
    watched = [path.resolve() for path in paths]
    folders = {path if path.is_dir() else path.parent for path in watched}

    def is_ours(_change: object, name: str) -> bool:
        changed = Path(name)
        inside = any(changed == path or path in changed.parents for path in watched)
        return inside and changed.suffix in AUTHORED

    existing = [folder for folder in folders if folder.is_dir()]
    if not existing:
        return
    for _ in watch(*existing, watch_filter=is_ours, step=QUIET_MS, debounce=LONGEST_SAVE_MS, stop_event=stop):
        yield
