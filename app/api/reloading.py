"""`serve --reload`: rules, words, tables and characters are reloaded when an author saves them.

Running requests finish with the old ones. Files with mistakes are ignored: the old ones stay in use, and the log and
`/readyz` say why until the files are right.
"""

import asyncio
import logging
from collections.abc import AsyncIterator, Iterator
from contextlib import asynccontextmanager
from threading import Event

from ..authoring.watching import files_in_use, saves
from ..errors import UnderstudyError
from .service import Service

_LOGGER = logging.getLogger(__name__)


@asynccontextmanager
async def reloading(service: Service) -> AsyncIterator[None]:
    """Reloads while the block runs; saves from its beginning on are noticed."""
    stop = Event()
    saved = await asyncio.to_thread(saves, files_in_use(), stop)
    following = asyncio.create_task(_follow(service, saved))
    try:
        yield
    finally:
        stop.set()
        await following


async def reload(service: Service) -> None:
    """Replaces the workers by new ones with the current files; if these have mistakes, keeps the old and logs why."""
    try:
        await asyncio.to_thread(service.pool.nursery.reload)
    except UnderstudyError as error:
        _LOGGER.error("nothing reloaded, what was loaded before stays:\n%s", error.message)
        service.not_reloaded = error.message
        return
    await service.pool.replace_all()
    service.not_reloaded = None
    _LOGGER.info("rules, words, tables and characters reloaded")


async def _follow(service: Service, saved: Iterator[None]) -> None:
    while await asyncio.to_thread(next, saved, False) is None:
        await reload(service)
