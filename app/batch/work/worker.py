"""The functions that run in a worker, on this machine or another: one performs a line, one learns how a speaker usually
sounds from recordings of the batch itself. Models are loaded for the first line and kept.
"""

import gc
from collections.abc import Iterator
from functools import cache

from ...errors import InputError
from ...library.hearing import AcousticModels, analyze_signal, make_reference
from ...model import SignalAnalysis
from ...model.voice.signal import SpeakerReference
from ...models import Understudy
from ...settings import Settings
from ...version import __version__
from .jobs import LineJob, LineOutcome, ReferenceJob
from .performing import perform_job

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


def learn_reference(job: ReferenceJob, acoustic: AcousticModels) -> SpeakerReference | None:
    """The reference; recordings that cannot be analysed are left out (their own lines report why), None if none can."""
    heard = list(_heard(job, acoustic))
    return make_reference(acoustic, heard) if heard else None


def _heard(job: ReferenceJob, acoustic: AcousticModels) -> Iterator[SignalAnalysis]:
    for recording in job.recordings:
        try:
            yield analyze_signal(acoustic, recording.content())
        except InputError:
            continue


@cache
def _models(settings: Settings) -> Understudy:
    gc.set_threshold(FEWEST_NEW_OBJECTS)
    return Understudy.load(settings)
