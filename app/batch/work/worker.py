"""The functions that run in a worker, on this machine or another: models are loaded for its first line and kept."""

import gc
from functools import cache

from ...model.voice.signal import SpeakerReference
from ...models import Understudy
from ...settings import Settings
from ...version import __version__
from .jobs import LineJob, LineOutcome
from .performing import perform_job
from .speaking import ReferenceJob, learn_reference

FEWEST_NEW_OBJECTS = 50_000
"""Garbage collection threshold, as on the command line: models are many objects, and all stay."""


def perform_in_worker(job: LineJob, settings: Settings) -> LineOutcome:
    """The outcome of a job; raises as `perform_job` and the loading of models do."""
    return perform_job(job, _models(settings))


def learn_in_worker(job: ReferenceJob, settings: Settings) -> SpeakerReference | None:
    """The reference for a job's speaker; None if none of the recordings can be analysed."""
    return learn_reference(job, _models(settings).acoustic)


def version_in_worker() -> str:
    """The version of Understudy installed on the worker."""
    return __version__


@cache
def _models(settings: Settings) -> Understudy:
    gc.set_threshold(FEWEST_NEW_OBJECTS)
    return Understudy.load(settings)
