"""`serve --reload`: rules, words, tables and characters are read again when an author saves them.

Requests under way keep what they began with. Files with mistakes change nothing: the service goes on with what it has,
the log says why, and so does `/readyz` until the files are right.
"""

import logging
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from threading import Event, Thread

from starlette.datastructures import State

from ..authoring.catalogue import Catalogue
from ..authoring.inspection import read_again
from ..authoring.watching import files_in_use, saves
from ..errors import UnderstudyError
from .service import Service

_LOGGER = logging.getLogger(__name__)


@contextmanager
def reloading(state: State) -> Iterator[None]:
    """Keeps `state.service` as the files say, in a thread of its own."""
    stop = Event()
    thread = Thread(target=_follow, args=(state, stop), name="reload")
    thread.start()
    try:
        yield
    finally:
        stop.set()
        thread.join()


def reloaded(service: Service) -> Service:
    """The service with the files as they are now; the old one, with the reason, when they have mistakes."""
    try:
        understudy = read_again(service.understudy)
        catalogue = Catalogue.of(
            understudy.language.rules,
            understudy.behavior.characters,
            understudy.behavior.rules,
            understudy.behavior.families,
        )
    except UnderstudyError as error:
        _LOGGER.error("nothing reloaded, what was loaded before stays:\n%s", error.message)
        return replace(service, not_reloaded=error.message)
    _LOGGER.info("rules, words, tables and characters reloaded")
    return replace(service, understudy=understudy, catalogue=catalogue, not_reloaded=None)


def _follow(state: State, stop: Event) -> None:
    for _ in saves(files_in_use(), stop):
        state.service = reloaded(state.service)
