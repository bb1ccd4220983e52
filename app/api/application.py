"""The service: one application that loads everything once and shares it between requests."""

from collections.abc import AsyncIterator
from contextlib import ExitStack, asynccontextmanager

from fastapi import FastAPI

from ..authoring.catalogue import Catalogue
from ..performance import Understudy
from ..settings import Settings
from ..version import __version__
from .admission.admission import Admission, guard
from .body_limit import BodyLimit
from .capacity import Capacity
from .description import page
from .description.document import describe
from .metrics import Measured, Metrics
from .problems import answer_errors_as_problems
from .reloading import reloading
from .routes import router
from .service import Service

DESCRIPTION = "Performs a spoken line in an actor's stead: audio and words in, a BML schedule of movements out."


def create_app(settings: Settings, understudy: Understudy | None = None, *, reload: bool = False) -> FastAPI:
    """The application. An `understudy` that is given stays its giver's to close; otherwise one is loaded when the
    application starts and closed when it stops. With `reload` what authors save is read again."""

    metrics = Metrics.fresh()

    @asynccontextmanager
    async def lifespan(app: FastAPI) -> AsyncIterator[None]:
        with ExitStack() as stack:
            loaded = understudy or stack.enter_context(Understudy.load(settings))
            capacity = Capacity(settings.max_concurrent)
            stack.callback(capacity.close)
            catalogue = Catalogue.of(
                loaded.language.rules, loaded.behavior.characters, loaded.behavior.rules, loaded.behavior.families
            )
            metrics.watch(lambda: capacity.busy)
            app.state.service = Service(settings, loaded, catalogue, capacity, metrics)
            if reload:
                stack.enter_context(reloading(app.state))
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
    app.add_middleware(BodyLimit, max_bytes=settings.max_body_bytes)
    app.include_router(router)
    app.include_router(page.router)
    answer_errors_as_problems(app)
    guard(app, Admission.of(settings))
    app.add_middleware(Measured, metrics=metrics)
    describe(app)
    return app
