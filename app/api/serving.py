"""Runs the application under uvicorn until it is told to stop, and then ends in order.

At the first SIGTERM or SIGINT the service takes no more work (503) but still answers; what runs is finished within the
time of grace, what is not by then is answered 503. A second signal ends it at once. Nothing stays behind.
"""

import asyncio
import gc
import logging
import signal
import socket
from collections.abc import Callable, Sequence
from types import FrameType
from typing import Any

import uvicorn
from fastapi import FastAPI

from ..settings import Settings
from .connections import limited_protocol
from .websockets import limited_websocket

_LOGGER = logging.getLogger(__name__)
_ANSWERS_LEAVE_WITHIN_S = 2


class Server(uvicorn.Server):
    """uvicorn's server, which is drained before it stops. `stopped_by` is the signal that came first."""

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
        gc.freeze()  # to look through all that stays takes so long that nobody is answered meanwhile
        self._when_started()

    async def on_tick(self, counter: int) -> bool:
        if self.stopped_by is not None and self._draining is None:
            _LOGGER.info("stopping; what runs may go on for %g s", self._grace_s)
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
    """Serves on sockets that listen until a signal comes, and returns which."""
    config = uvicorn.Config(
        app,
        http=limited_protocol(settings),
        ws=limited_websocket(settings),
        ws_max_size=settings.part_limits["live"],
        ws_ping_interval=None,  # a client that sends ahead answers late, and those that are gone are noticed without
        server_header=False,
        log_config=log_config,
        timeout_keep_alive=max(1, round(settings.idle_s)),
        timeout_graceful_shutdown=_ANSWERS_LEAVE_WITHIN_S,
    )
    server = Server(config, app, settings.grace_s, when_started)
    server.run(list(sockets))
    return server.stopped_by or signal.SIGTERM
