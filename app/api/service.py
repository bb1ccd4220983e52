"""What every request shares."""

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

from fastapi import Depends, Request

from ..settings import Settings
from .clients import Rates
from .metrics import Metrics
from .uploads import Uploads
from .workers.pool import Pool
from .workers.streams import Streams


@dataclass(slots=True)
class Service:
    """Made when the application starts. `not_reloaded` says why the files as they are now are not in use
    (`--reload`). Edited rules are saved in `rules_folder`; without one, nowhere."""

    settings: Settings
    pool: Pool
    streams: Streams
    uploads: Uploads
    rates: Rates
    metrics: Metrics
    not_reloaded: str | None = None
    rules_folder: Path | None = None


def service_of(request: Request) -> Service:
    """The service of the application that got `request`."""
    service: Service = request.app.state.service
    return service


Shared = Annotated[Service, Depends(service_of)]
