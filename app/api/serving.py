"""Runs the application under uvicorn, shuts it down gracefully, and reloads rules, words, tables and characters when an
author saves them (`serve --reload`).

At the first SIGTERM or SIGINT the service refuses new work (503); running requests may finish within the grace period,
and are answered 503 after it. A second signal ends it at once. No process stays behind.

Requests that run while files are reloaded finish with the old ones. Files with mistakes are ignored: the old ones stay
in use, and the log and `/readyz` say why until the files are right.
"""

import asyncio
import gc
import logging
import os
import signal
import socket
from collections.abc import AsyncIterator, Callable, Iterator, Sequence
from contextlib import asynccontextmanager
from threading import Event
from types import FrameType
from typing import Any

import uvicorn
from fastapi import FastAPI

from ..authoring.watching import files_in_use, saves
from ..errors import UnderstudyError
from ..settings import Settings
from .connections import limited_protocol
from .service import Service
from .websockets import limited_websocket

_LOGGER = logging.getLogger(__name__)
_ANSWERS_LEAVE_WITHIN_S = 2


class Server(uvicorn.Server):
    """uvicorn's server, drained before it stops. `stopped_by` is the first signal."""

    def __init__(self, config: uvicorn.Config, app: FastAPI, grace_s: float, when_started: Callable[[], None]) -> None:
        super().__init__(config)
        self.stopped_by: int | None = None
        self._app = app
        self._grace_s = grace_s
        self._when_started = when_started
        self._draining: asyncio.Task[None] | None = None

    def handle_exit(self, sig: int, frame: FrameType | None) -> None:  # noqa: ARG002 - uvicorn's signature
        if self.stopped_by is not None:
            self.should_exit = self.force_exit = True
        self.stopped_by = self.stopped_by or sig

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        await super().startup(sockets)
        gc.collect()
        gc.freeze()  # collecting everything that stays would block the event loop for too long
        self._when_started()

    async def on_tick(self, counter: int) -> bool:
        if self.stopped_by is not None and self._draining is None:
            _LOGGER.info("stopping; running requests have %g s to finish", self._grace_s)
            self._draining = asyncio.create_task(self._drain())
        return await super().on_tick(counter)

    async def _drain(self) -> None:
        service = self._app.state.service
        service.streams.stop()
        await service.pool.stop(self._grace_s)
        self.should_exit = True


def serve(
    app: FastAPI,
    settings: Settings,
    sockets: Sequence[socket.socket],
    *,
    log_config: dict[str, Any],
    when_started: Callable[[], None],
) -> int:
    """Serves on listening sockets until a signal, which is returned."""
    server = Server(configuration(app, settings, log_config), app, settings.grace_s, when_started)
    server.run(list(sockets))
    return server.stopped_by or signal.SIGTERM


def configuration(app: FastAPI, settings: Settings, log_config: dict[str, Any]) -> uvicorn.Config:
    """uvicorn's. It would believe what anybody on this machine says of the caller's address (`X-Forwarded-For`), by
    which callers are told apart; here only whom `FORWARDED_ALLOW_IPS` names."""
    return uvicorn.Config(
        app,
        http=limited_protocol(settings),
        ws=limited_websocket(settings),
        ws_max_size=settings.part_limits["live"],
        ws_ping_interval=None,  # a client that sends ahead answers pings late; disconnects are polled for instead
        server_header=False,
        log_config=log_config,
        timeout_keep_alive=max(1, round(settings.idle_s)),
        timeout_graceful_shutdown=_ANSWERS_LEAVE_WITHIN_S,
        forwarded_allow_ips=os.environ.get("FORWARDED_ALLOW_IPS", ""),
    )


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
        _LOGGER.error("nothing reloaded; the previous data stay in use:\n%s", error.message)
        service.not_reloaded = error.message
        return
    await service.pool.replace_all()
    service.not_reloaded = None
    _LOGGER.info("rules, words, tables and characters reloaded")


async def _follow(service: Service, saved: Iterator[None]) -> None:
    while await asyncio.to_thread(next, saved, False) is None:
        await reload(service)
