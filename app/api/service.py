"""What every request shares."""

from dataclasses import dataclass
from typing import Annotated

from fastapi import Depends, Request

from ..authoring.catalogue import Catalogue
from ..performance import Understudy
from ..settings import Settings
from .capacity import Capacity
from .metrics import Metrics


@dataclass(frozen=True, slots=True)
class Service:
    """Loaded once, when the application starts; with `--reload` another takes its place when files are saved.

    `not_reloaded` says why the files as they are now are not in use.
    """

    settings: Settings
    understudy: Understudy
    catalogue: Catalogue
    capacity: Capacity
    metrics: Metrics
    not_reloaded: str | None = None


def service_of(request: Request) -> Service:
    """The service of the application that got `request`."""
    service: Service = request.app.state.service
    return service


Shared = Annotated[Service, Depends(service_of)]
