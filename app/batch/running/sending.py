"""Jobs for workers that see other files: with the recordings in them, and to be answered with the outputs."""

from concurrent.futures import Future
from dataclasses import replace

from ...errors import InputError
from ..work.jobs import Failure, LineJob, LineOutcome
from ..work.speaking import ReferenceJob


def sent(job: LineJob) -> LineJob:
    """Raises InputError when the recording cannot be read."""
    return replace(job, audio=job.audio.to_send(), folder=None)


def voice_sent(job: ReferenceJob) -> ReferenceJob:
    """Recordings that cannot be read are left out; their own lines tell why."""
    found = []
    for recording in job.recordings:
        try:
            found.append(recording.to_send())
        except InputError:
            continue
    return replace(job, recordings=tuple(found))


def failed_to_send(job: LineJob, error: InputError) -> "Future[LineOutcome]":
    """The outcome of a line whose recording cannot be read."""
    done: Future[LineOutcome] = Future()
    done.set_result(LineOutcome(job.id, 0.0, failure=Failure.of(error)))
    return done
