"""The service as it is in `understudy serve`, over sockets, but in a thread of the tests: for what clients can do
below HTTP and WebSocket."""

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import uvicorn
from fastapi import FastAPI

from understudy.api.application import create_app
from understudy.api.connections import limited_protocol
from understudy.api.service import Service
from understudy.api.websockets import limited_websocket
from understudy.api.workers.processes import Nursery
from understudy.settings import Settings

HOST = "127.0.0.1"


@dataclass(frozen=True, slots=True)
class Served:
    """A service that runs, and its port."""

    app: FastAPI
    port: int

    @property
    def url(self) -> str:
        return f"http://{HOST}:{self.port}"

    @property
    def service(self) -> Service:
        service: Service = self.app.state.service
        return service


@contextmanager
def served(
    nursery: Nursery,
    author_folder: Path | None = None,
    **settings: Any,  # noqa: ANN401
) -> Iterator[Served]:
    """The service with these settings, and otherwise one worker."""
    whole = Settings(**({"workers": 1} | settings))
    app = create_app(whole, nursery, author_folder=author_folder)
    config = uvicorn.Config(
        app,
        host=HOST,
        port=0,
        log_config=None,
        http=limited_protocol(whole),
        ws=limited_websocket(whole),
        ws_max_size=whole.part_limits["live"],
        ws_ping_interval=None,
        timeout_graceful_shutdown=1,
    )
    server = uvicorn.Server(config)
    thread = threading.Thread(target=server.run)
    thread.start()
    while not server.started:
        thread.join(0.02)
    try:
        yield Served(app, server.servers[0].sockets[0].getsockname()[1])
    finally:
        server.should_exit = True
        thread.join()
