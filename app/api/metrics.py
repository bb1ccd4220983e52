"""Prometheus metrics at `GET /metrics`: requests by path and status, durations, load.

Each application has its own registry, so that two in one process do not count each other's requests. Paths are those of
the routes; all others count as `other`.
"""

import time
from collections.abc import Callable
from dataclasses import dataclass
from http import HTTPStatus

from prometheus_client import CollectorRegistry, Counter, Gauge, Histogram
from prometheus_client.exposition import CONTENT_TYPE_LATEST, generate_latest
from starlette.types import ASGIApp, Message, Receive, Scope, Send

MEDIA_TYPE = CONTENT_TYPE_LATEST
BUCKETS_S = (0.01, 0.05, 0.1, 0.25, 0.5, 1.0, 2.5, 5.0, 10.0, 30.0, 60.0)
OTHER = "other"
LOST = "lost"
"""The `end` of a stream whose client left."""

_KEY_REFUSED = frozenset({str(HTTPStatus.UNAUTHORIZED.value)})


@dataclass(frozen=True, slots=True)
class Metrics:
    """The counters and gauges; `busy`, `waiting` and `streams` are read from the pool and the streams on demand."""

    registry: CollectorRegistry
    requests: Counter
    seconds: Histogram
    busy: Gauge
    waiting: Gauge
    streams: Gauge
    ended_streams: Counter
    refused_keys: Counter

    @classmethod
    def fresh(cls) -> "Metrics":
        registry = CollectorRegistry()
        labels = ("method", "path", "status")
        return cls(
            registry,
            Counter("understudy_requests", "Requests answered", labels, registry=registry),
            Histogram("understudy_request_seconds", "Time to answer", ("path",), buckets=BUCKETS_S, registry=registry),
            Gauge("understudy_lines_in_work", "Lines being performed now", registry=registry),
            Gauge("understudy_lines_waiting", "Lines waiting for a worker", registry=registry),
            Gauge("understudy_live_streams", "Live streams that are open now", registry=registry),
            Counter("understudy_live_streams_ended", "Live streams, by how they ended", ("end",), registry=registry),
            Counter("understudy_keys_refused", "Requests without a valid API key", registry=registry),
        )

    def watch(self, *, busy: Callable[[], float], waiting: Callable[[], float], streams: Callable[[], float]) -> None:
        """Sets the functions that the gauges read."""
        self.streams.set_function(streams)
        self.busy.set_function(busy)
        self.waiting.set_function(waiting)

    def text(self) -> bytes:
        """The figures in Prometheus' text form."""
        return generate_latest(self.registry)


class MetricsMiddleware:
    """ASGI middleware that counts and times every request."""

    def __init__(self, app: ASGIApp, metrics: Metrics) -> None:
        self._app = app
        self._metrics = metrics

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] == "websocket":
            await self._stream(scope, receive, send)
            return
        if scope["type"] != "http":
            await self._app(scope, receive, send)
            return
        begun_s, status = time.perf_counter(), "500"

        async def watched(message: Message) -> None:
            nonlocal status
            if message["type"] == "http.response.start":
                status = str(message["status"])
            await send(message)

        try:
            await self._app(scope, receive, watched)
        finally:
            path = getattr(scope.get("route"), "path", OTHER)
            self._count_key(status)
            self._metrics.requests.labels(scope["method"], path, status).inc()
            self._metrics.seconds.labels(path).observe(time.perf_counter() - begun_s)

    async def _stream(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Counts a WebSocket by the status with which it was refused, else the code with which it was closed."""
        end = LOST

        async def watched(message: Message) -> None:
            nonlocal end
            if message["type"] == "websocket.http.response.start":
                end = str(message["status"])
            elif message["type"] == "websocket.close":
                end = str(message.get("code", 1000))
            await send(message)

        try:
            await self._app(scope, receive, watched)
        finally:
            self._metrics.ended_streams.labels(end).inc()
            self._count_key(end)

    def _count_key(self, status: str) -> None:
        if status in _KEY_REFUSED:
            self._metrics.refused_keys.inc()
