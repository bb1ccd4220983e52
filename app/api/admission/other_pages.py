"""Pages of other origins that are allowed: browsers are told that these may read the service's answers (CORS)."""

from collections.abc import Sequence

from fastapi import FastAPI
from starlette.middleware.cors import CORSMiddleware

_TAKEN = ("Accept", "Authorization", "Content-Type", "X-Request-ID")
_SHOWN = ("Retry-After", "Understudy-Warnings", "X-Request-ID")
_REMEMBERED_S = 600


def let_in_pages(app: FastAPI, origins: Sequence[str]) -> None:
    """Outside of everything else, for browsers ask first, without a key."""
    app.add_middleware(
        CORSMiddleware,
        allow_origins=list(origins),
        allow_methods=("GET", "POST"),
        allow_headers=_TAKEN,
        expose_headers=_SHOWN,
        max_age=_REMEMBERED_S,
    )
