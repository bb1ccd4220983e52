"""What runs in a worker, on this machine or another: models are loaded at its first line and kept for all others."""

import gc
from functools import cache

from ...performance import SpeakerReference, Understudy
from ...settings import Settings
from ...version import __version__
from .jobs import LineJob, LineOutcome
from .performing import perform_job
from .speaking import ReferenceJob, learn_reference

FEWEST_NEW_OBJECTS = 50_000
"""Between two collections of garbage, as in a command: models are many objects, and all stay."""


def perform_in_worker(job: LineJob, settings: Settings) -> LineOutcome:
    """What comes of the job; raises as `perform_job` and the loading of models do."""
    return perform_job(job, _models(settings))


def learn_in_worker(job: ReferenceJob, settings: Settings) -> SpeakerReference | None:
    """How the speaker of a job usually sounds; None where none of his recordings can be heard."""
    return learn_reference(job, _models(settings).acoustic)


def version_in_worker() -> str:
    """The version that is installed where workers run."""
    return __version__


@cache
def _models(settings: Settings) -> Understudy:
    gc.set_threshold(FEWEST_NEW_OBJECTS)
    return Understudy.load(settings)
