"""The ASGI application: it reads requests and passes them to worker processes."""

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager, nullcontext
from pathlib import Path

from fastapi import FastAPI

from ..settings import Settings
from ..studio.pages import OpenedLine, page_router
from ..studio.scenes import OpenedScene
from ..version import __version__
from . import authoring
from .admission.access import Admission, guard
from .admission.headers import let_in_pages
from .admission.rates import Rates
from .bodies import Uploads
from .description import page
from .description.document import PATHS, describe
from .live import router as live_router
from .metrics import Metrics, MetricsMiddleware
from .problems import answer_errors_as_problems
from .routes import router
from .service import Service
from .serving import reloading
from .workers.pool import Pool
from .workers.processes import Nursery
from .workers.streams import Streams

DESCRIPTION = "Performs a spoken line in an actor's stead: audio and words in, a BML schedule of movements out."


def create_app(
    settings: Settings,
    nursery: Nursery,
    *,
    reload: bool = False,
    opened: OpenedLine | OpenedScene | None = None,
    author_folder: Path | None = None,
) -> FastAPI:
    """The application. The caller closes the nursery. With `reload`, files are reloaded when authors save them;
    `opened` is what the studio page opens; rules edited there are saved in `author_folder`, by callers on this machine
    only."""
    metrics = Metrics.fresh()

    @asynccontextmanager
    async def lifespan(app: FastAPI) -> AsyncIterator[None]:
        shared = _service(settings, nursery, metrics, author_folder)
        async with shared as service, reloading(service) if reload else nullcontext():
            app.state.service = service
            yield

    app = FastAPI(
        title="Understudy",
        description=DESCRIPTION,
        version=__version__,
        lifespan=lifespan,
        redirect_slashes=False,
        docs_url=None,
        redoc_url=None,
    )
    for each in (router, authoring.router, live_router, page.router, page_router(opened)):
        app.include_router(each)
    answer_errors_as_problems(app, PATHS)
    guard(app, Admission.of(settings))
    app.add_middleware(MetricsMiddleware, metrics=metrics)
    if settings.origins:
        let_in_pages(app, settings.origins)
    describe(app)
    return app


@asynccontextmanager
async def _service(
    settings: Settings, nursery: Nursery, metrics: Metrics, author_folder: Path | None
) -> AsyncIterator[Service]:
    """The shared state of all requests, for the life of the application."""
    async with Pool(nursery, settings) as pool:
        streams, uploads, rates = Streams(pool, settings), Uploads(settings), Rates(settings.rate_per_minute)
        metrics.watch(busy=lambda: pool.busy, waiting=lambda: pool.waiting, streams=lambda: streams.count)
        try:
            yield Service(settings, pool, streams, uploads, rates, metrics, author_folder=author_folder)
        finally:
            streams.stop()
